#include "bench/targets.h"

namespace kinescope::bench {
namespace {

constexpr Target kTargets[] = {
    {"knot-gouraud", 6, 10, 2.0, 1.3},
    {"knot-phong", 6, 6, 2.0, 1.3},
    {"knot-phong-texture", 5, 6, 2.0, 1.3},
    {"knot-coarse", 4, 5, 2.0, 1.3},
    {"knot-micro", 6, 15, 2.0, 1.3},
    {"layers-far-first", 6, 15, 1.4, 1.3},
    {"layers-near-first", 6, 15, 1.4, 1.3},
    {"layers-texture", 6, 15, 1.4, 1.3},
    {"city", 4, 5, 1.4, 1.3},
    {"sweep-1", 0, 0, 0, 0},
    {"sweep-2", 0, 0, 0, 0},
    {"sweep-5", 0, 0, 0, 0},
    {"sweep-10", 0, 0, 0, 0},
    {"sweep-50", 0, 0, 0, 0},
    {"sweep-100", 0, 0, 0, 0},
    {"sweep-500", 0, 0, 0, 0},
    {"cold", 0, 0, 0, 0},
    {"depth-10", 0, 0, 0, 0},
};

constexpr Target kRealMesh = {"real mesh", 4, 5, 0, 1.3};

}  // namespace

const Target& target_of(const std::string& workload) {
  for (const Target& target : kTargets) {
    if (workload == target.workload) return target;
  }
  return kRealMesh;
}

double least_ratio(const std::string& workload, int samples) {
  const Target& target = target_of(workload);
  return samples == 1 ? target.peer_1x : samples == 4 ? target.peer_4x : 0;
}

const char* at_least(double figure, double target) {
  return target == 0 ? "-" : figure >= target ? "met" : "short";
}

const char* at_most(double figure, double target) {
  return target == 0 ? "-" : figure <= target ? "met" : "short";
}

}  // namespace kinescope::bench
