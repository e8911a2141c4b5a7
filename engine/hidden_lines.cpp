#include "engine/hidden_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

namespace kinescope {
namespace {

constexpr int kMostCells = 256;
constexpr double kFacesACell = 4;
/// Two faces that share an edge hide up to the same place, but for rounding.
constexpr double kJoint = 1e-7;

glm::dvec3 xyw(const glm::dvec4& p) { return {p.x, p.y, p.w}; }

/// Which of `cells` cells from -1 to 1 holds a place, the outer ones all that lies beyond.
int cell_of(double place, int cells) {
  if (!(place > -1)) return 0;
  return place < 1 ? std::min(static_cast<int>((place + 1) * 0.5 * cells), cells - 1) : cells - 1;
}

}  // namespace

HiddenLines::HiddenLines(const WireScene& scene, const Camera& camera,
                         std::span<const glm::dvec4> clip_points)
    : scene_(scene) {
  // depth = a - b / w: to double the distance adds b to z.
  const double b = -camera.clip_from_view()[3][2];
  const bool parallel = camera.projection == Projection::kOrthographic;
  unit_ = parallel ? 1.0 : b;
  cells_ =
      std::clamp(static_cast<int>(std::sqrt(static_cast<double>(scene.faces.size()) / kFacesACell)),
                 1, kMostCells);
  faces_.reserve(scene.faces.size());
  for (std::size_t i = 0; i < scene.faces.size(); ++i) {
    const auto& corners = scene.faces[i];
    place(i, clip_points[corners[0]], clip_points[corners[1]], clip_points[corners[2]]);
  }
  std::sort(faces_.begin(), faces_.end(), [](const Face& one, const Face& other) {
    return one.nearest != other.nearest ? one.nearest < other.nearest : one.index < other.index;
  });
  fill_cells();
}

/// Keeps a face, unless it is seen from its edge or lies outside the view.
void HiddenLines::place(std::size_t index, const glm::dvec4& a, const glm::dvec4& b,
                        const glm::dvec4& c) {
  std::array<glm::dvec3, 3> sides{glm::cross(xyw(b), xyw(c)), glm::cross(xyw(c), xyw(a)),
                                  glm::cross(xyw(a), xyw(b))};
  const double area = glm::dot(xyw(a), sides[0]);
  if (area == 0 || !std::isfinite(area)) return;
  Face face;
  face.index = static_cast<int>(index);
  face.depth = (a.z * sides[0] + b.z * sides[1] + c.z * sides[2]) / area;
  for (std::size_t i = 0; i < 3; ++i) face.sides[i] = area < 0 ? -sides[i] : sides[i];
  const double w_least = std::min({a.w, b.w, c.w});
  if (!(w_least > 0)) {
    if (std::max({a.w, b.w, c.w}) <= 0) return;
    face.low = glm::dvec2(-1), face.high = glm::dvec2(1);
    face.nearest = -std::numeric_limits<double>::infinity();
  } else {
    const glm::dvec3 p = glm::dvec3(a) / a.w, q = glm::dvec3(b) / b.w, r = glm::dvec3(c) / c.w;
    const glm::dvec3 low = glm::min(p, glm::min(q, r)), high = glm::max(p, glm::max(q, r));
    if (low.x > 1 || low.y > 1 || high.x < -1 || high.y < -1) return;
    face.low = glm::dvec2(low), face.high = glm::dvec2(high);
    face.nearest = low.z;
  }
  faces_.push_back(face);
}

/// Each cell's faces, one cell after the other: counted first, then laid down near to far.
void HiddenLines::fill_cells() {
  const auto for_cells_of = [this](const Face& face, const auto& body) {
    const int left = cell_of(face.low.x - kJoint, cells_);
    const int right = cell_of(face.high.x + kJoint, cells_);
    const int top = cell_of(face.high.y + kJoint, cells_);
    for (int y = cell_of(face.low.y - kJoint, cells_); y <= top; ++y) {
      for (int x = left; x <= right; ++x) body(static_cast<std::size_t>(y * cells_ + x));
    }
  };
  first_.assign(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_) + 1, 0);
  for (const Face& face : faces_) {
    for_cells_of(face, [this](std::size_t cell) { ++first_[cell + 1]; });
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  held_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    for_cells_of(faces_[i],
                 [&](std::size_t cell) { held_[next[cell]++] = static_cast<std::uint32_t>(i); });
  }
}

