// A Tektronix terminal or a plotter on a pseudo-terminal.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "display/vector/input/drawing.h"
#include "display/vector/input/pseudo_terminal.h"
#include "display/vector/input/read_vectors.h"
#include "display/vector/input/tek_reader.h"

namespace kinescope {

/// What its screen shows: only what came after the last erasure is kept.
class VectorTerminal {
 public:
  /// @param kind Tektronix or HP-GL; none: by what comes first
  explicit VectorTerminal(std::optional<VectorKind> kind) : kind_(kind) {}

  const std::string& name() const { return device_.name(); }
  /// Takes what has arrived, waiting at most that long, and answers it. @return whether the screen
  /// has changed
  bool poll(int milliseconds);
  /// A key, with the crosshair at a place in device units.
  void press(char key, int x, int y);

  bool finished() const { return device_.finished(); }
  bool crosshair_shown() const { return reader_.crosshair_shown(); }
  const VectorDrawing& drawing() const { return drawing_; }

 private:
  void plot();

  PseudoTerminal device_;
  std::optional<VectorKind> kind_;
  TekReader reader_;
  VectorDrawing drawing_;
  std::vector<std::uint8_t> bytes_;  ///< new ones; of a plot, all
};

}  // namespace kinescope
