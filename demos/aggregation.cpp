// Diffusion-limited aggregation: particles wander in and stay where they touch: a dendrite.
#include <fmt/format.h>

#include "demos/lesson/chart.h"
#include "engine/fractals/dimension.h"
#include "engine/fractals/dla.h"

namespace kinescope {
namespace {

enum { kSeed, kAges };

class AggregationDemo : public ClonableDemo<AggregationDemo, Lesson> {
 public:
  explicit AggregationDemo(const DemoSetup& setup)
      : ClonableDemo(setup,
                     {.look_for = "Tips catch the particles before they find the gaps between: so "
                                  "it branches and never fills. 1 and 2: another run of chance.",
                      .resolution = 6,
                      .speed = 5},
                     {number_knob("chance", "1", "2", 1, 20, 1, 1, "", "another run of chance"),
                      toggle_knob("ages", "a", true, "a colour for each sixth of the particles")}) {
  }

 private:
  Course record() const override {
    const int side = std::max(16, std::min(world().columns(), world().rows()));
    Aggregation cluster(side, static_cast<std::uint64_t>(knob(kSeed).value));
    while (cluster.next()) {
    }
    const std::size_t count = cluster.particles.size();
    const glm::ivec2 corner((world().columns() - side) / 2, (world().rows() - side) / 2);
    Track track("particles", {"x", "y", "away"});
    for (std::size_t i = 0; i < count; ++i) {
      const glm::ivec2 p = cluster.particles[i], out = p - glm::ivec2(side / 2);
      const std::size_t age = knob(kAges).on() ? i * kChartInks.size() / count : 0;
      track.plot(corner.x + p.x, corner.y + p.y, kChartInks[age]);
      track.step({double(p.x), double(p.y), std::hypot(out.x, out.y)});
    }
    Course course;
    course.tracks.push_back(std::move(track));
    course.remarks = {fmt::format("{} particles within {:.1f} pixels", count, cluster.radius()),
                      fmt::format("dimension {:.2f} by its radius of gyration",
                                  gyration_dimension(cluster.particles)),
                      "1.71 for large clusters; a full disc's is 2"};
    return course;
  }
};

}  // namespace

DemoInfo aggregation_demo() {
  return {"aggregation",
          "9 Curves and fractals",
          "Diffusion-limited aggregation, particle by particle, and its dimension",
          [](const DemoSetup& setup) { return std::make_unique<AggregationDemo>(setup); },
          1,
          {},
          {"diffusion-limited aggregation", "dendrites"}};
}

}  // namespace kinescope
