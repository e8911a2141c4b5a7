#include "engine/clip/contour_crossings.h"

#include <algorithm>
#include <cmath>

#include "engine/clip/orientation.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

using Vec = glm::dvec2;

/// Of the moved subject's point s, beside the clip's line: never 0.
int side_of_clip_line(const Vec& c1, const Vec& c2, const Vec& s) {
  if (const int side = orientation(c1, c2, s)) return side;
  if (c1.y != c2.y) return c2.y > c1.y ? -1 : 1;
  return c2.x > c1.x ? 1 : -1;
}

/// Of the clip's point c, beside the moved subject's line: never 0.
int side_of_subject_line(const Vec& s1, const Vec& s2, const Vec& c) {
  if (const int side = orientation(s1, s2, c)) return side;
  if (s1.y != s2.y) return s2.y > s1.y ? 1 : -1;
  return s2.x > s1.x ? -1 : 1;
}

/// Twice the triangle's area, 0 only where it is exactly that.
double area(const Vec& a, const Vec& b, const Vec& c) {
  if (orientation(a, b, c) == 0) return 0.0;
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double share(double from, double to) {
  const double t = from / (from - to);
  return t >= 0.0 && t <= 1.0 ? t : 0.5;  // where rounding made the areas disagree with their signs
}

bool apart(const Vec& a1, const Vec& a2, const Vec& b1, const Vec& b2) {
  return std::max(a1.x, a2.x) < std::min(b1.x, b2.x) ||
         std::max(b1.x, b2.x) < std::min(a1.x, a2.x) ||
         std::max(a1.y, a2.y) < std::min(b1.y, b2.y) || std::max(b1.y, b2.y) < std::min(a1.y, a2.y);
}

struct Edge {
  Vec from, to;
  ContourPlace place;
};

std::vector<Edge> edges_of(const Region& region) {
  std::vector<Edge> edges;
  for (std::size_t c = 0; c < region.size(); ++c) {
    for (std::size_t e = 0; e < region[c].size(); ++e) {
      edges.push_back({region[c][e], region[c][(e + 1) % region[c].size()], {c, e, 0.0}});
    }
  }
  return edges;
}

void cross(const Edge& s, const Edge& c, CrossingLists& lists) {
  if (apart(s.from, s.to, c.from, c.to)) return;
  const int end_side = side_of_clip_line(c.from, c.to, s.to);
  if (side_of_clip_line(c.from, c.to, s.from) == end_side) return;
  if (side_of_subject_line(s.from, s.to, c.from) == side_of_subject_line(s.from, s.to, c.to))
    return;
  ContourCrossing x;
  x.entering = end_side > 0;
  x.on_subject = s.place;
  x.on_clip = c.place;
  x.on_subject.t = share(area(c.from, c.to, s.from), area(c.from, c.to, s.to));
  x.on_clip.t = share(area(s.from, s.to, c.from), area(s.from, s.to, c.to));
  const double t = x.on_subject.t, u = x.on_clip.t;
  // A corner is given back to the bit.
  x.point = t == 0.0   ? s.from
            : t == 1.0 ? s.to
            : u == 0.0 ? c.from
            : u == 1.0 ? c.to
                       : s.from + t * (s.to - s.from);
  lists.along_subject[s.place.contour].push_back(lists.crossings.size());
  lists.along_clip[c.place.contour].push_back(lists.crossings.size());
  lists.crossings.push_back(x);
}

/// Sorted by place. Crossings at one point, which rounding may have put in any order, are then
/// exchanged so that entering and leaving take turns.
void put_in_order(std::vector<std::size_t>& list, std::span<const ContourCrossing> crossings,
                  ContourPlace ContourCrossing::*on, bool first_enters, double nearness) {
  std::sort(list.begin(), list.end(), [&](std::size_t a, std::size_t b) {
    const ContourPlace &p = crossings[a].*on, &q = crossings[b].*on;
    return p.edge != q.edge ? p.edge < q.edge : p.t != q.t ? p.t < q.t : a < b;
  });
  bool enters = first_enters;
  for (auto at = list.begin(); at != list.end(); ++at, enters = !enters) {
    const auto fit = std::find_if(at, list.end(),
                                  [&](std::size_t i) { return crossings[i].entering == enters; });
    // The edge is exact, so only places on one edge can have been exchanged.
    const auto elsewhere = [&](const ContourCrossing& x, const ContourCrossing& y) {
      const Vec d = x.point - y.point;
      return (x.*on).edge != (y.*on).edge || std::max(std::abs(d.x), std::abs(d.y)) > nearness;
    };
    if (fit == list.end() || elsewhere(crossings[*fit], crossings[*at]))
      throw_bad_input("a polygon to be clipped crosses itself");
    std::rotate(at, fit, fit + 1);
  }
}

double extent_of(const std::vector<Edge>& edges) {
  double extent = 0.0;
  for (const Edge& e : edges) extent = std::max({extent, std::abs(e.from.x), std::abs(e.from.y)});
  return extent;
}

}  // namespace

bool subject_point_in_clip(const Vec& p, const Region& clip) {
  bool inside = false;
  for (const Edge& e : edges_of(clip)) {
    if ((e.from.y > p.y) == (e.to.y > p.y)) continue;
    inside ^= (side_of_clip_line(e.from, e.to, p) > 0) == (e.to.y > e.from.y);
  }
  return inside;
}

bool clip_point_in_subject(const Vec& p, const Region& subject) {
  bool inside = false;
  for (const Edge& e : edges_of(subject)) {
    if ((e.from.y >= p.y) == (e.to.y >= p.y)) continue;
    inside ^= (side_of_subject_line(e.from, e.to, p) > 0) == (e.to.y > e.from.y);
  }
  return inside;
}

CrossingLists contour_crossings(const Region& subject, const Region& clip, bool keep_inside) {
  CrossingLists lists;
  lists.along_subject.resize(subject.size());
  lists.along_clip.resize(clip.size());
  const std::vector<Edge> subject_edges = edges_of(subject), clip_edges = edges_of(clip);
  for (const Edge& s : subject_edges) {
    for (const Edge& c : clip_edges) cross(s, c, lists);
  }
  const double nearness = 1e-9 * std::max(extent_of(subject_edges), extent_of(clip_edges));
  for (auto& list : lists.along_subject) {
    if (list.empty()) continue;
    const std::size_t contour = lists.crossings[list[0]].on_subject.contour;
    const bool inside = subject_point_in_clip(subject[contour][0], clip);
    put_in_order(list, lists.crossings, &ContourCrossing::on_subject, inside != keep_inside,
                 nearness);
  }
  for (auto& list : lists.along_clip) {
    if (list.empty()) continue;
    const std::size_t contour = lists.crossings[list[0]].on_clip.contour;
    // Where the clip's contour begins inside the subject, it next comes out, and there the subject
    // goes to its left.
    const bool inside = clip_point_in_subject(clip[contour][0], subject);
    put_in_order(list, lists.crossings, &ContourCrossing::on_clip, inside, nearness);
  }
  return lists;
}

}  // namespace kinescope
