#include "tests/exactness/compare.h"

#include <algorithm>
#include <cstdio>

#include "raster/visibility_hash.h"
#include "tests/exactness/coverage_oracle.h"

namespace kinescope::exactness {
namespace {

using Corners = std::array<Point, 3>;

Corners corners_of(const DrawCall& call, std::size_t triangle) {
  Corners out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = call.indices[3 * triangle + i];
    out[i] = snapped(call.vertices[v].x_px, call.vertices[v].y_px);
  }
  return out;
}

/// Pixels [begin, end) that values in 256ths of a pixel touch, and one more on either side.
struct Range {
  int begin, end;
};
Range pixels_of(std::int64_t a, std::int64_t b, std::int64_t c, int size) {
  const std::int64_t low = (std::min({a, b, c}) >> 8) - 1, high = (std::max({a, b, c}) >> 8) + 2;
  return {static_cast<int>(std::clamp<std::int64_t>(low, 0, size)),
          static_cast<int>(std::clamp<std::int64_t>(high, 0, size))};
}

/// What the samples that a triangle covers add to the hash.
struct Expected {
  std::uint64_t hash = 0, samples = 0;
};
Expected expect(const Corners& c, std::uint32_t id, int width, int height, int samples) {
  const std::span<const SampleOffset> pattern = sample_pattern(samples);
  const CoverageOracle oracle(c);
  const Range columns = pixels_of(c[0].x, c[1].x, c[2].x, width);
  const Range rows = pixels_of(c[0].y, c[1].y, c[2].y, height);
  Expected out;
  for (int y = rows.begin; y < rows.end; ++y) {
    for (int x = columns.begin; x < columns.end; ++x) {
      const auto first = (static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(width) +
                          static_cast<std::uint64_t>(x)) *
                         pattern.size();
      for (std::size_t s = 0; s < pattern.size(); ++s) {
        ++out.samples;
        if (oracle.covers(sample_point(x, y, pattern[s]))) {
          out.hash += sample_hash(first + s, id, Comparer::kDepth);
        }
      }
    }
  }
  return out;
}

}  // namespace

Tally Comparer::compare(const DrawCall& call, int width, int height, int samples) {
  Tally tally;
  tally.triangles = call.indices.size() / 3;
  std::uint64_t expected = 0;
  for (std::size_t i = 0; i < tally.triangles; ++i) {
    const Expected one =
        expect(corners_of(call, i), static_cast<std::uint32_t>(i), width, height, samples);
    expected += one.hash;
    tally.samples += one.samples;
  }
  if (drawn_hash(call, width, height, samples) != expected) {
    tally.differing = count_differing(call, width, height, samples);
  }
  return tally;
}

std::uint64_t Comparer::drawn_hash(const DrawCall& call, int width, int height, int samples) {
  if (target_.width != width || target_.height != height || target_.samples != samples) {
    target_ = RenderTarget(width, height, samples, ColourFormat::kLinear8);
  }
  return rasterizer_.draw(target_, {&call, 1}, true).visibility_hash;
}

std::uint64_t Comparer::count_differing(const DrawCall& call, int width, int height, int samples) {
  std::uint64_t differing = 0;
  for (std::size_t i = 0; i < call.indices.size() / 3; ++i) {
    DrawCall alone = call;
    alone.indices = call.indices.subspan(3 * i, 3);
    const Corners c = corners_of(call, i);
    if (drawn_hash(alone, width, height, samples) == expect(c, 0, width, height, samples).hash) {
      continue;
    }
    if (++differing > 10) continue;
    std::fprintf(stderr, "differs at %d samples in %dx%d: 256ths of a pixel", samples, width,
                 height);
    for (const Point& p : c) {
      std::fprintf(stderr, " (%lld,%lld)", static_cast<long long>(p.x),
                   static_cast<long long>(p.y));
    }
    std::fprintf(stderr, "\n");
  }
  // None alone: then they differ by being drawn together.
  return std::max<std::uint64_t>(differing, 1);
}

}  // namespace kinescope::exactness
