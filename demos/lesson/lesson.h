// A demo that teaches an algorithm: a world of coarse pixels on a display, the algorithm's course
// recorded and played, its state beside the picture, and points to drag or to type.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "demos/demo.h"
#include "demos/followed_knobs.h"
#include "demos/lesson/lesson_screen.h"
#include "demos/lesson/playback.h"
#include "demos/lesson/track.h"
#include "demos/lesson/world.h"
#include "demos/ui/form.h"
#include "demos/ui/text_field.h"

namespace kinescope {

/// A point of the input: dragged in the picture, typed in its field. In whole pixels.
struct Handle {
  std::string label;
  glm::dvec2 at{0};  ///< in a plan: shares of the world's width and height
  int pane = -1;     ///< where it may be dragged; -1: in all
  int follows = -1;  ///< the handle that takes it along
};

/// A figure of the input, with a field and a slider. What is typed may lie outside the slider.
struct Figure {
  std::string label;
  double value = 0, least = 0, most = 1, step = 1;
  bool in_pixels = true;  ///< one whose step is 1 grows where the world's pixels become smaller
};

/// A line of text of the input, taken as it is typed.
struct Words {
  std::string label, text;
};

/// A line to be laid over the picture, in pixels of the world, between pixels too.
struct Guide {
  glm::dvec2 from{0}, to{0};
  Srgb8 colour = theme::kCool;
  int pane = -1;  ///< -1: all
};

/// Words to be laid over the picture, centred at a place.
struct Label {
  glm::dvec2 at{0};
  std::string words;
  Srgb8 colour = theme::kDim;
  int pane = 0;
};

/// What stands over the picture after a number of steps.
struct Overlay {
  std::vector<Guide> guides;
  std::vector<Label> labels;
};

/// What there is to see for the input as it stands.
struct Course {
  std::vector<Track> tracks;
  std::vector<Image<Srgb8>> papers;  ///< of the panes before the first step; plain if there is none
  std::vector<Guide> guides;
  std::vector<std::string> remarks;  ///< what came out, a line each
  /// For what is drawn anew each step, such as what moves: the paper of a pane, and what lies over
  /// all of them, after so many steps.
  std::function<void(std::size_t shown, int pane, Image<Srgb8>& paper)> painter{};
  std::function<Overlay(std::size_t shown)> overlay{};
  bool compare = false;  ///< lights the difference of the first two tracks
};

struct LessonPlan {
  std::string look_for{};  ///< one line: what to look for, which keys to try
  std::vector<Handle> handles{};
  std::vector<Figure> figures{};
  std::optional<Words> words{};
  int resolution = 1;  ///< of Lesson::kCells, from coarse to fine
  int speed = 3;       ///< of Playback::speeds()
  bool centred = false;
  bool loops = false;  ///< begins again after the last step
  int views = 0;       ///< the last so many of the demo's knobs move the viewer only: steps stay
};

class Lesson : public Demo {
 public:
  static constexpr int kSharedKnobs = 4;  ///< the last ones: every lesson has them
  static constexpr std::array kCells = {32, 20, 16, 10, 8, 5, 4, 2};
  static constexpr Srgb8 kUnlit{20, 20, 26, 255};  ///< so that borders of unlit pixels show

  ~Lesson() override;
  bool typing() const override { return focus_ != kNoField; }
  Rate refresh() const override { return screen_.refresh(); }
  /// The course's end.
  std::span<const std::string_view> portrait_keys() const override {
    static constexpr std::array<std::string_view, 1> kKeys = {"End"};
    return kKeys;
  }
  std::size_t state_bytes() const override { return screen_.state_bytes() + kOwnBytes; }

  /// For tests: what is shown, and what the panel says.
  const Course& course() const { return *course_; }
  const std::string& fault() const { return typing_fault_.empty() ? fault_ : typing_fault_; }
  std::size_t shown() const { return playback_.shown(); }
  World world() const;
  int fields() const;
  /// Where something is in the picture: a point of the world, a control of the panel.
  glm::vec2 place_of(glm::dvec2 at, int pane = 0) const {
    return screen_.place(world(), {pane, at});
  }
  std::optional<glm::vec2> place_of_control(int id) const;
  static int field_of(int handle_or_figure) { return kFirstField + handle_or_figure; }

 protected:
  /// @param own the demo's knobs, numbered as given; the lesson's come behind them
  Lesson(const DemoSetup& setup, LessonPlan plan, std::vector<Knob> own);
  Lesson(const Lesson&);
  Lesson& operator=(const Lesson&) = delete;

