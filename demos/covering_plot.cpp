#include "demos/covering_plot.h"

#include <algorithm>
#include <cmath>

#include "demos/lesson/chart.h"

namespace kinescope {

Track covering_plot(Course& course, const World& world, int pane, const CoveringPlot& plot) {
  Track track("log count over -log size", {}, pane);
  const auto at = [](const Covering& c) {
    return glm::dvec2(-std::log(c.size), std::log(c.count));
  };
  const glm::dvec2 low = at(plot.coverings.front()), high = at(plot.coverings.back());
  const Chart chart(world, {low.x, 0}, {high.x, std::max(high.y, 1.0)});
  chart.axes(course, pane, {low.x, 0});
  const auto count = static_cast<int>(plot.coverings.size());
  glm::dvec2 mean(0);
  for (const Covering& c : plot.coverings) mean += at(c) / double(count);
  const auto fitted = [&](double x) {
    return chart.place({x, mean.y + plot.slope * (x - mean.x)});
  };
  course.guides.push_back({fitted(low.x), fitted(high.x), theme::kGreen, pane});
  for (int i = 0; i < count; ++i) {
    const glm::dvec2 p = chart.place(at(plot.coverings[static_cast<std::size_t>(i)]));
    const Srgb8 ink = i == plot.lit ? theme::kAccent : theme::kText;
    for (const double off : {-1.0, 0.0, 1.0}) {
      ink_line(track, world, p + glm::dvec2(-1, off), p + glm::dvec2(1, off), ink);
    }
  }
  track.step({});
  return track;
}

}  // namespace kinescope
