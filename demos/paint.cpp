// A paint program: brushes, a spray can, filling, and figures stretched like rubber bands.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "demos/brushes.h"
#include "demos/lesson/lesson.h"
#include "demos/undo.h"
#include "engine/fractals/random.h"
#include "raster/base/error.h"
#include "raster/fill/flood_fill.h"
#include "raster/scan/spray.h"

namespace kinescope {
namespace {

enum { kTool, kColour };
enum { kBrush, kSpray, kFill, kLine, kBox, kEllipse };
constexpr int kDropsAMove = 40;

class Paint : public ClonableDemo<Paint, Lesson> {
 public:
  explicit Paint(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Drag with the left button: brush, spray, or stretch a line, box or "
                         "ellipse. A click fills. The right button picks up a colour; u takes the "
                         "last stroke back, x clears.",
             .figures = {{"width", 7, 1, 31, 1, false}},
             .resolution = 7,
             .speed = 8},
            {choice_knob("tool", {"1", "2", "3", "4", "5", "6"},
                         {"brush", "spray", "fill", "line", "box", "ellipse"}, kBrush,
                         "what the left button does"),
             choice_knob("colour", {"c"}, {"black", "red", "amber", "green", "blue", "paper"}, 4,
                         "of the paint")}),
        random_(setup.seed) {
    paper_ = first_painting(World::kScreenWidth / 2, World::kScreenHeight / 2);
  }
  std::size_t state_bytes() const override {
    return Lesson::state_bytes() + (1 + undo_.most()) * 4 * paper_.pixels().size();
  }

 private:
  Brush brush(Image<Srgb8>& paper) const {
    return {paper, kPaints[static_cast<std::size_t>(knob(kColour).index())]};
  }
  int width_of_brush() const {
    const int width = whole_figure(0);
    if (width < 1 || width > 100) throw_bad_input("width: from 1 to 100 pixels");
    return width;
  }

  /// The figure from where the button went down to here.
  void figure_to(Image<Srgb8>& paper, glm::ivec2 to) const {
    const BrushFigure figure{knob(kTool).index() - kLine};
    paint_figure(brush(paper), figure, *down_, to, width_of_brush());
  }

  void dab(glm::ivec2 at) {
    if (knob(kTool).index() == kSpray) {
      spray(glm::dvec2(at) + 0.5, 1.5 * width_of_brush(), kDropsAMove, random_, brush(paper_));
    } else {
      paint_line(brush(paper_), last_, at, width_of_brush());
    }
    last_ = at;
  }

  bool answer(const InputEvent& event, LessonScreen::Spot spot) override {
    match_paper();
    const glm::ivec2 at(glm::clamp(glm::floor(spot.at), glm::dvec2(-4000), glm::dvec2(4000)));
    if (event.kind == InputKind::kKeyDown) return key(event.key);
    if (event.kind == InputKind::kMouseDown && paper_.contains(at.x, at.y)) return press(event, at);
    if (event.kind == InputKind::kMouseMove && down_) {
      if (knob(kTool).index() < kFill) dab(at);
      last_ = at;
      return true;
    }
    if (event.kind != InputKind::kMouseUp || !down_) return false;
    if (knob(kTool).index() > kFill) figure_to(paper_, at);
    down_.reset();
    return true;
  }

  bool press(const InputEvent& event, glm::ivec2 at) {
    if (event.button == MouseButton::kRight) return pick(paper_.at(at.x, at.y));
    if (event.button != MouseButton::kLeft) return false;
    undo_.keep(paper_);
    down_ = last_ = at;
    if (knob(kTool).index() == kFill) {
      flood_fill(paper_, at.x, at.y, Connectivity::kFour, brush(paper_));
    } else if (knob(kTool).index() < kFill) {
      dab(at);
    }
    return true;
  }

  bool pick(Srgb8 colour) {
    const auto paint = std::find(kPaints.begin(), kPaints.end(), colour);
    if (paint != kPaints.end()) turn(kColour, static_cast<double>(paint - kPaints.begin()));
    return true;
  }

  bool key(const std::string& key) {
    if (key == "u") return undo_.take_back(paper_);
    if (key != "x") return false;
    undo_.keep(paper_);
    paper_ = Image<Srgb8>(paper_.width(), paper_.height(), kPaintPaper);
    return true;
  }

  /// What was painted stays where the resolution has changed.
  void match_paper() {
    if (paper_.width() == world().columns()) return;
    paper_ = sampled(paper_, world().columns(), world().rows());
    undo_.clear();
  }

  Course record() const override {
    Course course;
    Image<Srgb8> shown = sampled(paper_, world().columns(), world().rows());
    if (down_ && knob(kTool).index() > kFill) figure_to(shown, last_);
    width_of_brush();
    course.papers.push_back(std::move(shown));
    course.remarks.push_back(fmt::format("{} in {}, {} strokes can be taken back",
                                         knob(kTool).text(), knob(kColour).text(), undo_.size()));
    return course;
  }

  SeededRandom random_;
  Image<Srgb8> paper_;
  Undo<Image<Srgb8>> undo_{16};
  std::optional<glm::ivec2> down_;
  glm::ivec2 last_{0};
};

}  // namespace

DemoInfo paint_demo() {
  return {"paint",
          "1 Displays and coordinates",
          "A paint program: brush widths and colours, spray, fill, rubber-band figures",
          [](const DemoSetup& setup) { return std::make_unique<Paint>(setup); },
          1,
          "left: paint, right: pick a colour",
          {"applications: a paint program (brush widths and colours)", "input: mouse, keyboard"}};
}

}  // namespace kinescope
