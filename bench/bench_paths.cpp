// Anti-aliased lines beside AGG's outline renderer, filled paths and text beside Cairo: same
// pictures, interleaved in one process.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "bench/flags/flags.h"
#include "bench/peer_agg.h"
#include "bench/peer_cairo.h"
#include "bench/program.h"
#include "bench/statistics.h"
#include "bench/svg_fills.h"
#include "raster/base/error.h"
#include "raster/image/codecs.h"
#include "raster/path/font.h"
#include "raster/path/line_painter.h"
#include "raster/path/path_painter.h"

namespace kinescope::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;
constexpr int kLines = 50000;
constexpr float kTolerancePx = 0.1f;  // Cairo's own
/// Codes by which two rasterizers may round a colour apart before a pixel counts as different.
constexpr int kCodesApart = 4;

struct Options {
  std::vector<int> threads{1, 2};
  std::vector<int> lengths{10, 40, 200};
  std::vector<int> text_sizes{13, 48};
  int pairs = 9;
  float scale = 1;
  bool json = false;
  std::string pictures;
  std::string svg;
};

struct Row {
  std::string workload, peer;
  int threads;
  double ours_ms, peer_ms, ratio;  // ratio: median of the pairs' ratios
  PictureDifference difference;
};

/// A picture to draw, and the peer that draws it too.
struct Contest {
  std::string workload, peer;
  Linear8 ground;
  std::function<void(Workers&, Image<Linear8>&)> ours;
  std::function<void()> clear_peer, draw_peer;
  std::function<Image<Linear8>()> peer_picture;
};

/// Linear8 holds codes here, as both peers' pixels do.
void save(const Options& options, const std::string& name, const Image<Linear8>& picture) {
  Image<Srgb8> stored(picture.width(), picture.height());
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const Linear8 p = picture.pixels()[i];
    stored.pixels()[i] = {p.r, p.g, p.b, 255};
  }
  write_png(options.pictures + "/" + name + ".png", stored);
}

Row run(const Options& options, int width, int height, const Contest& contest, int threads) {
  Workers workers(threads);
  Image<Linear8> picture(width, height);
  std::vector<double> ours, theirs, ratios;
  constexpr int kWarmUp = 2;
  for (int i = 0; i < options.pairs + kWarmUp; ++i) {
    std::fill(picture.pixels().begin(), picture.pixels().end(), contest.ground);
    contest.clear_peer();
    const double our_ms = milliseconds_of([&] { contest.ours(workers, picture); });
    const double peer_ms = milliseconds_of(contest.draw_peer);
    if (i < kWarmUp) continue;
    ours.push_back(our_ms);
    theirs.push_back(peer_ms);
    ratios.push_back(peer_ms / our_ms);
  }
  const Image<Linear8> peer_picture = contest.peer_picture();
  if (!options.pictures.empty()) {
    save(options, contest.workload + "-ours", picture);
    save(options, fmt::format("{}-{}", contest.workload, contest.peer), peer_picture);
  }
  return {contest.workload,
          contest.peer,
          threads,
          median(ours),
          median(theirs),
          median(ratios),
          compare(picture, peer_picture, kCodesApart)};
}

/// Lines of random places, directions and colours, lengths even from nothing to twice the mean.
std::vector<InkedLine> random_lines(float mean_length_px) {
  std::mt19937 random(1);
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  std::vector<InkedLine> lines;
  for (int i = 0; i < kLines; ++i) {
    const glm::vec2 from{between(0, kWidth), between(0, kHeight)};
    const float angle = between(0, 2 * std::numbers::pi_v<float>);
    const float length = between(0, 2 * mean_length_px);
    const glm::vec2 to = from + length * glm::vec2(std::cos(angle), std::sin(angle));
    lines.push_back({{from, to}, {between(0, 1), between(0, 1), between(0, 1), 1}});
  }
  return lines;
}