  /// Runs the algorithm. Called when the input, a knob or the world changed. An Error that it
  /// throws is shown in the panel.
  virtual Course record() const = 0;
  virtual glm::ivec2 panes() const { return {1, 1}; }
  /// Whether a handle is shown, and can be dragged, in a pane.
  virtual bool handle_in(int handle, int pane) const {
    const int only = plan_.handles[static_cast<std::size_t>(handle)].pane;
    return only < 0 || only == pane;
  }
  /// Makes a course that is recorded in parts finer by one; false if it is whole. Called once a
  /// step while all that is recorded has been shown. @param parts how many there are
  virtual bool refine(Course&, int /*parts*/) const { return false; }
  /// Events that are nobody else's; `at` in the pane under the mouse. @return whether it changed
  /// the input
  virtual bool answer(const InputEvent&, LessonScreen::Spot /*at*/) { return false; }

  /// Whether the demo's own hand holds something: while it does, the course stands at its end.
  virtual bool dragging() const { return false; }

  std::vector<Handle>& handles() { return plan_.handles; }
  glm::ivec2 pixel(int handle) const;  ///< @throws Error (bad input) if it cannot be one
  /// A handle as a corner of a polygon: the middle of its pixel.
  glm::dvec2 corner(int handle) const {
    return plan_.handles[static_cast<std::size_t>(handle)].at + 0.5;
  }
  /// A handle as its user names it.
  glm::dvec2 named_point(int handle) const {
    return world().named(plan_.handles[static_cast<std::size_t>(handle)].at);
  }
  std::size_t corners() const { return plan_.handles.size(); }
  double figure(int index) const { return plan_.figures[static_cast<std::size_t>(index)].value; }
  const std::string& words() const { return plan_.words->text; }
  int whole_figure(int index) const;  ///< @throws Error (bad input) if it is no int
  void move_handle(std::size_t handle, glm::dvec2 to);
  void set_figure(int index, double value) {
    plan_.figures[static_cast<std::size_t>(index)].value = value;
  }

 private:
  static constexpr int kNoField = -1, kNoHandle = -1;
  static constexpr std::size_t kOwnBytes = 2 << 20;
  enum Control {
    kRestart,
    kBack,
    kRun,
    kNext,
    kEnd,
    kFirstField = 100,
    kFirstSlider = 200,
    kFirstChoice = 1000
  };
  struct Sheet {  // the side panel as drawn
    Image<Srgb8> image;
    std::vector<Form::Target> targets;
  };

  void update(const Step& step) override;
  void draw(const Step& step, Image<Srgb8>& picture) override;
  void resized() override;
  void follow_world();
  enum class Begin { kFirst, kLast, kStay };
  void run_anew(Begin begin);
  void run_finer();
  std::size_t steps() const;
  int running_knob() const;
  void show_panes();

  // In lesson_input.cpp.
  bool take(const InputEvent& event);
  bool take_mouse(const InputEvent& event);
  bool press(int x, int y);
  bool use(int control, float along);
  bool handle_shown(int handle) const;
  int handle_near(const InputEvent& event) const;
  void focus_on(int field);
  bool types_words() const;
  std::string shown_in_field(int field) const;
  bool take_typed(const InputEvent& event);
  bool accept();
  bool leave_field();

  // In lesson_panel.cpp.
  Rect stage() const;
  Rect side() const;
  void draw_side();
  void draw_fields(Form& form) const;
  void draw_menu(Form& form) const;
  void draw_state(Form& form) const;
  void draw_over(Canvas& canvas) const;
  void draw_marks(Canvas& canvas, const World& world) const;
  void draw_pane(Canvas& canvas, const World& world, int pane, const Overlay& over) const;
  Form::Table table(const Track& track, const Track* beside) const;

  LessonPlan plan_;
  int own_knobs_;
  FollowedKnobs followed_;
  LessonScreen screen_;
  World last_world_;
  std::shared_ptr<const Course> course_ = std::make_shared<Course>();
  std::shared_ptr<const std::vector<std::vector<Mark>>> different_;  // of the first two tracks
  int parts_ = 0;  // of the course that are recorded; 0 once it is whole
  Playback playback_;
  std::string fault_, typing_fault_;
  int focus_ = kNoField, held_ = kNoHandle, held_pane_ = 0, held_slider_ = -1;
  TextField field_;
  glm::ivec2 mouse_{-1, -1};
  std::shared_ptr<const Sheet> sheet_ = std::make_shared<Sheet>();
  bool stale_ = true;  // the sheet and the panes are
};

}  // namespace kinescope
