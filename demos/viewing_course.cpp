#include "demos/viewing_course.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/clip_line_homogeneous.h"
#include "engine/projection/viewing_steps.h"
#include "engine/transform/in_between.h"

namespace kinescope {
namespace {

constexpr std::array kPlaneNames = {"left: w + x >= 0", "right: w - x >= 0", "bottom: w + y >= 0",
                                    "top: w - y >= 0",  "near: z >= 0",      "far: w - z >= 0"};
constexpr double kFloor = 5;  // half the side of the world's floor

/// Two houses of one drawing.
std::array<glm::dmat4, 2> placements() {
  return {translation({-0.9, 0, 0}) * rotation_y_deg(20),
          translation({2.2, 0, -2}) * rotation_y_deg(-35) * scaling({0.7, 1.3, 0.7})};
}

}  // namespace

ViewingCourse::ViewingCourse(const Camera& camera, const Axonometric& from, const Window& viewport)
    : camera_(camera), from_(from), viewport_(viewport), viewing_(viewing_steps(camera)) {
  canonical_from_world_ = compose(viewing_);
  clip_from_canonical_ = glm::dmat4(camera.clip_from_world()) * glm::inverse(canonical_from_world_);
  stages_.push_back({"local to world, two houses", kSmooth});
  for (const TransformStep3& step : viewing_) stages_.push_back({step.name, kSmooth});
  for (const char* name : kPlaneNames) stages_.push_back({std::string("clip, ") + name, 1});
  stages_.push_back({"division by w: to a box", kSmooth});
  stages_.push_back({"window to viewport", 1});
}

std::size_t ViewingCourse::steps() const {
  std::size_t steps = 0;
  for (const Stage& stage : stages_) steps += static_cast<std::size_t>(stage.pictures);
  return steps;
}

ViewingCourse::Place ViewingCourse::place(std::size_t shown) const {
  Place at;
  for (; at.stage < stages_.size(); ++at.stage) {
    const auto pictures = static_cast<std::size_t>(stages_[at.stage].pictures);
    if (shown < pictures) break;
    shown -= pictures;
  }
  if (at.stage < stages_.size()) at.share = double(shown) / stages_[at.stage].pictures;
  return at;
}

std::vector<ViewingCourse::Line> ViewingCourse::world_lines(double placed) const {
  std::vector<Line> lines;
  const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, Srgb8 ink) {
    lines.push_back({{a, 1.0}, {b, 1.0}, ink});
  };
  if (placed > 0) {
    for (double s = -kFloor; s <= kFloor; ++s) {
      add({s, 0, -kFloor}, {s, 0, kFloor}, theme::kKeyCap);
      add({-kFloor, 0, s}, {kFloor, 0, s}, theme::kKeyCap);
    }
  }
  const Wire house = wire_house();
  constexpr std::array kInks = {theme::kText, theme::kAccent};
  for (std::size_t k = 0; k < 2; ++k) {
    const glm::dmat4 matrix = in_between(placements()[k], placed);
    for (const auto& [a, b] : house.edges) {
      add(apply(matrix, house.points[a]), apply(matrix, house.points[b]), kInks[k]);
    }
  }
  return lines;
}

glm::dmat4 ViewingCourse::viewed(const Place& at) const {
  glm::dmat4 product(1.0);
  for (std::size_t k = 0; k < viewing_.size(); ++k) {
    if (at.stage < kViewing + k) break;
    const double share = at.stage > kViewing + k ? 1.0 : at.share;
    product = in_between(viewing_[k].matrix, share) * product;
  }
  return product;
}

glm::dmat4 ViewingCourse::divided(const Place& at) const {
  const double share = at.stage < kDivision ? 0.0 : at.stage > kDivision ? 1.0 : at.share;
  // Near stays nearer: the box's z counts away from the eye, the pictured space's towards it.
  const glm::dmat4 box = scaling({1, 1, -1}) * clip_from_canonical_;
  const double w = std::abs(box[2].w);  // of a point of depth 1; none for parallel views
  return (1.0 - share) * glm::dmat4(1.0) + share / (w > 0 ? w : 1.0) * box;
}

std::vector<ViewingCourse::Line> ViewingCourse::clipped(std::size_t planes) const {
  const auto all = view_volume_planes();
  const std::span<const ClipPlane> some = std::span(all).first(planes);
  const glm::dmat4 clip = clip_from_canonical_ * canonical_from_world_;
  const glm::dmat4 back = glm::inverse(clip_from_canonical_);
  std::vector<Line> lines;
  for (const Line& line : world_lines(1)) {
    glm::dvec4 a = clip * line.from, b = clip * line.to;
    if (clip_line(some, a, b)) lines.push_back({back * a, back * b, line.ink});
  }
  return lines;
}

std::array<glm::dvec3, 8> ViewingCourse::volume(const Place& at) const {
  const glm::dmat4 from_clip = viewed(at) * glm::inverse(glm::dmat4(camera_.clip_from_world()));
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec4 p(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : 0, 1);
    const glm::dvec4 q = divided(at) * (from_clip * p);
    corners[i] = glm::dvec3(q) / q.w;
  }
  return corners;
}

glm::dvec3 ViewingCourse::eye(const Place& at) const {
  return apply(viewed(at), glm::dvec3(camera_.eye));
}

/// The view-up vector, carried along with the eye that it stands on.
glm::dvec3 ViewingCourse::up(const Place& at) const {
  return glm::dmat3(viewed(at)) * glm::dvec3(camera_.up);
}