/// Faces that touch a line's end lie before the rest of it wherever they lie before any of it.
double HiddenLines::least_before(const Face& face, const WireEdge& edge) const {
  const auto& corners = scene_.faces[static_cast<std::size_t>(face.index)];
  const bool touches = std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
    return corner == edge.a || corner == edge.b;
  });
  return unit_ * (touches ? kLeastBeforeEnd : kLeastBefore);
}

/// Adds the part of a line that lies behind a face.
void HiddenLines::hide(const Face& face, const glm::dvec4& from, const glm::dvec4& to, double least,
                       std::vector<LinePart>& hidden) const {
  LinePart part;
  const auto keep_positive = [&part](double at_from, double at_to) {
    if (at_from < 0 && at_to < 0) return false;
    if (at_from < 0) part.from = std::max(part.from, at_from / (at_from - at_to));
    if (at_to < 0) part.to = std::min(part.to, at_from / (at_from - at_to));
    return true;
  };
  const glm::dvec3 a = xyw(from), b = xyw(to);
  for (const glm::dvec3& side : face.sides) {
    if (!keep_positive(glm::dot(side, a), glm::dot(side, b))) return;
  }
  const double before_a = from.z - glm::dot(face.depth, a) - least;
  const double before_b = to.z - glm::dot(face.depth, b) - least;
  if (!keep_positive(before_a, before_b) || !(part.from < part.to)) return;
  hidden.push_back(part);
}

/// Calls body(cell) for the cells that a line may touch, a column after the other.
/// @param body returns whether to go on
template <typename Body>
void HiddenLines::for_each_cell(const glm::dvec4& from, const glm::dvec4& to,
                                const Body& body) const {
  glm::dvec2 a = glm::dvec2(from) / from.w, b = glm::dvec2(to) / to.w;
  if (a.x > b.x) std::swap(a, b);
  const int left = cell_of(a.x - kJoint, cells_), right = cell_of(b.x + kJoint, cells_);
  const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
  for (int x = left; x <= right; ++x) {
    double y0 = a.y, y1 = b.y;
    if (left < right) {
      const double x0 = -1 + 2.0 * x / cells_, x1 = -1 + 2.0 * (x + 1) / cells_;
      if (x > left) y0 = a.y + slope * (x0 - a.x);
      if (x < right) y1 = a.y + slope * (x1 - a.x);
    }
    const int top = cell_of(std::max(y0, y1) + kJoint, cells_);
    for (int y = cell_of(std::min(y0, y1) - kJoint, cells_); y <= top; ++y) {
      if (!body(static_cast<std::size_t>(y * cells_ + x))) return;
    }
  }
}

/// What is hidden of a line, by all faces that may lie before it; or all of it.
void HiddenLines::gather_hidden(const WireEdge& edge, const glm::dvec4& from, const glm::dvec4& to,
                                Scratch& scratch) const {
  scratch.tried_.resize(faces_.size(), 0);
  ++scratch.line_;
  scratch.hidden_.clear();
  const double farthest = std::max(from.z / from.w, to.z / to.w);
  for_each_cell(from, to, [&](std::size_t cell) {
    for (std::size_t i = first_[cell]; i < first_[cell + 1]; ++i) {
      const std::uint32_t number = held_[i];
      const Face& face = faces_[number];
      if (face.nearest >= farthest) break;
      if (std::exchange(scratch.tried_[number], scratch.line_) == scratch.line_) continue;
      if (face.index == edge.faces[0] || face.index == edge.faces[1]) continue;
      const std::size_t parts = scratch.hidden_.size();
      hide(face, from, to, least_before(face, edge), scratch.hidden_);
      if (scratch.hidden_.size() == parts) continue;
      if (const LinePart& p = scratch.hidden_.back(); p.from <= 0 && p.to >= 1) return false;
    }
    return true;
  });
}

void HiddenLines::visible_parts(const WireEdge& edge, const glm::dvec4& from, const glm::dvec4& to,
                                Scratch& scratch, std::vector<LinePart>& visible) const {
  gather_hidden(edge, from, to, scratch);
  std::sort(scratch.hidden_.begin(), scratch.hidden_.end(),
            [](const LinePart& a, const LinePart& b) { return a.from < b.from; });
  double seen_from = 0;
  for (const LinePart& part : scratch.hidden_) {
    if (part.from > seen_from + kJoint) visible.push_back({seen_from, part.from});
    seen_from = std::max(seen_from, part.to);
  }
  if (seen_from + kJoint < 1) visible.push_back({seen_from, 1});
}

}  // namespace kinescope
