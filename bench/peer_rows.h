// The figures of bench_peers, measured: ours and the peer's frames, interleaved in one process.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/statistics.h"
#include "bench/workloads.h"

namespace kinescope::bench {

struct PairOptions {
  int threads = 2;
  int pairs = 9;
  int width = 1920, height = 1080;
  std::string pictures;  ///< folder for both last frames; empty: none
};

/// One workload at one sample count. The peer's figures are missing where it has no such mode.
struct Row {
  std::string workload;
  int samples = 1, threads = 2;
  double ours_ms = 0;
  std::optional<double> peer_ms, ratio;  ///< ratio: median of the pairs' ratios
  std::optional<PictureDifference> difference;
  std::string peer_version;
};

/// llvmpipe draws with 1 or 4 samples; of 8, ours alone is measured.
Row measure_pair(const PairOptions& options, const Workload& workload, int samples);

/// Ours alone, each frame drawn at every sample count in turn: our 4x over our 1x, 8x over 4x.
struct OwnCost {
  double four_over_one, eight_over_four;
};
OwnCost measure_own_cost(const PairOptions& options, const Workload& workload);

/// Ours alone, each frame drawn by one thread and by two in turn: how many times faster two are.
double measure_two_threads(const PairOptions& options, const Workload& workload, int samples);

/// 10^6 triangles with legs of 10 pixels, depth only, on one core.
Row measure_depth_only(const PairOptions& options, int samples);

}  // namespace kinescope::bench
