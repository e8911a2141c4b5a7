// A Tektronix terminal or a plotter on a pseudo-terminal.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "display/vector/input/drawing.h"
#include "display/vector/input/pseudo_terminal.h"
#include "display/vector/input/read_vectors.h"
#include "display/vector/input/tek_reader.h"

namespace kinescope {

/// What its screen shows: only what came after the last erasure is kept.
class VectorTerminal {
 public:
  /// Takes the page as it stood when a program asked for a copy of it.
  using Copier = std::function<void(const VectorDrawing& page)>;

  /// @param kind Tektronix, or what is read as a whole (HP-GL, SVG, WAV); none: by what comes
  /// first, and by what comes first after all who had it open have left
  explicit VectorTerminal(std::optional<VectorKind> kind) : asked_(kind), kind_(kind) {}

  const std::string& name() const { return device_.name(); }
  /// Takes what has arrived, waiting at most that long, and answers it. @return whether the screen
  /// has changed
  bool poll(int milliseconds, const Copier& copier);
  /// A key, with the crosshair at a place in device units.
  void press(char key, int x, int y);
  /// The key PAGE; of a plotter: a new sheet.
  void page();

  bool finished() const { return device_.finished(); }
  /// Whether it is a Tektronix terminal, whose screen stores.
  bool stores() const { return kind_.value_or(VectorKind::kTek) == VectorKind::kTek; }
  bool crosshair_shown() const { return stores() && reader_.crosshair_shown(); }
  const VectorDrawing& drawing() const { return drawing_; }
  /// Of a terminal that stores: what the last change brought, with its events.
  const VectorDrawing& news() const { return news_; }

 private:
  void recognise(std::span<const std::uint8_t> bytes);
  void draw(std::span<const std::uint8_t> bytes, const Copier& copier);
  void copy(const Copier& copier) const;
  void read_whole();

  PseudoTerminal device_;
  std::optional<VectorKind> asked_, kind_;
  TekReader reader_;
  VectorDrawing drawing_, news_;
  std::vector<std::uint8_t> whole_;  ///< of what is read as a whole: all its bytes
  bool left_ = false;                ///< by all who had it open
};

}  // namespace kinescope