/// As large as the volume and the eye allow.
SpacePane ViewingCourse::pane(const Place& at, const World& world) const {
  glm::dvec3 low(1e300), high(-1e300);
  const auto hold = [&](const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  };
  for (const glm::dvec3& corner : volume(at)) hold(corner);
  if (at.stage < kDivision) hold(eye(at));
  return {world, from_, 0.5 * (low + high), 0.5 * glm::distance(low, high)};
}

void ViewingCourse::paint(std::size_t shown, const World& world, int which,
                          Image<Srgb8>& paper) const {
  PaperInk ink{paper};
  const Place at = place(shown);
  if (which == 1) {
    if (at.stage <= kViewport) return;
    for (const PictureLine& l : picture()) ink_line(ink, world, l.line.from, l.line.to, l.ink);
    return;
  }
  const SpacePane view = pane(at, world);
  const auto draw = [&](const glm::dvec4& a, const glm::dvec4& b, Srgb8 colour) {
    ink_line(ink, world, view.place(glm::dvec3(a) / a.w), view.place(glm::dvec3(b) / b.w), colour);
  };
  if (at.stage < kClip) {
    const glm::dmat4 m = viewed(at);
    for (const Line& line : world_lines(at.stage > kPlaced ? 1.0 : at.share)) {
      draw(m * line.from, m * line.to, line.ink);
    }
    return;
  }
  const std::size_t planes = std::min<std::size_t>(at.stage - kClip, 6);
  if (planes > 0 && at.stage <= kDivision && at.share == 0) {
    for (const Line& line : clipped(planes - 1)) draw(line.from, line.to, theme::kRed);
  }
  const glm::dmat4 box = divided(at);
  for (const Line& line : clipped(planes)) draw(box * line.from, box * line.to, line.ink);
}

std::vector<ViewingCourse::PictureLine> ViewingCourse::picture() const {
  const glm::dmat3 screen = viewport_from_window({{-1, -1}, {1, 1}}, viewport_);
  std::vector<PictureLine> lines;
  for (const Line& line : clipped(6)) {
    const glm::dvec4 a = clip_from_canonical_ * line.from, b = clip_from_canonical_ * line.to;
    lines.push_back(
        {{apply(screen, glm::dvec2(a) / a.w), apply(screen, glm::dvec2(b) / b.w)}, line.ink});
  }
  return lines;
}

Overlay ViewingCourse::overlay(std::size_t shown, const World& world) const {
  Overlay over;
  const Place at = place(shown);
  const SpacePane view = pane(at, world);
  const auto corners = volume(at);
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t bit = 1; bit < 8; bit *= 2) {
      if (!(i & bit)) view.add_line(over, corners[i], corners[i | bit], theme::kCool, 0);
    }
  }
  if (at.stage < kDivision) {
    if (camera_.projection == Projection::kPerspective) {
      for (std::size_t i = 0; i < 4; ++i) {
        view.add_line(over, eye(at), corners[i], theme::kDim, 0);
      }
    }
    const glm::dvec3 tip = eye(at) + 0.3 * view.reach * glm::normalize(up(at));
    view.add_line(over, eye(at), tip, theme::kGreen, 0);
    view.add_label(over, tip, "up", theme::kGreen, 0);
    view.add_label(over, eye(at), "eye", theme::kCool, 0);
  }
  view.add_axes(over, 0.4 * view.reach, 0);
  const glm::dvec2 a = viewport_.low, b = viewport_.high;
  const std::array<glm::dvec2, 4> frame = {{a, {b.x, a.y}, b, {a.x, b.y}}};
  for (std::size_t i = 0; i < 4; ++i) {
    over.guides.push_back({frame[i], frame[(i + 1) % 4], theme::kCool, 1});
  }
  return over;
}

glm::dvec4 ViewingCourse::traced(std::size_t shown) const {
  const Place at = place(shown);
  const double placed = at.stage > kPlaced ? 1.0 : at.share;
  const glm::dvec4 p =
      viewed(at) * glm::dvec4(apply(in_between(placements()[0], placed), {0, 1.75, 0.75}), 1.0);
  if (at.stage < kClip) return p;
  const glm::dvec4 clip = clip_from_canonical_ * p;
  if (at.stage <= kDivision) return clip;
  return {glm::dvec3(clip) / clip.w, 1.0};
}

std::string ViewingCourse::note(std::size_t shown) const {
  const std::size_t stage = place(shown == 0 ? 0 : shown - 1).stage;
  const glm::dvec3 up = this->up(place(shown));
  std::string text = fmt::format("{}/{}: {}\n", stage + 1, stages_.size(), stages_[stage].name);
  if (stage < kClip) text += fmt::format("up is now {:.3f} {:.3f} {:.3f}\n", up.x, up.y, up.z);
  if (stage == kPlaced) text += matrix_lines(placements()[0]);
  if (stage >= kViewing && stage < kClip) text += matrix_lines(viewing_[stage - kViewing].matrix);
  if (stage >= kClip && stage < kDivision) {
    const std::size_t before = clipped(stage - kClip).size();
    text += fmt::format("{} lines go in, {} come out\nclip space from the canonical volume:\n",
                        before, clipped(stage - kClip + 1).size());
    text += matrix_lines(clip_from_canonical_);
  }
  if (stage == kDivision) text += matrix_lines(clip_from_canonical_);
  if (stage == kViewport) {
    const glm::dmat3 m = viewport_from_window({{-1, -1}, {1, 1}}, viewport_);
    for (int row = 0; row < 3; ++row) {
      text += fmt::format("[{:9.3f}{:9.3f}{:9.3f} ]\n", m[0][row], m[1][row], m[2][row]);
    }
  }
  return text;
}

}  // namespace kinescope
