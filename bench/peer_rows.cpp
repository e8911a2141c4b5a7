#include "bench/peer_rows.h"

#include <fmt/format.h>

#include "bench/peer_llvmpipe.h"
#include "bench/triangle_field.h"
#include "engine/renderer.h"
#include "raster/image/codecs.h"

namespace kinescope::bench {
namespace {

/// Codes by which two rasterizers may round a colour apart before a pixel counts as different.
constexpr int kTolerance = 4;
constexpr int kWarmUp = 2;

/// Our side of a pair.
struct Ours {
  Ours(const PairOptions& options, const Workload& picture, int samples, int threads)
      : workload(picture),
        workers(threads),
        renderer(workers),
        target(options.width, options.height, samples, ColourFormat::kLinear8) {
    settings.shading = workload.shading;
  }
  double draw(const Camera& camera) {
    return milliseconds_of([&] { renderer.render(workload.scene, camera, settings, target); });
  }
  const Image<Linear8>& picture() const { return std::get<Image<Linear8>>(target.colour); }

  const Workload& workload;
  Workers workers;
  Renderer renderer;
  RenderTarget target;
  RenderSettings settings;
};

Camera camera_of(const PairOptions& options, const Workload& workload, int frame) {
  return workload.camera(frame,
                         static_cast<float>(options.width) / static_cast<float>(options.height));
}

void save(const PairOptions& options, const std::string& name, const Image<Linear8>& picture) {
  if (options.pictures.empty()) return;
  Image<Srgb8> stored(picture.width(), picture.height());
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const Linear8 p = picture.pixels()[i];
    stored.pixels()[i] =
        encode_srgb8(LinearRgb{static_cast<float>(p.r) / 255.0f, static_cast<float>(p.g) / 255.0f,
                               static_cast<float>(p.b) / 255.0f});
  }
  write_png(options.pictures + "/" + name + ".png", stored);
}

Row measure_ours(const PairOptions& options, const Workload& workload, int samples) {
  Ours ours(options, workload, samples, options.threads);
  std::vector<double> times_ms;
  for (int frame = 0; frame < options.pairs + kWarmUp; ++frame) {
    const double ms = ours.draw(camera_of(options, workload, frame));
    if (frame >= kWarmUp) times_ms.push_back(ms);
  }
  save(options, fmt::format("{}-{}x-ours", workload.name, samples), ours.picture());
  Row row;
  row.workload = workload.name;
  row.samples = samples;
  row.threads = options.threads;
  row.ours_ms = median(times_ms);
  return row;
}

}  // namespace

Row measure_pair(const PairOptions& options, const Workload& workload, int samples) {
  if (samples > LlvmpipePeer::kMaxSamples) return measure_ours(options, workload, samples);
  Ours ours(options, workload, samples, options.threads);
  LlvmpipePeer peer(workload, options.width, options.height, samples);
  std::vector<double> our_ms, peer_ms, ratios;
  for (int frame = 0; frame < options.pairs + kWarmUp; ++frame) {
    const Camera camera = camera_of(options, workload, frame);
    const double a = ours.draw(camera), b = peer.draw(camera);
    if (frame < kWarmUp) continue;
    our_ms.push_back(a);
    peer_ms.push_back(b);
    ratios.push_back(b / a);
  }
  const Image<Linear8> peer_picture = peer.picture();
  save(options, fmt::format("{}-{}x-ours", workload.name, samples), ours.picture());
  save(options, fmt::format("{}-{}x-llvmpipe", workload.name, samples), peer_picture);
  return {workload.name,
          samples,
          options.threads,
          median(our_ms),
          median(peer_ms),
          median(ratios),
          compare(ours.picture(), peer_picture, kTolerance),
          peer.version()};
}

OwnCost measure_own_cost(const PairOptions& options, const Workload& workload) {
  Ours one(options, workload, 1, options.threads), four(options, workload, 4, options.threads),
      eight(options, workload, 8, options.threads);
  std::vector<double> four_over_one, eight_over_four;
  for (int frame = 0; frame < options.pairs + kWarmUp; ++frame) {
    const Camera camera = camera_of(options, workload, frame);
    const double a = one.draw(camera), b = four.draw(camera), c = eight.draw(camera);
    if (frame < kWarmUp) continue;
    four_over_one.push_back(b / a);
    eight_over_four.push_back(c / b);
  }
  return {median(four_over_one), median(eight_over_four)};
}

double measure_two_threads(const PairOptions& options, const Workload& workload, int samples) {
  Ours one(options, workload, samples, 1), two(options, workload, samples, 2);
  std::vector<double> ratios;
  for (int frame = 0; frame < options.pairs + kWarmUp; ++frame) {
    const Camera camera = camera_of(options, workload, frame);
    const double a = one.draw(camera), b = two.draw(camera);
    if (frame >= kWarmUp) ratios.push_back(a / b);
  }
  return median(ratios);
}

Row measure_depth_only(const PairOptions& options, int samples) {
  const TriangleField field(1'000'000, 10.0f, options.width, options.height);
  const DrawCall call = field.call();
  Workers workers(1);
  Rasterizer rasterizer(workers);
  RenderTarget target(options.width, options.height, samples, ColourFormat::kLinear8);
  std::vector<double> times_ms;
  for (int frame = 0; frame < options.pairs + kWarmUp; ++frame) {
    const double ms = milliseconds_of([&] { rasterizer.draw(target, {&call, 1}); });
    if (frame >= kWarmUp) times_ms.push_back(ms);
  }
  Row row;
  row.workload = "depth-10";
  row.samples = samples;
  row.threads = 1;
  row.ours_ms = median(times_ms);
  return row;
}

}  // namespace kinescope::bench
