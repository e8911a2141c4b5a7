// The raster tube beside ffmpeg's plain Lanczos upscale of the same frames to the same size, rgb24
// in and out, in turn. The tube does all it can do; ffmpeg only resizes.
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/flags/flags.h"
#include "bench/program.h"
#include "bench/statistics.h"
#include "demos/json.h"
#include "demos/options.h"
#include "display/raster_tube.h"
#include "display/tube/preset.h"
#include "raster/base/error.h"

namespace kinescope::bench {
namespace {

struct Options {
  std::vector<std::string> sources{"320x240", "640x480"};
  std::vector<std::string> outputs{"1920x1080", "3840x2160"};
  std::vector<std::string> presets{"bench-flat", "bench-curved"};
  int threads = 2, pairs = 9, frames = 20;
  bool json = false, planar = false, alone = false;
};

struct Row {
  std::string source, output, preset;
  double ms = 0, ffmpeg_ms = 0, ratio = 0;
  RasterTube::Times stages;
  double still_share = 0, black_share = 0;  // of ms, for a picture that does not change
  double bytes_a_pixel = 0;                 // of the output, all that the tube holds
  double growth = 1;                        // ms over the first output's
};

double now_ms() {
  return std::chrono::duration<double, std::milli>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Bytes that are allocated now.
double heap_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Two tubes with everything on: a flat one with an aperture grille, and a curved one with a slot
/// mask and guns that converge badly; or a preset by name.
TubeSettings settings_of(const std::string& name, Size source, Size output) {
  TubeSettings s;
  if (name == "bench-flat") {
    s = find_tube_preset("grille-pro").settings;
  } else if (name == "bench-curved") {
    s = find_tube_preset("television-slot").settings;
  } else {
    s = find_tube_preset(name).settings;
  }
  s.mode = cvt_mode(source.width, source.height, 60);
  s.glass.aspect = static_cast<double>(output.width) / output.height;
  // As wide in lines as on the tube's own mode of 480.
  s.spot.sigma_mm *= 480.0 / source.height;
  return s;
}

/// Frames of soft shapes and sharp noise, as rgb24.
std::vector<std::uint8_t> film(Size size, int frames) {
  std::mt19937 random(1);
  std::vector<std::uint8_t> bytes;
  for (int f = 0; f < frames; ++f) {
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto noise = static_cast<int>(random() % 40);
        bytes.push_back(static_cast<std::uint8_t>((x + 3 * f) % 256));
        bytes.push_back(static_cast<std::uint8_t>((y * 2 + f) % 216 + noise));
        bytes.push_back(static_cast<std::uint8_t>((x + y) / 3 % 200 + noise));
      }
    }
  }
  return bytes;
}

/// Ours, one film frame a refresh.
class Ours {
 public:
  Ours(const TubeSettings& settings, Size source, Size output, int threads)
      : tube_(settings, output.width, output.height),
        buffer_(source.width, source.height, PixelFormat::kRgb888, 2),
        out_(output.width, output.height),
        workers_(threads) {}

  double time_ms(const std::vector<std::uint8_t>& film, int frames, bool changing) {
    const std::size_t bytes = buffer_.memory(0).size();
    const double began = now_ms();
    for (int f = 0; f < frames; ++f) {
      const std::size_t picture = static_cast<std::size_t>(changing ? f : 0);
      const int page = buffer_.hidden_page();
      std::copy_n(film.begin() + static_cast<std::ptrdiff_t>(picture * bytes), bytes,
                  buffer_.memory(page).begin());
      buffer_.flip_at_retrace(page);
      ++frame_;
      tube_.photograph(buffer_, frame_ * tube_.scan().mode().frame_period(), workers_,
                       {out_, 1, 0, 0, true});
    }
    return (now_ms() - began) / frames;
  }
  const RasterTube::Times& times() const { return tube_.times(); }

 private:
  RasterTube tube_;
  FrameBuffer buffer_;
  Image<Srgb8> out_;
  Workers workers_;
  int frame_ = 0;
};

/// ffmpeg's, from the difference between a long and a short run.
class Ffmpeg {
 public:
  Ffmpeg(const std::vector<std::uint8_t>& film, Size source, Size output, const Options& o)
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("kinescope_bench_{}x{}.rgb", source.width, source.height)) {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(film.data()),
               static_cast<std::streamsize>(film.size()));
    const std::string format = o.planar ? "yuv444p" : "rgb24";
    command_ = fmt::format(
        "ffmpeg -v error -nostdin -filter_threads {} -threads {} -stream_loop -1 -f rawvideo "
        "-pix_fmt {} -s {}x{} -i {} -vf scale={}:{}:flags=lanczos -pix_fmt {} -f rawvideo -y ",
        o.threads, o.threads, format, source.width, source.height, path_.string(), output.width,
        output.height, format);
  }
  ~Ffmpeg() { std::filesystem::remove(path_); }

  double time_ms(int frames) const {
    const double few = run_ms(2);
    return (run_ms(2 + frames) - few) / frames;
  }

 private:
  double run_ms(int frames) const {
    const double began = now_ms();
    const std::string all = fmt::format("{}-frames:v {} /dev/null", command_, frames);
    if (std::system(all.c_str()) != 0) {
      throw Error(ErrorKind::kBadInput, "ffmpeg failed; install it to compare with it");
    }
    return now_ms() - began;
  }
  std::filesystem::path path_;
  std::string command_;
};

