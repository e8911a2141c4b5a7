// Cantor's set, Sierpinski's triangle, carpet and tetrahedron: what is left when the middle goes.
#include "engine/fractals/gasket.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "demos/lesson/chart.h"
#include "engine/fractals/dimension.h"
#include "engine/transform/exact_angle.h"
#include "raster/fill/scanline_fill.h"

namespace kinescope {
namespace {

enum { kFigure, kGenerations, kTurn };
enum { kCantor, kTriangle, kCarpet, kTetrahedron };

struct Law {
  double copies, ratio, left;  ///< of length, area or volume, a generation
};
constexpr std::array kLaws = {Law{2, 1.0 / 3, 2.0 / 3}, Law{3, 0.5, 0.75}, Law{8, 1.0 / 3, 8.0 / 9},
                              Law{4, 0.5, 0.5}};
constexpr std::array kDeepest = {8, 7, 4, 4};  // of the generations that a screen shows

class Gaskets : public ClonableDemo<Gaskets, Lesson> {
 public:
  explicit Gaskets(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "Each generation takes the middle out of every piece: the pieces "
                         "grow in number, what is left goes to nothing. 1 and 2 change it.",
             .resolution = 7,
             .speed = 5},
            {choice_knob("figure", {"y"}, {"Cantor", "triangle", "carpet", "tetrahedron"},
                         kTriangle, "the whole that is thinned out"),
             number_knob("generations", "1", "2", 0, 7, 1, 4, "", "how often the middle was taken"),
             number_knob("turn", "3", "4", -180, 180, 15, 20, "deg", "of the tetrahedron")}) {}

 private:
  int generations() const {
    const auto figure = static_cast<std::size_t>(knob(kFigure).index());
    return std::min(knob(kGenerations).index(), kDeepest[figure]);
  }

  void fill(Track& track, const Polygon& polygon, Srgb8 ink) const {
    scanline_fill(polygon, FillRule::kNonZero, world().window(),
                  [&](const RowSpan& span) { track.span(span, ink); });
  }

  /// All generations, one below the other.
  void cantor(Track& track) const {
    const double width = world().columns(), row = world().rows() / 10.0;
    double piece = 0;
    for (int n = 0; n <= generations(); ++n) {
      cantor_set(0.05 * width, 0.95 * width, n, [&](double from, double to) {
        for (double y = (n + 0.6) * row; y < (n + 1.2) * row; ++y) {
          ink_line(track, world(), {from, y}, {std::max(from, to - 1), y}, kChartInks[0]);
        }
        track.step({++piece, to - from});
      });
    }
  }

  void triangle(Track& track) const {
    const glm::dvec2 size(world().columns(), world().rows());
    const double height = 0.85 * size.y, half = height / std::sqrt(3.0);
    const glm::dvec2 top(0.5 * size.x, 0.07 * size.y);
    double piece = 0;
    sierpinski_triangle({top, top + glm::dvec2(-half, height), top + glm::dvec2(half, height)},
                        generations(), [&](const Triangle2& t) {
                          fill(track, {{t[0], t[1], t[2]}}, theme::kAccent);
                          track.step({++piece, t[2].x - t[1].x});
                        });
  }

  void carpet(Track& track) const {
    const glm::dvec2 size(world().columns(), world().rows());
    const glm::dvec2 half(0.45 * size.y);
    double piece = 0;
    sierpinski_carpet(0.5 * size - half, 0.5 * size + half, generations(),
                      [&](const glm::dvec2& low, const glm::dvec2& high) {
                        fill(track, {{low, {high.x, low.y}, high, {low.x, high.y}}}, theme::kCool);
                        track.step({++piece, high.x - low.x});
                      });
  }

  /// Turned about y and seen from a little above, far pieces first: near ones hide them.
  void tetrahedron(Track& track) const {
    const auto [s, c] = sine_cosine_deg(knob(kTurn).value);
    const auto [up, out] = sine_cosine_deg(20);
    const auto seen = [&](const glm::dvec3& p) {
      const double z = c * p.z - s * p.x;
      return glm::dvec3(c * p.x + s * p.z, out * p.y - up * z, out * z + up * p.y);  // z: nearness
    };
    const double r = std::sqrt(8.0) / 3, h = std::sqrt(3.0) / 2 * r;
    std::vector<Tetrahedron> pieces;
    sierpinski_tetrahedron(
        {{{0, 1, 0}, {r, -1.0 / 3, 0}, {-r / 2, -1.0 / 3, h}, {-r / 2, -1.0 / 3, -h}}},
        generations(), [&](const Tetrahedron& t) {
          pieces.push_back({seen(t[0]), seen(t[1]), seen(t[2]), seen(t[3])});
        });
    const auto nearness = [](const Tetrahedron& t) { return t[0].z + t[1].z + t[2].z + t[3].z; };
    std::stable_sort(pieces.begin(), pieces.end(), [&](const Tetrahedron& a, const Tetrahedron& b) {
      return nearness(a) < nearness(b);
    });
    double piece = 0;
    for (const Tetrahedron& t : pieces) {
      draw_faces(track, t);
      track.step({++piece, glm::length(t[1] - t[2])});
    }
  }

  /// The faces that look at the viewer.
  void draw_faces(Track& track, const Tetrahedron& t) const {
    const glm::dvec2 size(world().columns(), world().rows());
    const auto place = [&](const glm::dvec3& p) {
      return glm::dvec2(0.5 * size.x + 0.5 * size.y * p.x, 0.6 * size.y - 0.5 * size.y * p.y);
    };
    constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
    constexpr std::array kInks = {theme::kDim, theme::kAccent, theme::kCool, theme::kGreen};
    for (std::size_t f = 0; f < 4; ++f) {
      const auto corner = [&](int i) { return t[static_cast<std::size_t>(kFaces[f][i])]; };
      const glm::dvec3 across = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
      const glm::dvec3 middle = (t[0] + t[1] + t[2] + t[3]) * 0.25;
      const bool outwards = glm::dot(across, corner(0) - middle) > 0;
      if ((across.z > 0) != outwards) continue;
      fill(track, {{place(corner(0)), place(corner(1)), place(corner(2))}}, kInks[f]);
    }
  }

  Course record() const override {
    const auto figure = static_cast<std::size_t>(knob(kFigure).index());
    Track track(knob(kFigure).text(), {"piece", "size"});
    if (figure == kCantor) cantor(track);
    if (figure == kTriangle) triangle(track);
    if (figure == kCarpet) carpet(track);
    if (figure == kTetrahedron) tetrahedron(track);
    Course course;
    const Law& law = kLaws[figure];
    const int n = generations();
    course.remarks = {
        fmt::format("{} generations: {:.0f} pieces", n, std::pow(law.copies, n)),
        fmt::format("{:.4f} of the whole is left", std::pow(law.left, n)),
        fmt::format("dimension log {} / log {} = {:.3f}", law.copies, std::round(1 / law.ratio),
                    similarity_dimension(law.copies, law.ratio))};
    course.tracks.push_back(std::move(track));
    return course;
  }
};

}  // namespace

DemoInfo gaskets_demo() {
  return {"gaskets",
          "9 Curves and fractals",
          "Cantor's set and Sierpinski's triangle, carpet and tetrahedron, by generations",
          [](const DemoSetup& setup) { return std::make_unique<Gaskets>(setup); },
          1,
          {},
          {"Cantor set", "Sierpinski triangle and carpet", "Sierpinski tetrahedron in 3-D"}};
}

}  // namespace kinescope