void run_lines(const Options& options, int length, std::vector<Row>& rows) {
  const std::vector<InkedLine> lines = random_lines(static_cast<float>(length));
  AggLines agg(kWidth, kHeight, 1);
  for (const int threads : options.threads) {
    std::unique_ptr<LinePainter> painter;
    const Contest contest{fmt::format("lines-{}", length),
                          "agg",
                          {0, 0, 0, 255},
                          [&](Workers& workers, Image<Linear8>& picture) {
                            if (!painter) painter = std::make_unique<LinePainter>(workers);
                            painter->draw(lines, Stroke{}, Mixing::kOver, picture);
                          },
                          [&] { agg.clear(); },
                          [&] { agg.draw(lines); },
                          [&] { return agg.picture(); }};
    rows.push_back(run(options, kWidth, kHeight, contest, threads));
  }
}

void run_drawing(const Options& options, std::vector<Row>& rows) {
  SvgFills svg = read_svg_fills(options.svg);
  const float scale = options.scale * kHeight / svg.size.y;
  const int width = static_cast<int>(std::ceil(svg.size.x * scale));
  const int height = static_cast<int>(std::ceil(svg.size.y * scale));
  for (FilledPath& fill : svg.fills) {
    for (int column = 0; column < 3; ++column) fill.place[column] *= scale;
  }
  for (const auto& [quality, name] :
       {std::pair{CairoQuality::kDefault, "cairo"}, std::pair{CairoQuality::kBest, "cairo-best"}}) {
    CairoFills cairo(svg.fills, kTolerancePx, quality, width, height);
    for (const int threads : options.threads) {
      std::unique_ptr<PathPainter> painter;
      const Contest contest{"drawing",
                            name,
                            {255, 255, 255, 255},
                            [&](Workers& workers, Image<Linear8>& picture) {
                              if (!painter) painter = std::make_unique<PathPainter>(workers);
                              painter->draw(svg.fills, kTolerancePx, picture);
                            },
                            [&] { cairo.clear(); },
                            [&] { cairo.draw(); },
                            [&] { return cairo.picture(); }};
      rows.push_back(run(options, width, height, contest, threads));
    }
  }
}

/// Lines of made-up words that fill the page.
std::vector<std::string> page_of_text(float size_px) {
  std::mt19937 random(1);
  std::vector<std::string> lines(static_cast<std::size_t>(kHeight / (1.3f * size_px)));
  for (std::string& line : lines) {
    while (static_cast<float>(line.size()) * 0.55f * size_px < kWidth) {
      for (unsigned left = 1 + random() % 9; left > 0; --left) {
        line += static_cast<char>('a' + random() % 26);
      }
      line += ' ';
    }
  }
  return lines;
}

/// Two workloads of one page, with every glyph already in both caches: its lines' widths alone, and
/// the page drawn. Ours blends in linear light, Cairo codes: edges differ.
void run_text(const Options& options, int size, std::vector<Row>& rows) {
  const auto size_px = static_cast<float>(size);
  const std::vector<std::string> lines = page_of_text(size_px);
  const Font font = Font::sans();
  CairoText cairo(size_px, kWidth, kHeight);
  Image<Srgb8> page(kWidth, kHeight);
  double width = 0, peer_width = 0;
  const auto pen = [&](std::size_t line) {
    return glm::vec2(4, (static_cast<float>(line) + 0.95f) * 1.3f * size_px);
  };
  const auto measure = [&](const std::string& name, auto&& ours, auto&& theirs) {
    std::vector<double> our_ms, peer_ms, ratios;
    constexpr int kWarmUp = 2;
    for (int i = 0; i < options.pairs + kWarmUp; ++i) {
      std::fill(page.pixels().begin(), page.pixels().end(), Srgb8{255, 255, 255, 255});
      cairo.clear();
      const double a = milliseconds_of(ours), b = milliseconds_of(theirs);
      if (i < kWarmUp) continue;
      our_ms.push_back(a);
      peer_ms.push_back(b);
      ratios.push_back(b / a);
    }
    Image<Linear8> codes(kWidth, kHeight);
    for (std::size_t i = 0; i < codes.pixels().size(); ++i) {
      const Srgb8 c = page.pixels()[i];
      codes.pixels()[i] = {c.r, c.g, c.b, c.a};
    }
    if (!options.pictures.empty()) {
      save(options, name + "-ours", codes);
      save(options, name + "-cairo", cairo.picture());
    }
    rows.push_back({name, "cairo", 1, median(our_ms), median(peer_ms), median(ratios),
                    compare(codes, cairo.picture(), kCodesApart)});
  };
  measure(
      fmt::format("width-{}", size),
      [&] {
        width = 0;
        for (const std::string& line : lines) {
          width += static_cast<double>(font.width_px(line, size_px));
        }
      },
      [&] {
        peer_width = 0;
        for (const std::string& line : lines) peer_width += cairo.width_px(line);
      });
  if (std::abs(width / peer_width - 1) > 0.01) {
    throw Error(ErrorKind::kBadInput, "Cairo draws another font: install fonts-dejavu-core");
  }
  measure(
      fmt::format("text-{}", size),
      [&] {
        for (std::size_t i = 0; i < lines.size(); ++i) {
          font.draw(page, pen(i).x, pen(i).y, lines[i], size_px, {0, 0, 0, 255});
        }
      },
      [&] {
        for (std::size_t i = 0; i < lines.size(); ++i) cairo.draw(pen(i), lines[i]);
      });
}

