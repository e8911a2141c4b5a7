#include "bench/cold.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <memory>

#include "bench/peer_llvmpipe.h"
#include "engine/renderer.h"
#include "raster/base/error.h"

namespace kinescope::bench {
namespace {

constexpr int kSteadyFrames = 5;
constexpr int kChildren = 3;

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Draws frame after frame; the first began at `start`, with making what draws it.
template <typename Draw>
void print_frames(const PairOptions& options, const Workload& workload, Clock::time_point start,
                  const Draw& draw) {
  const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
  draw(workload.camera(0, aspect));
  const double first_ms = milliseconds_since(start);
  std::vector<double> later;
  for (int frame = 1; frame <= kSteadyFrames; ++frame) {
    const Camera camera = workload.camera(frame, aspect);
    const auto began = Clock::now();
    draw(camera);
    later.push_back(milliseconds_since(began));
  }
  fmt::print("{} {}\n", first_ms, median(later));
}

ColdFigures run_child(const PairOptions& options, const char* who, int samples) {
  const std::string command = fmt::format("/proc/{}/exe --cold-child {} --samples {} --threads {}",
                                          getpid(), who, samples, options.threads);
  const std::unique_ptr<FILE, int (*)(FILE*)> child(popen(command.c_str(), "r"), pclose);
  ColdFigures figures{};
  if (!child || std::fscanf(child.get(), "%lf %lf", &figures.first_ms, &figures.steady_ms) != 2) {
    throw Error(ErrorKind::kBadInput, "a child process gave no times", command);
  }
  return figures;
}

}  // namespace

void run_cold_child(const PairOptions& options, const std::string& who, int samples) {
  const Workload workload = make_workload("knot-phong");
  const auto start = Clock::now();
  if (who == "peer") {
    LlvmpipePeer peer(workload, options.width, options.height, samples);
    print_frames(options, workload, start, [&](const Camera& camera) { peer.draw(camera); });
    return;
  }
  Workers workers(options.threads);
  Renderer renderer(workers);
  RenderTarget target(options.width, options.height, samples, ColourFormat::kLinear8);
  RenderSettings settings;
  settings.shading = workload.shading;
  print_frames(options, workload, start, [&](const Camera& camera) {
    renderer.render(workload.scene, camera, settings, target);
  });
}

ColdRow measure_cold(const PairOptions& options, int samples) {
  const bool with_peer = samples <= LlvmpipePeer::kMaxSamples;
  std::vector<double> our_first, our_factor, peer_first, peer_factor, ratios;
  for (int i = 0; i < kChildren; ++i) {
    const ColdFigures ours = run_child(options, "ours", samples);
    our_first.push_back(ours.first_ms);
    our_factor.push_back(ours.first_ms / ours.steady_ms);
    if (!with_peer) continue;
    const ColdFigures peer = run_child(options, "peer", samples);
    peer_first.push_back(peer.first_ms);
    peer_factor.push_back(peer.first_ms / peer.steady_ms);
    ratios.push_back(peer.first_ms / ours.first_ms);
  }
  ColdRow cold{};
  cold.row.workload = "cold";
  cold.row.samples = samples;
  cold.row.threads = options.threads;
  cold.row.ours_ms = median(our_first);
  cold.ours_over_steady = median(our_factor);
  if (with_peer) {
    cold.row.peer_ms = median(peer_first);
    cold.row.ratio = median(ratios);
    cold.peer_over_steady = median(peer_factor);
  }
  return cold;
}

}  // namespace kinescope::bench
