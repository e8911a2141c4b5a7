#include "demos/hodograph.h"

#include <span>

#include "demos/lesson/chart.h"
#include "engine/curves/bezier.h"

namespace kinescope {
namespace {

template <typename Place>
Track drawn(const PiecesPlan& plan, const char* name, int pane, const TwoPieces& pieces,
            Place&& place) {
  Track track(name, {}, pane);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
    InkPen pen(kChartInks[1 + piece]);
    for (int i = 0; i <= plan.steps; ++i) {
      const double t = double(i) / plan.steps;
      pen.to(track, plan.world, place(bezier_point(std::span<const glm::dvec2>(pieces[piece]), t)));
      track.step({});
    }
  }
  return track;
}

}  // namespace

Track pieces_track(const PiecesPlan& plan, const char* name, int pane, const TwoPieces& pieces) {
  return drawn(plan, name, pane, pieces, [](const glm::dvec2& p) { return p; });
}

Track hodograph(const PiecesPlan& plan, const char* name, int pane, const TwoPieces& derivatives,
                Course& course) {
  FittedFigure figure;  // which has y upwards
  TwoPieces up = derivatives;
  for (std::vector<glm::dvec2>& points : up) {
    for (glm::dvec2& p : points) {
      p.y = -p.y;
      figure.hold(p);
    }
  }
  figure.hold({0, 0});
  const auto place = [&](const glm::dvec2& p) { return figure.place(plan.world, p); };
  const glm::dvec2 origin = place({0, 0}), size(plan.world.columns(), plan.world.rows());
  const Srgb8 dim = theme::with_alpha(theme::kDim, 110);
  course.guides.push_back({{0, origin.y}, {size.x, origin.y}, dim, pane});
  course.guides.push_back({{origin.x, 0}, {origin.x, size.y}, dim, pane});
  course.guides.push_back({origin, place(up[0].back()), kChartInks[1], pane});
  course.guides.push_back({origin, place(up[1].front()), kChartInks[2], pane});
  return drawn(plan, name, pane, up, place);
}

}  // namespace kinescope
