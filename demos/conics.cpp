// Ellipses by midpoints and by DDA, and any conic by its equation or by following it.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "demos/lesson/lesson.h"
#include "raster/base/error.h"
#include "raster/scan/conic_scan.h"
#include "raster/scan/conic_tracer.h"
#include "raster/scan/dda_ellipse.h"
#include "raster/scan/midpoint_ellipse.h"

namespace kinescope {
namespace {

enum { kKind, kFollow };
enum { kMidpoint, kDda, kEllipse, kParabola, kHyperbola };
enum { kA, kB, kAngle };

class Conics : public ClonableDemo<Conics, Lesson> {
 public:
  explicit Conics(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {.look_for = "The decision changes its axis where the curve passes 45 degrees. "
                         "b^2 - 4ac tells the kind. Drag the centre, set radii and angle.",
             .handles = {{"centre", {0.4, 0.5}}},
             .figures = {{"radius a", 14, 1, 40, 1},
                         {"radius b", 8, 1, 40, 1},
                         {"angle", 30, 0, 180, 5}},
             .resolution = 2},
            {choice_knob(
                 "curve", {"1", "2", "3", "4", "5"},
                 {"midpoint ellipse", "DDA ellipse", "conic: ellipse", "parabola", "hyperbola"},
                 kMidpoint, "what is drawn, and how"),
             toggle_knob("follow", "f", false,
                         "general conics from pixel to pixel, not by their equation")}) {}

 private:
  Course record() const override {
    const int kind = knob(kKind).index();
    const glm::ivec2 radii(whole_figure(kA), whole_figure(kB));
    if (radii.x < 0 || radii.y < 0) throw_bad_input("radius: an ellipse's is not negative");
    check_round(pixel(0), std::max(radii.x, radii.y));
    if (kind == kMidpoint) return midpoint(radii);
    if (kind == kDda) return dda(radii);
    return general(kind);
  }

  Course midpoint(glm::ivec2 radii) const {
    Track track("midpoint ellipse", {"x", "y", "d", "region"});
    for (MidpointEllipse e(radii); e.next();) {
      four_way(pixel(0), e.at(), track);
      track.step({double(e.at().x), double(e.at().y), double(e.decision()), e.steep() ? 2.0 : 1.0});
    }
    Course course;
    course.tracks.push_back(std::move(track));
    return course;
  }

  Course dda(glm::ivec2 radii) const {
    Track track("DDA ellipse", {"x", "y"});
    for (DdaEllipse e(radii); e.next();) {
      track(pixel(0).x + e.at().x, pixel(0).y + e.at().y);
      track.step({e.position().x, e.position().y});
    }
    Course course;
    course.tracks.push_back(std::move(track));
    return course;
  }

  Conic conic(int kind) const {
    const double turn = figure(kAngle) * std::numbers::pi / 180;
    const glm::dvec2 at = pixel(0), radii(figure(kA), figure(kB));
    if (!(radii.x > 0 && radii.y > 0)) throw_bad_input("radius: a conic's is greater than 0");
    if (kind == kParabola) return Conic::parabola(at, figure(kB) / 4, turn);
    return kind == kEllipse ? Conic::ellipse(at, radii, turn) : Conic::hyperbola(at, radii, turn);
  }

  Course general(int kind) const {
    const Conic c = conic(kind);
    Course course;
    Track track(knob(kFollow).on() ? "followed" : "by its equation", {"x", "y", "F"});
    const PixelRect window = world().window();
    if (knob(kFollow).on()) {
      ConicScan scan(c, window);
      if (scan.next()) follow(c, scan.at(), track);
    } else {
      for (ConicScan scan(c, window); scan.next();) {
        track(scan.at().x, scan.at().y);
        track.step({double(scan.at().x), double(scan.at().y), c(scan.at().x, scan.at().y)});
      }
    }
    course.tracks.push_back(std::move(track));
    course.remarks.push_back(
        fmt::format("{:.4g} x^2 {:+.4g} xy {:+.4g} y^2 {:+.4g} x {:+.4g} y {:+.4g} = 0; "
                    "b^2 - 4ac = {:.4g}",
                    c.a, c.b, c.c, c.d, c.e, c.f, c.discriminant()));
    return course;
  }

  void follow(const Conic& c, glm::ivec2 start, Track& track) const {
    for (const bool backwards : {false, true}) {
      ConicTracer tracer(c, world().window(), start, backwards);
      while (tracer.next()) {
        track(tracer.at().x, tracer.at().y);
        track.step({double(tracer.at().x), double(tracer.at().y), tracer.decision()});
      }
      if (tracer.closed()) return;
    }
  }
};

}  // namespace

DemoInfo conics_demo() {
  return {"conics",
          "2 Scan conversion",
          "Ellipses by midpoint and DDA; parabolas, hyperbolas and turned ellipses",
          [](const DemoSetup& setup) { return std::make_unique<Conics>(setup); },
          1,
          "drag the centre",
          {"midpoint ellipse", "DDA ellipse", "general conic"}};
}

}  // namespace kinescope