void print_table(const std::vector<Row>& rows) {
  fmt::print("{:<14}{:<12}{:>8}{:>10}{:>10}{:>8}{:>10}{:>8}\n", "workload", "peer", "threads",
             "ours ms", "peer ms", "ratio", "pixels", "psnr");
  for (const Row& r : rows) {
    fmt::print("{:<14}{:<12}{:>8}{:>10.2f}{:>10.2f}{:>8.2f}{:>10}{:>8.1f}\n", r.workload, r.peer,
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
        "{}\n  {{\"workload\": \"{}\", \"peer\": \"{}\", \"threads\": {}, \"ours_ms\": {:.3f}, "
        "\"peer_ms\": {:.3f}, \"ratio\": {:.3f}, \"pixels_differing\": {}, \"psnr_db\": {}}}",
        i ? "," : "", r.workload, r.peer, r.threads, r.ours_ms, r.peer_ms, r.ratio,
        r.difference.pixels_differing, psnr);
  }
  fmt::print("\n]\n");
}

/// Where Inkscape's tiger lies, if it is here.
std::string tiger() {
  for (const char* path :
       {KINESCOPE_SOURCE_DIR "/build/data/tiger.svgz", "/usr/share/inkscape/examples/tiger.svgz"}) {
    if (std::filesystem::exists(path)) return path;
  }
  return {};
}

int run_all(int argc, char** argv) {
  Options options;
  Flags flags(
      "Anti-aliased lines beside AGG, filled paths and text beside Cairo (peers on one thread): "
      "same pictures, interleaved, medians.");
  flags.option("--threads", &options.threads, "threads of ours", Flags::Within{1, 64});
  flags.option("--length", &options.lengths, "mean lengths of 50,000 lines, pixels; 0 for none",
               Flags::Within{0, 100000});
  flags.option("--text", &options.text_sizes, "sizes of a page of text, pixels; 0 for none",
               Flags::Within{0, 400});
  flags.option("--svg", &options.svg,
               "a drawing whose filled paths are drawn; Inkscape's tiger if none",
               Flags::ExistingFile{});
  flags.option("--scale", &options.scale, "of the drawing: 1 makes it 1080 pixels high",
               Flags::Within{0.01, 8.0});
  flags.option("--pairs", &options.pairs, "timed pairs", Flags::Within{1, 1000});
  flags.option("--pictures", &options.pictures, "folder for both last pictures as PNG");
  flags.flag("--json", options.json, "a list of figures instead of the table");
  if (const auto exit = flags.parse(argc, argv)) return *exit;
  if (!options.json) {
    std::fprintf(stderr, "AGG %s (as pkg-config calls it), Cairo %s\n", KINESCOPE_AGG_VERSION,
                 CairoFills::version().c_str());
  }
  if (options.svg.empty()) options.svg = tiger();
  if (options.svg.empty()) {
    std::fprintf(stderr, "the drawing is left out: scripts/setup --data fetches it\n");
  }
  std::vector<Row> rows;
  for (const int length : options.lengths) {
    if (length > 0) run_lines(options, length, rows);
  }
  for (const int size : options.text_sizes) {
    if (size > 0) run_text(options, size, rows);
  }
  if (!options.svg.empty()) run_drawing(options, rows);
  options.json ? print_json(rows) : print_table(rows);
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

int main(int argc, char** argv) {
  return kinescope::bench::run_program("bench_paths", kinescope::bench::run_all, argc, argv);
}
