// Scan conversion beside named peers, one thread each, interleaved, medians: Bresenham's lines
// (SDL), a polygon of a million edges (Cairo), a flood fill of a maze (itself).
#include <SDL.h>
#include <cairo.h>

#include <cstdio>
#include <glm/common.hpp>
#include <random>
#include <vector>

#include "bench/program.h"
#include "bench/statistics.h"
#include "raster/fill/flood_fill.h"
#include "raster/fill/scanline_fill.h"
#include "raster/line.h"
#include "raster/scan/sinks.h"

namespace kinescope::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080, kPairs = 9;

template <typename Ours, typename Theirs>
void contest(const char* name, const char* peer, Ours&& ours, Theirs&& theirs) {
  std::vector<double> our_ms, their_ms, ratios;
  for (int i = 0; i < kPairs + 1; ++i) {
    const double a = milliseconds_of(ours), b = milliseconds_of(theirs);
    if (i == 0) continue;  // warms up
    our_ms.push_back(a);
    their_ms.push_back(b);
    ratios.push_back(b / a);
  }
  std::printf("%-16s %-8s ours %9.2f ms  peer %9.2f ms  ratio %6.2f\n", name, peer, median(our_ms),
              median(their_ms), median(ratios));
}

void lines(int mean_length) {
  struct Line {
    int x0, y0, x1, y1;
  };
  std::mt19937 random(1);
  std::uniform_int_distribution<int> x(0, kWidth - 1), y(0, kHeight - 1),
      length(-mean_length, mean_length);
  std::vector<Line> all;
  for (int i = 0; i < 50000; ++i) {
    const int u = x(random), v = y(random);
    all.push_back({u, v, std::clamp(u + 2 * length(random), 0, kWidth - 1),
                   std::clamp(v + 2 * length(random), 0, kHeight - 1)});
  }
  Image<std::uint32_t> image(kWidth, kHeight);
  SDL_Surface* surface =
      SDL_CreateRGBSurfaceWithFormat(0, kWidth, kHeight, 32, SDL_PIXELFORMAT_XRGB8888);
  SDL_Renderer* renderer = SDL_CreateSoftwareRenderer(surface);
  SDL_SetRenderDrawColor(renderer, 255, 255, 255, 255);
  char name[32];
  std::snprintf(name, sizeof name, "lines-%d", mean_length);
  contest(
      name, "SDL",
      [&] {
        std::uint32_t* pixels = image.pixels().data();
        for (const Line& l : all) {
          bresenham(l.x0, l.y0, l.x1, l.y1,
                    [&](int px, int py) { pixels[py * kWidth + px] = 0xffffffffu; });
        }
      },
      [&] {
        for (const Line& l : all) SDL_RenderDrawLine(renderer, l.x0, l.y0, l.x1, l.y1);
        SDL_RenderFlush(renderer);
      });
  SDL_DestroyRenderer(renderer);
  SDL_FreeSurface(surface);
}

/// A walk of a million steps whose mean height is four rows.
void polygon() {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> aside(-6, 6), down(-8, 8);
  Contour walk;
  glm::dvec2 at(kWidth / 2, kHeight / 2);
  for (int i = 0; i < 1000000; ++i) {
    at = glm::clamp(at + glm::dvec2(aside(random), down(random)), glm::dvec2(0),
                    glm::dvec2(kWidth, kHeight));
    walk.push_back(at);
  }
  const Polygon polygon{walk};
  Image<std::uint8_t> image(kWidth, kHeight);
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_A8, kWidth, kHeight);
  cairo_t* cairo = cairo_create(surface);
  for (const glm::dvec2 p : walk) cairo_line_to(cairo, p.x, p.y);
  cairo_close_path(cairo);
  cairo_path_t* path = cairo_copy_path(cairo);
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
  for (const auto& [antialias, name] : {std::pair{CAIRO_ANTIALIAS_NONE, "polygon-10^6"},
                                        std::pair{CAIRO_ANTIALIAS_DEFAULT, "(smooth peer)"}}) {
    cairo_set_antialias(cairo, antialias);
    contest(
        name, "Cairo",
        [&] {
          scanline_fill(polygon, FillRule::kEvenOdd, {0, 0, kWidth, kHeight},
                        ImageSink(image, std::uint8_t{255}));
        },
        [&] {
          cairo_new_path(cairo);
          cairo_append_path(cairo, path);
          cairo_fill(cairo);
          cairo_surface_flush(surface);
        });
  }
  cairo_path_destroy(path);
  cairo_destroy(cairo);
  cairo_surface_destroy(surface);
}

/// Corridors a pixel wide, a random spanning tree of a binary-tree maze.
void maze() {
  constexpr int kSide = 4096;
  Image<std::uint8_t> image(kSide, kSide);
  std::mt19937 random(3);
  for (int y = 1; y < kSide; y += 2) {
    for (int x = 1; x < kSide; x += 2) {
      image.at(x, y) = 1;
      const bool up = y > 1 && (x == 1 || random() % 2);
      if (up) image.at(x, y - 1) = 1;
      if (!up && x > 1) image.at(x - 1, y) = 1;
    }
  }
  std::int64_t pixels = 0, deepest = 0;
  const double ms = milliseconds_of([&] {
    auto fill = flood_filler(image, 1, 1, Connectivity::kFour);
    while (fill.next()) {
      pixels += fill.span().length();
      deepest = std::max(deepest, static_cast<std::int64_t>(fill.stack().size()));
    }
  });
  std::printf("%-16s %lld pixels in %.1f ms, %.1f ns each; stack at most %lld ranges\n",
              "maze-4096", static_cast<long long>(pixels), ms,
              ms * 1e6 / static_cast<double>(pixels), static_cast<long long>(deepest));
}

int run_all(int, char**) {
  std::printf("Cairo %s, SDL %d.%d.%d\n", cairo_version_string(), SDL_MAJOR_VERSION,
              SDL_MINOR_VERSION, SDL_PATCHLEVEL);
  lines(20);
  lines(200);
  polygon();
  maze();
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

#undef main
int main(int argc, char** argv) {
  return kinescope::bench::run_program("bench_scan", kinescope::bench::run_all, argc, argv);
}
