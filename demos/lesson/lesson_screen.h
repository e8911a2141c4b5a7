// The display that a lesson's picture is on: a tube of the user's choice, or flat pixels.
#pragma once

#include <string>
#include <vector>

#include "demos/lesson/world.h"
#include "demos/monitor.h"

namespace kinescope {

class LessonScreen {
 public:
  /// Names of the displays; "flat" is the last.
  static const std::vector<std::string>& names();

  explicit LessonScreen(const Rect& room);

  void resize(const Rect& room) { monitor_.resize(room); }
  /// Switches to another display at demo time `now`.
  void choose(int display, Seconds now);
  Rate refresh() const { return monitor_.refresh(); }
  const Rect& face() const { return monitor_.face(); }
  std::size_t state_bytes() const { return monitor_.state_bytes(); }
  /// What is shown from the next refresh on: the panes' pictures, a coarse pixel each.
  void show(const World& world, const std::vector<Image<Srgb8>>& panes);
  void draw(const Step& step, Workers& workers, Image<Srgb8>& picture);

  /// From the picture to a pane's coarse pixels and back; between pixels too.
  struct Spot {
    int pane = 0;
    glm::dvec2 at{0};
  };
  Spot spot(const World& world, int x, int y) const;
  /// The same in the pane given, also where it is beyond.
  Spot spot_in(const World& world, int pane, int x, int y) const;
  glm::vec2 place(const World& world, const Spot& spot) const;

 private:
  bool flat() const;
  void draw_flat(Workers& workers, Image<Srgb8>& picture) const;

  int display_ = 0;
  Monitor monitor_;
  std::shared_ptr<const Image<Srgb8>> shown_;
  bool waits_ = false;  // for the next refresh
};

}  // namespace kinescope
