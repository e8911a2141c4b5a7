// A lesson and what is done to it, an event a step.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>

#include "demo_testing.h"
#include "demos/lesson/lesson.h"

namespace kinescope {

class LessonUser {
 public:
  explicit LessonUser(const char* name)
      : info_(find_demo(name)), demo_(info_.create(small_setup(640, 480))) {
    pass({});
  }
  void pass(std::vector<InputEvent> events) {
    const Seconds length = step_length(info_, *demo_), begin = now_;
    now_ += length;
    demo_->step({{begin, now_}, std::move(events)}, picture_);
  }
  const Lesson& lesson() const { return dynamic_cast<const Lesson&>(*demo_); }
  InputEvent mouse(InputKind kind, glm::dvec2 at) const {
    const glm::vec2 place = lesson().place_of(at);
    return mouse_event(kind, static_cast<int>(std::lround(place.x)),
                       static_cast<int>(std::lround(place.y)), MouseButton::kLeft);
  }
  /// From the middle of one pixel to the middle of another.
  void drag(glm::dvec2 from, glm::dvec2 to) {
    pass({mouse(InputKind::kMouseDown, from)});
    pass({mouse(InputKind::kMouseMove, to)});
    pass({mouse(InputKind::kMouseUp, to)});
  }
  /// Types into the field of a handle or figure.
  void type(int field, const std::string& text) {
    const auto place = lesson().place_of_control(Lesson::field_of(field));
    ASSERT_TRUE(place.has_value());
    pass({mouse_event(InputKind::kMouseDown, static_cast<int>(place->x), static_cast<int>(place->y),
                      MouseButton::kLeft),
          mouse_event(InputKind::kMouseUp, static_cast<int>(place->x), static_cast<int>(place->y),
                      MouseButton::kLeft)});
    InputEvent event;
    event.kind = InputKind::kText;
    event.key = text;
    pass({event, key_down("Return")});
  }
  /// Where a handle planned at these shares stands: the middle of its pixel.
  glm::dvec2 share(double x, double y) const { return glm::round(glm::dvec2(x, y) * size()) + 0.5; }
  glm::dvec2 size() const { return {lesson().world().columns(), lesson().world().rows()}; }

 private:
  const DemoInfo& info_;
  std::unique_ptr<Demo> demo_;
  Seconds now_{0};
  Image<Srgb8> picture_;
};

}  // namespace kinescope
