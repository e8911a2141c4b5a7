// Every field of every lesson, given what nobody should type.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "demo_testing.h"
#include "demos/lesson/lesson.h"

namespace kinescope {
namespace {

/// Small and without a tube, for there are many.
class Typist {
 public:
  explicit Typist(const DemoInfo& info) : info_(info), demo_(info.create(small_setup())) {
    pass({key_down("t"), key_down("t"), key_down("t")});
  }
  Typist(const Typist& other) : info_(other.info_), demo_(other.demo_->clone()), now_(other.now_) {}
  const Lesson* lesson() const { return dynamic_cast<const Lesson*>(demo_.get()); }
  /// Leaves what was typed before. @return whether the field is there to be clicked
  bool type(int field, const std::string& text) {
    const auto place = lesson()->place_of_control(Lesson::field_of(field));
    if (!place) return false;
    const int x = static_cast<int>(place->x), y = static_cast<int>(place->y);
    InputEvent words;
    words.kind = InputKind::kText;
    words.key = text;
    pass({key_down("Escape"), mouse_event(InputKind::kMouseDown, x, y, MouseButton::kLeft),
          mouse_event(InputKind::kMouseUp, x, y, MouseButton::kLeft), words, key_down("Return")});
    return true;
  }

 private:
  void pass(std::vector<InputEvent> events) {
    const Seconds length = step_length(info_, *demo_), begin = now_;
    now_ += length;
    demo_->step({{begin, now_}, std::move(events)}, picture_);
  }

  const DemoInfo& info_;
  std::unique_ptr<Demo> demo_;
  Seconds now_{0};
  Image<Srgb8> picture_;
};

/// Something is to be seen: steps, or a picture that was there before the first.
bool shows_something(const Course& course) {
  if (course.painter || !course.papers.empty()) return true;
  return std::any_of(course.tracks.begin(), course.tracks.end(),
                     [](const Track& track) { return track.steps() > 0; });
}

// No field's number leads to a crash, or to an empty picture without a word.
TEST(BadFields, AreTakenOrToldInThePanel) {
  int typed = 0;
  for (const DemoInfo& info : all_demos()) {
    Typist typist(info);
    if (typist.lesson() == nullptr) continue;
    const int fields = typist.lesson()->fields();
    for (int field = 0; field < fields; ++field) {
      Typist one(typist);  // what another field was given is forgotten
      for (const std::string text : {"1e300", "-2147483648"}) {
        if (!one.type(field, text)) continue;
        if (one.lesson()->fault().find("2 numbers") != std::string::npos) {
          one.type(field, text + ", 7");
        }
        ++typed;
        EXPECT_TRUE(!one.lesson()->fault().empty() || shows_something(one.lesson()->course()))
            << info.name << ", field " << field << ": " << text;
      }
    }
  }
  EXPECT_GT(typed, 300);
}

}  // namespace
}  // namespace kinescope
