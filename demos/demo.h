// A demo: a small world with knobs that moves in steps of simulated time and draws itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "demos/knob.h"
#include "demos/studio.h"
#include "display/exposure.h"
#include "display/input.h"
#include "raster/base/units.h"
#include "raster/image/image.h"

namespace kinescope {

/// All that reaches a demo in one step. A demo's course is a function of its setup and its steps.
struct Step {
  Exposure exposure;               ///< simulated time of the picture; begins where the last ended
  std::vector<InputEvent> events;  ///< mouse places in pixels of the picture
};

struct DemoSetup {
  std::shared_ptr<Studio> studio;
  int width = 1280, height = 960;  ///< of the picture, pixels
  std::uint64_t seed = 1;          ///< of every random number
  bool portrait = false;  ///< a small picture of it is wanted: what must be read is left out
};

/// Copies (clones) are snapshots: all state lies in the object, shared parts never change.
class Demo {
 public:
  virtual ~Demo();
  virtual std::unique_ptr<Demo> clone() const = 0;
  /// Memory that a clone costs, bytes, for the player's budget.
  virtual std::size_t state_bytes() const = 0;
  /// How often its display shows a whole picture.
  virtual Rate refresh() const { return Rate{60, 1}; }

  /// Whether the last step left the picture as it was. A copy's first step does not.
  virtual bool still() const { return false; }

  /// Turns knobs, resizes, updates and draws: one step.
  /// @param picture resized to the demo's size where it has another
  void step(const Step& step, Image<Srgb8>& picture);

  /// Whether keys go into a text field just now: then they turn no knobs and mean nothing else.
  virtual bool typing() const { return false; }

  /// Keys that lead at once to what a small picture of the demo should show.
  virtual std::span<const std::string_view> portrait_keys() const { return {}; }

  std::span<const Knob> knobs() const { return knobs_; }
  int width() const { return width_; }
  int height() const { return height_; }

 protected:
  Demo(const DemoSetup& setup, std::vector<Knob> knobs);
  Demo(const Demo&);
  Demo& operator=(const Demo&);

  /// Moves the world by the exposure's length and answers events that turned no knob.
  virtual void update(const Step& step) = 0;
  /// The light of step.exposure, encoded.
  virtual void draw(const Step& step, Image<Srgb8>& picture) = 0;
  /// The picture is width() by height() from now on.
  virtual void resized() {}

  const Knob& knob(int index) const { return knobs_.at(static_cast<std::size_t>(index)); }
  /// For menus in the picture itself.
  void turn(int index, double value) { knobs_.at(static_cast<std::size_t>(index)).value = value; }
  Studio& studio() const { return *studio_; }
  bool portrait() const { return portrait_; }

 private:
  std::shared_ptr<Studio> studio_;
  int width_, height_;
  bool portrait_;
  std::vector<Knob> knobs_;
};

/// Gives a demo its clone().
template <typename Derived, typename Base = Demo>
class ClonableDemo : public Base {
 public:
  using Base::Base;
  std::unique_ptr<Demo> clone() const override {
    return std::make_unique<Derived>(static_cast<const Derived&>(*this));
  }
};

/// Whether a demo has drawn yet. A copy has not: it may be given another picture to draw on.
class HasDrawn {
 public:
  HasDrawn() = default;
  HasDrawn(const HasDrawn&) {}
  HasDrawn& operator=(const HasDrawn&) { return *this; }
  /// @return whether this was so before
  bool mark() { return std::exchange(drawn_, true); }

 private:
  bool drawn_ = false;
};

/// An entry of the registry.
struct DemoInfo {
  std::string_view name;     ///< as typed: "frame-buffer"
  std::string_view chapter;  ///< "11 Rendering"
  std::string_view summary;  ///< one line, without a full stop
  std::function<std::unique_ptr<Demo>(const DemoSetup& setup)> create;
  double time_scale = 1;        ///< simulated seconds a second at the start
  std::string_view mouse = {};  ///< what the mouse does, if anything: "drag to orbit"
  /// Rows of the textbook that it shows, as the course names them.
  std::vector<std::string_view> topics = {};
  bool steps_back = true;  ///< false: its past is not kept
};

}  // namespace kinescope
