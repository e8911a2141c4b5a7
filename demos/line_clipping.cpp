// Lines clipped to a window three ways: by region codes, by parameter, by halving.
#include <fmt/format.h>

#include "demos/lesson/ink_lines.h"
#include "demos/lesson/lesson.h"
#include "demos/region_codes.h"
#include "engine/clip/cohen_sutherland.h"
#include "engine/clip/midpoint_subdivision.h"

namespace kinescope {
namespace {

enum { kMethod };
enum { kCohenSutherland, kLiangBarsky, kMidpoint };
enum { kFrom, kTo, kLow, kHigh };

class LineClipping : public ClonableDemo<LineClipping, Lesson> {
 public:
  explicit LineClipping(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Red is thrown away, step by step. Codes: above, below, right, left; both "
                         "0000 is accepted, a common bit rejected. Drag ends and corners.",
             .handles = {{"from", {0.05, 0.15}},
                         {"to", {0.95, 0.7}},
                         {"corner", {0.25, 0.75}},
                         {"opposite", {0.75, 0.25}}},
             .resolution = 4,
             .speed = 0,
             .centred = true},
            {choice_knob("method", {"1", "2", "3"},
                         {"Cohen-Sutherland", "Liang-Barsky", "midpoint"}, kCohenSutherland,
                         "how the ends are found")}) {}

 private:
  /// A step: what it threw away, in red; at first the whole line.
  void cut(Track& track, const Segment2& thrown, std::vector<double> values,
           std::string note) const {
    const World pane = world();
    const bool whole = track.steps() == 0;
    if (whole || thrown.from != thrown.to) {
      ink_part(track, pane, {pane.middle_of(segment().from), pane.middle_of(segment().to)},
               {pane.middle_of(thrown.from), pane.middle_of(thrown.to)},
               whole ? theme::kAccent : theme::kRed);
    }
    track.step(std::move(values), std::move(note));
  }
  Segment2 segment() const { return {named_point(kFrom), named_point(kTo)}; }
  ClipWindow window() const { return ClipWindow::between(named_point(kLow), named_point(kHigh)); }

  Track cohen_sutherland() const {
    Track track("Cohen-Sutherland", {"x", "y"});
    CohenSutherland clip(window(), segment());
    Segment2 thrown = segment(), before = segment();
    do {
      const glm::dvec2 moved = clip.moved_from ? clip.segment.from : clip.segment.to;
      if (track.steps() > 0) thrown = {clip.moved_from ? before.from : before.to, moved};
      if (clip.state == ClipState::kRejected) thrown = before;
      cut(track, thrown, {moved.x, moved.y},
          "codes " + code_bits(clip.from_code) + " " + code_bits(clip.to_code));
      before = clip.segment;
    } while (clip.next());
    return track;
  }
  Track liang_barsky() const {
    Track track("Liang-Barsky", {"side", "enter", "leave"});
    LiangBarsky clip(window(), segment());
    Segment2 thrown = segment(), before = segment();
    do {
      const Segment2 now = clip.segment();
      if (track.steps() > 0) {
        thrown =
            now.from != before.from ? Segment2{before.from, now.from} : Segment2{before.to, now.to};
      }
      if (clip.state == ClipState::kRejected) thrown = before;
      cut(track, thrown, {double(clip.side), clip.enter, clip.leave},
          fmt::format("p {:.3g}, q {:.3g}", clip.p, clip.q));
      before = now;
    } while (clip.next());
    return track;
  }
  Track midpoint() const {
    Track track("midpoint", {"halvings", "x", "y"});
    MidpointSubdivision clip(window(), segment(), 0.01);
    Segment2 thrown = segment();
    glm::dvec2 outer = clip.outer;
    do {
      if (track.steps() > 0) {
        thrown =
            clip.rejected_half ? Segment2{outer, clip.middle} : Segment2{clip.middle, clip.middle};
      }
      if (clip.state == ClipState::kRejected) thrown = segment();
      cut(track, thrown, {double(clip.halvings), clip.middle.x, clip.middle.y},
          clip.rejected_half ? "the outer half is thrown away" : "the outer half is kept");
      outer = clip.outer;
    } while (clip.next());
    return track;
  }

  Course record() const override {
    for (int i = kFrom; i <= kHigh; ++i) pixel(i);
    Course course;
    const int method = knob(kMethod).index();
    course.tracks.push_back(method == kCohenSutherland ? cohen_sutherland()
                            : method == kLiangBarsky   ? liang_barsky()
                                                       : midpoint());
    const World pane = world();
    const ClipWindow w = window();
    const glm::dvec2 far(pane.columns(), pane.rows());
    for (const double x : {w.min.x, w.max.x}) {
      course.guides.push_back({pane.middle_of({x, -far.y}), pane.middle_of({x, far.y})});
    }
    for (const double y : {w.min.y, w.max.y}) {
      course.guides.push_back({pane.middle_of({-far.x, y}), pane.middle_of({far.x, y})});
    }
    if (method == kCohenSutherland) {
      course.overlay = [pane, w](std::size_t) { return region_codes(pane, w); };
    }
    const auto left = clip_cohen_sutherland(w, segment());
    course.remarks.push_back(left ? fmt::format("inside: ({:.2f}, {:.2f}) to ({:.2f}, {:.2f})",
                                                left->from.x, left->from.y, left->to.x, left->to.y)
                                  : "rejected: nothing of the line is inside");
    return course;
  }
};

}  // namespace

DemoInfo line_clipping_demo() {
  return {"line-clipping",
          "7 Viewing and clipping",
          "Lines clipped by region codes, by parameter and by halving, step by step",
          [](const DemoSetup& setup) { return std::make_unique<LineClipping>(setup); },
          1,
          "drag ends and corners",
          {"Cohen-Sutherland", "Liang-Barsky", "midpoint subdivision"}};
}

DemoInfo practical_7_demo() {
  DemoInfo info = line_clipping_demo();
  info.name = "practical-7";
  info.chapter = "Practicals";
  info.summary = "Practical 7: Cohen-Sutherland clipping, the region codes shown";
  info.topics = {"practical 7"};
  return info;
}

}  // namespace kinescope
