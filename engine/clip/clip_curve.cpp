#include "engine/clip/clip_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/clip/outcode.h"
#include "engine/curves/bezier.h"

namespace kinescope {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double positive(double angle) { return angle < 0.0 ? angle + kTurn : angle; }

void join(std::vector<CurvePart>& parts, CurvePart part) {
  if (!parts.empty() && parts.back().to == part.from) {
    parts.back().to = part.to;
  } else {
    parts.push_back(part);
  }
}

void clip_pieces(const ClipWindow& window, std::span<const glm::dvec2> control, CurvePart part,
                 int depth, std::vector<CurvePart>& parts) {
  Outcode all = 15, any = 0;
  for (const glm::dvec2& p : control) {
    const Outcode code = outcode(window, p);
    all &= code;
    any |= code;
  }
  if (all != 0) return;
  // At the last halving a piece is shorter than can be told: it belongs to where it began.
  if (any == 0 || (depth == 0 && window.contains(control.front()))) return join(parts, part);
  if (depth == 0) return;
  const double middle = 0.5 * (part.from + part.to);
  const BezierHalves<glm::dvec2> halves = bezier_split(control, 0.5);
  clip_pieces(window, halves.before, {part.from, middle}, depth - 1, parts);
  clip_pieces(window, halves.after, {middle, part.to}, depth - 1, parts);
}

}  // namespace

std::vector<CurvePart> clip_ellipse(const ClipWindow& window, const ClippedEllipse& ellipse) {
  const glm::dvec2 c = ellipse.centre, r = ellipse.radii;
  if (!is_finite(c) || !is_finite(r) || !(r.x > 0.0 && r.y > 0.0)) return {};
  std::vector<double> cuts;
  for (const double x : {window.min.x, window.max.x}) {
    const double cosine = (x - c.x) / r.x;
    if (!(std::abs(cosine) < 1.0)) continue;
    cuts.push_back(std::acos(cosine));
    cuts.push_back(positive(-std::acos(cosine)));
  }
  for (const double y : {window.min.y, window.max.y}) {
    const double sine = (y - c.y) / r.y;
    if (!(std::abs(sine) < 1.0)) continue;
    cuts.push_back(positive(std::asin(sine)));
    cuts.push_back(std::numbers::pi - std::asin(sine));
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  const auto at = [&](double a) { return c + r * glm::dvec2(std::cos(a), std::sin(a)); };
  if (cuts.empty()) {
    return window.contains(at(0.0)) ? std::vector<CurvePart>{{0.0, kTurn}}
                                    : std::vector<CurvePart>{};
  }
  std::vector<CurvePart> parts;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const double from = cuts[i], to = i + 1 < cuts.size() ? cuts[i + 1] : cuts[0] + kTurn;
    if (window.contains(at(0.5 * (from + to)))) join(parts, {from, to});
  }
  // The last part may go on where the first began.
  if (parts.size() > 1 && parts.back().to == parts.front().from + kTurn) {
    parts.back().to = parts.front().to + kTurn;
    parts.erase(parts.begin());
  }
  return parts;
}

std::vector<CurvePart> clip_bezier(const ClipWindow& window, std::span<const glm::dvec2> control) {
  std::vector<CurvePart> parts;
  if (control.empty() || !std::all_of(control.begin(), control.end(), is_finite)) return parts;
  clip_pieces(window, control, {0.0, 1.0}, 44, parts);
  return parts;
}

}  // namespace kinescope
