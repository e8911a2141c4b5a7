// Our rasterizer and its peers on the same pictures, interleaved in one process.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "bench/peer_llvmpipe.h"
#include "bench/statistics.h"
#include "bench/workloads.h"
#include "engine/renderer.h"
#include "raster/base/error.h"
#include "raster/base/simd.h"
#include "raster/image/codecs.h"

namespace kinescope::bench {
namespace {

struct Options {
  std::vector<std::string> workloads, models;
  std::vector<int> samples{1, 4};
  int threads = 2;
  int pairs = 9;
  int width = 1920, height = 1080;
  bool json = false;
  std::string pictures;
};

struct Row {
  std::string workload;
  int samples, threads;
  double ours_ms, peer_ms, ratio;  // ratio: median of the pairs' ratios
  PictureDifference difference;
};

/// Codes by which two rasterizers may round a colour apart before a pixel counts as different.
constexpr int kTolerance = 4;

void save(const Options& options, const std::string& name, const Image<Linear8>& picture) {
  Image<Srgb8> stored(picture.width(), picture.height());
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const Linear8 p = picture.pixels()[i];
    stored.pixels()[i] =
        encode_srgb8(LinearRgb{static_cast<float>(p.r) / 255.0f, static_cast<float>(p.g) / 255.0f,
                               static_cast<float>(p.b) / 255.0f});
  }
  write_png(options.pictures + "/" + name + ".png", stored);
}

Row run(const Options& options, const Workload& workload, int samples) {
  const std::string& name = workload.name;
  Workers workers(options.threads);
  Renderer renderer(workers);
  RenderTarget target(options.width, options.height, samples, ColourFormat::kLinear8);
  RenderSettings settings;
  settings.shading = workload.shading;
  LlvmpipePeer peer(workload, options.width, options.height, samples);
  const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);

  const auto draw_ours = [&](const Camera& camera) {
    const auto start = std::chrono::steady_clock::now();
    renderer.render(workload.scene, camera, settings, target);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
  };
  std::vector<double> ours, theirs, ratios;
  constexpr int kWarmUp = 2;
  for (int frame = 0; frame < options.pairs + kWarmUp; ++frame) {
    const Camera camera = workload.camera(frame, aspect);
    const double our_ms = draw_ours(camera);
    const double peer_ms = peer.draw(camera);
    if (frame < kWarmUp) continue;
    ours.push_back(our_ms);
    theirs.push_back(peer_ms);
    ratios.push_back(peer_ms / our_ms);
  }
  const Image<Linear8>& our_picture = std::get<Image<Linear8>>(target.colour);
  const Image<Linear8> peer_picture = peer.picture();
  if (!options.pictures.empty()) {
    save(options, fmt::format("{}-{}x-ours", name, samples), our_picture);
    save(options, fmt::format("{}-{}x-llvmpipe", name, samples), peer_picture);
  }
  if (!options.json)
    std::fprintf(stderr, "%s %dx: %s\n", name.c_str(), samples, peer.version().c_str());
  return {name,
          samples,
          options.threads,
          median(ours),
          median(theirs),
          median(ratios),
          compare(our_picture, peer_picture, kTolerance)};
}

void print_table(const std::vector<Row>& rows) {
  fmt::print("{:<20}{:>8}{:>8}{:>10}{:>10}{:>8}{:>10}{:>8}\n", "workload", "samples", "threads",
             "ours ms", "peer ms", "ratio", "pixels", "psnr");
  for (const Row& r : rows) {
    fmt::print("{:<20}{:>8}{:>8}{:>10.2f}{:>10.2f}{:>8.2f}{:>10}{:>8.1f}\n", r.workload, r.samples,
               r.threads, r.ours_ms, r.peer_ms, r.ratio, r.difference.pixels_differing,
               r.difference.psnr_db);
  }
}

void print_json(const std::vector<Row>& rows) {
  fmt::print("[");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& r = rows[i];
    // JSON has no infinity: equal pictures give null.
    const std::string psnr =
        std::isfinite(r.difference.psnr_db) ? fmt::format("{:.3f}", r.difference.psnr_db) : "null";
    fmt::print(
        "{}\n  {{\"workload\": \"{}\", \"samples\": {}, \"threads\": {}, \"ours_ms\": {:.3f}, "
        "\"peer_ms\": {:.3f}, \"ratio\": {:.3f}, \"pixels_differing\": {}, \"psnr_db\": {}}}",
        i ? "," : "", r.workload, r.samples, r.threads, r.ours_ms, r.peer_ms, r.ratio,
        r.difference.pixels_differing, psnr);
  }
  fmt::print("\n]\n");
}

int run_all(int argc, char** argv) {
  Options options;
  CLI::App app(
      "Kinescope's rasterizer beside Mesa's llvmpipe: same pictures, interleaved, medians.");
  app.add_option("--workload", options.workloads, "workloads by name; all if none is given");
  app.add_option("--model", options.models, "model files, drawn in one colour");
  app.add_option("--samples", options.samples, "samples a pixel: 1, 4 (llvmpipe has no more)")
      ->check(CLI::IsMember({1, 4}));
  app.add_option("--threads", options.threads, "threads of each")->check(CLI::Range(1, 64));
  app.add_option("--pairs", options.pairs, "timed pairs of frames")->check(CLI::Range(1, 1000));
  app.add_option("--pictures", options.pictures, "folder for both last frames as PNG");
  app.add_flag("--json", options.json, "a list of figures instead of the table");
  CLI11_PARSE(app, argc, argv);
  if (options.workloads.empty() && options.models.empty()) options.workloads = workload_names();
  LlvmpipePeer::set_threads(options.threads);
  std::vector<Row> rows;
  const auto run_samples = [&](const Workload& workload) {
    for (const int samples : options.samples) rows.push_back(run(options, workload, samples));
  };
  for (const std::string& name : options.workloads) run_samples(make_workload(name));
  for (const std::string& path : options.models) run_samples(model_workload(path));
  options.json ? print_json(rows) : print_table(rows);
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

int main(int argc, char** argv) {
  try {
    return kinescope::bench::run_all(argc, argv);
  } catch (const kinescope::Error& error) {
    std::fprintf(stderr, "bench_peers: %s\n", error.what());
    return error.exit_code();
  }
}