Row measure(const std::string& source_text, const std::string& output_text,
            const std::string& preset, const Options& options) {
  const Size source = parse_size(source_text, "--source");
  const Size output = parse_size(output_text, "--output");
  const std::vector<std::uint8_t> frames = film(source, options.frames);
  const Ffmpeg ffmpeg(frames, source, output, options);
  const double before = heap_bytes();
  Ours ours(settings_of(preset, source, output), source, output, options.threads);
  ours.time_ms(frames, 3, true);
  const double held = heap_bytes() - before;
  std::vector<double> mine, theirs, ratios;
  Row row;
  row.source = source_text, row.output = output_text, row.preset = preset;
  row.bytes_a_pixel = held / output.width / output.height;
  for (int pair = 0; pair < options.pairs; ++pair) {
    mine.push_back(ours.time_ms(frames, options.frames, true));
    theirs.push_back(options.alone ? 0 : ffmpeg.time_ms(options.frames));
    ratios.push_back(options.alone ? 0 : mine.back() / theirs.back());
  }
  row.ms = median(mine);
  row.ffmpeg_ms = median(theirs);
  row.ratio = median(ratios);
  row.stages = ours.times();
  const auto steady_share = [&](const std::vector<std::uint8_t>& shown) {
    constexpr int kFrames = 40;
    ours.time_ms(shown, kFrames, false);
    return ours.time_ms(shown, kFrames, false) / row.ms;
  };
  row.still_share = steady_share(frames);
  row.black_share = steady_share(std::vector<std::uint8_t>(frames.size()));
  return row;
}

void print_table(const std::vector<Row>& rows, int threads) {
  fmt::print(
      "{:8} {:10} {:16} {:>7} {:>8} {:>9} {:>6}  {:>6} {:>8} {:>5} {:>6}  {:>6} {:>6} {:>6} "
      "{:>7}\n",
      "source", "output", "tube", "threads", "ms", "ffmpeg ms", "ratio", "guns", "phosphor", "glow",
      "glass", "still", "black", "growth", "B/pixel");
  for (const Row& r : rows) {
    fmt::print(
        "{:8} {:10} {:16} {:7} {:8.2f} {:9.2f} {:6.3f}  {:6.2f} {:8.2f} {:5.2f} {:6.2f}  "
        "{:5.1f}% {:5.1f}% {:6.2f} {:7.1f}\n",
        r.source, r.output, r.preset, threads, r.ms, r.ffmpeg_ms, r.ratio, r.stages.guns,
        r.stages.phosphor, r.stages.glow, r.stages.glass, 100 * r.still_share, 100 * r.black_share,
        r.growth, r.bytes_a_pixel);
  }
}

void print_json(const std::vector<Row>& rows, int threads) {
  JsonWriter json;
  json.begin_array();
  for (const Row& r : rows) {
    json.begin_object().member("source", r.source).member("output", r.output);
    json.member("preset", r.preset).member("threads", threads).member("ms", r.ms);
    json.member("ffmpeg_ms", r.ffmpeg_ms).member("ratio", r.ratio);
    json.member("still_share", r.still_share).member("black_share", r.black_share);
    json.member("growth", r.growth).member("bytes_a_pixel", r.bytes_a_pixel);
    json.key("stages_ms").begin_object().member("guns", r.stages.guns);
    json.member("phosphor", r.stages.phosphor).member("glow", r.stages.glow);
    json.member("glass", r.stages.glass).end_object().end_object();
  }
  fmt::print("{}", json.end_array().text());
}

int run(int argc, char** argv) {
  Flags flags("Times the raster tube beside ffmpeg's Lanczos upscale of the same frames");
  Options options;
  flags.option("--source", &options.sources, "WxH of the film");
  flags.option("--output", &options.outputs, "WxH of the pictures");
  flags.option("--preset", &options.presets, "bench-flat, bench-curved, or a display's name");
  flags.option("--threads", &options.threads, "of both", Flags::Within{1, 256});
  flags.option("--pairs", &options.pairs, "of timings", Flags::Within{1, 1000});
  flags.option("--frames", &options.frames, "a timing", Flags::Within{1, 1000});
  flags.flag("--planar", options.planar, "ffmpeg resizes yuv444p, which is faster");
  flags.flag("--alone", options.alone, "without ffmpeg: to compare builds, or to profile");
  flags.flag("--json", options.json, "a list instead of a table");
  if (const auto exit = flags.parse(argc, argv)) return *exit;
  std::vector<Row> rows;
  for (const std::string& output : options.outputs) {
    for (const std::string& preset : options.presets) {
      for (const std::string& source : options.sources) {
        Row row = measure(source, output, preset, options);
        for (const Row& first : rows) {
          if (first.source != source || first.preset != preset) continue;
          row.growth = row.ms / first.ms;
          break;
        }
        rows.push_back(std::move(row));
      }
    }
  }
  options.json ? print_json(rows, options.threads) : print_table(rows, options.threads);
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

int main(int argc, char** argv) {
  return kinescope::bench::run_program("bench_display", kinescope::bench::run, argc, argv);
}
