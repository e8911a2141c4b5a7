// A vector display for a demo: memory, the processor that runs what is in it, and the tube.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "demos/demo.h"
#include "display/vector/assembler.h"
#include "display/vector/display_processor.h"
#include "display/vector/vector_tube.h"

namespace kinescope {

/// Copies have memory of their own.
class VectorMonitor {
 public:
  VectorMonitor(const VectorMachine& machine, int width, int height);
  VectorMonitor(const VectorMonitor& other);
  VectorMonitor& operator=(const VectorMonitor&) = delete;

  const VectorMachine& machine() const { return *machine_; }
  std::size_t state_bytes() const;
  void resize(int width, int height);
  /// Another phosphor: a new tube, dark.
  void coat(std::string_view phosphor);

  /// How far the camera's iris is open: 1 shows a white line as white. Above 1, what is too bright
  /// for its colour goes towards white, as film does and eyes do, so that its luminance is seen.
  void open_iris(double gain) { gain_ = gain; }

  /// Assembles a program of the demo's own, loads it and starts it.
  DisplayFile load(std::string_view text);
  /// Changes one instruction while it is displayed. @return the address that follows it
  Address write(Address at, std::string_view name, std::initializer_list<std::int64_t> operands);
  /// A list that is shown once the present one is through. @throws Error (bad input) if it does not
  /// fit the memory
  void put(Address at, std::span<const Word> words) {
    memory_.load(at, words);
    show(at);
  }
  /// The list that is shown once this one is through.
  void show(Address address) { processor_->show(address); }
  /// The text of the instruction there.
  std::string text_at(Address address) const;

  /// Held against the screen during the following exposures; hits() are those of the last one. The
  /// program answers a hit within so long.
  void hold_pen(const std::optional<BeamPen>& pen) { pen_ = pen; }
  static constexpr Seconds kAnswer = microseconds(100);
  const std::vector<BeamPenHit>& hits() const { return hits_; }

  /// Lets the program run, and draws the light of the step, divided by the exposure's length in
  /// sixtieths of a second, but at least by a 64th.
  void expose(const Step& step, Workers& workers, Image<Srgb8>& picture);
  /// How often the list began in the last exposure.
  std::int64_t refreshes() const { return refreshes_; }
  /// How long a refresh of the list that is now in memory takes, as a run of it tells.
  Seconds period() const;

  glm::dvec2 place(int x, int y) const;       ///< device units of a pixel
  glm::vec2 pixel(double x, double y) const;  ///< and the other way
  double pixels_a_unit() const { return scale_; }

 private:
  void run(Seconds end);

  std::shared_ptr<const VectorMachine> machine_;
  DisplayMemory memory_;
  std::optional<DisplayProcessor> processor_;
  VectorTube tube_;
  int width_, height_;
  double scale_;
  std::optional<BeamPen> pen_;
  std::vector<BeamPenHit> hits_;
  std::vector<BeamMove> moves_;
  std::int64_t refreshes_ = 0;
  Address start_ = 0;
  double gain_ = 1;
  Image<LinearRgb> exposed_;  // with an open iris; nothing in it outlives an exposure
};

/// The generic machine with less memory, so that copies are cheap.
VectorMachine demo_machine(std::string_view phosphor);

}  // namespace kinescope
