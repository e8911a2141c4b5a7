#include "tests/soak/random_frame.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "raster/base/simd.h"
#include "raster/rasterizer.h"
#include "raster/reference_rasterizer.h"
#include "tests/raster/triangle_soup.h"
#include "tests/soak/same_picture.h"

namespace kinescope::soak {
namespace {

/// Numbers that no well-behaved caller sends.
float impossible(RandomTriangles& random) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::array bad = {std::numeric_limits<float>::quiet_NaN(),
                          kInfinity,
                          -kInfinity,
                          3e38f,
                          -3e38f,
                          0.0f,
                          -0.0f,
                          1e-40f,
                          32768.0f,
                          -32768.0f,
                          32768.004f};
  return bad[static_cast<std::size_t>(random.below(static_cast<int>(bad.size())))];
}

void shade_attributes(const Batch& b, LinearRgba* out) {
  const bool gradients = b.du_dx != nullptr;
  for (int i = 0; i < b.size; ++i) {
    const float side = b.facing != nullptr ? b.facing[i] : 0.5f;
    const float first = b.attribute[0] != nullptr ? b.attribute[0][i] : 0.25f;
    out[i] = {static_cast<float>(b.primitive[i] % 64) / 64, first, side,
              gradients ? b.du_dx[i] + b.dv_dy[i] : 1.0f};
  }
}

/// Calls over one set of vertices, and what they point to.
struct Frame {
  explicit Frame(RandomTriangles& random);

  int width, height, samples;
  bool spoilt;
  std::vector<DeviceVertex> vertices;
  std::vector<float> rows;
  std::vector<std::uint32_t> indices, source;
  std::vector<DrawCall> calls;

 private:
  void add_vertices(RandomTriangles& random);
  void add_calls(RandomTriangles& random);
};

Frame::Frame(RandomTriangles& random)
    : width(1 + random.below(random.below(4) ? 100 : 300)),
      height(1 + random.below(random.below(4) ? 80 : 200)),
      samples(std::array{1, 4, 8}[static_cast<std::size_t>(random.below(3))]),
      spoilt(random.below(3) == 0) {
  add_vertices(random);
  add_calls(random);
}

void Frame::add_vertices(RandomTriangles& random) {
  const int triangles = random.below(random.below(3) ? 200 : 2500);
  const TriangleSoup soup = random.soup(triangles, width, height);
  for (std::size_t i = 0; i < 3 * soup.size(); ++i) {
    const TestVertex v = soup.vertex(i);
    vertices.push_back({v.x, v.y, v.z, v.inv_w});
    indices.push_back(static_cast<std::uint32_t>(i));
    if (i % 3 == 0) source.push_back(static_cast<std::uint32_t>(random.below(1000)));
    for (int k = 0; k < Batch::kMaxAttributes; ++k) rows.push_back(random.between(-1, 2));
  }
  if (!spoilt || vertices.empty()) return;
  const auto one_of = [&](auto& values) -> auto& {
    return values[static_cast<std::size_t>(random.below(static_cast<int>(values.size())))];
  };
  for (float DeviceVertex::*value :
       {&DeviceVertex::x_px, &DeviceVertex::y_px, &DeviceVertex::z, &DeviceVertex::inv_w}) {
    for (int n = random.below(8); n > 0; --n) one_of(vertices).*value = impossible(random);
  }
  for (int n = random.below(8); n > 0; --n) one_of(rows) = impossible(random);
  // Shared vertices too.
  for (int n = random.below(40); n > 0; --n) {
    one_of(indices) = static_cast<std::uint32_t>(random.below(static_cast<int>(vertices.size())));
  }
}

void Frame::add_calls(RandomTriangles& random) {
  std::size_t begin = 0;
  while (begin < source.size() || random.below(4) == 0) {
    const auto left = static_cast<int>(source.size() - begin);
    const auto count = static_cast<std::size_t>(random.below(3) ? random.below(left + 1) : left);
    DrawCall call;
    call.vertices = vertices;
    call.indices = std::span(indices).subspan(3 * begin, 3 * count);
    if (random.below(3) == 0) call.source_triangle = std::span(source).subspan(begin, count);
    call.attributes = rows;
    call.attribute_stride = Batch::kMaxAttributes;
    call.attribute_count = random.below(Batch::kMaxAttributes + 1);
    if (call.attribute_count >= 2 && random.below(2)) {
      call.texcoord_attribute = random.below(call.attribute_count - 1);
    }
    call.cull = std::array{CullMode::kNone, CullMode::kBack,
                           CullMode::kFront}[static_cast<std::size_t>(random.below(3))];
    if (random.below(5)) call.shade = shade_attributes;
    calls.push_back(call);
    begin += count;
  }
}

struct Way {
  int threads;
  RasterizerOptions tiles;
  ColourFormat format;
};

Way random_way(RandomTriangles& random, ColourFormat format) {
  const auto side = [&] { return random.below(3) ? 8 * (1 + random.below(8)) : 0; };
  return {1 + random.below(4), {side(), side()}, format};
}

std::string describe(const Frame& frame, const Way& way) {
  return fmt::format("{}x{}, {} samples, {} calls, {} triangles{}, {} threads, tiles {}x{}, {}",
                     frame.width, frame.height, frame.samples, frame.calls.size(),
                     frame.source.size(), frame.spoilt ? " (some spoilt)" : "", way.threads,
                     way.tiles.tile_width, way.tiles.tile_height, simd_target());
}

}  // namespace

std::string check_random_frame(std::uint64_t seed) {
  RandomTriangles random(static_cast<unsigned>(seed));
  const Frame frame(random);
  const std::vector<std::string> targets = simd_targets();
  use_simd_target(
      targets[static_cast<std::size_t>(random.below(static_cast<int>(targets.size())))]);
  const ReferenceImage reference =
      draw_reference(frame.width, frame.height, frame.samples, frame.calls);
  const auto format =
      std::array{ColourFormat::kSrgb8, ColourFormat::kLinear8,
                 ColourFormat::kLinearFloat}[static_cast<std::size_t>(random.below(3))];
  RenderTarget first;
  for (int n = 0; n < 3; ++n) {
    const Way way = random_way(random, format);
    Workers workers(way.threads);
    Rasterizer rasterizer(workers, way.tiles);
    RenderTarget target(frame.width, frame.height, frame.samples, way.format);
    target.keep_depth = true;
    const RasterStats stats = rasterizer.draw(target, frame.calls, true);
    if (stats.visibility_hash != reference.visibility_hash) {
      return "not what the reference shows: " + describe(frame, way);
    }
    if (n == 0) first = target;
    if (!same_picture(first, target)) return "another picture: " + describe(frame, way);
    // The same rasterizer again: its buffers are used already.
    rasterizer.draw(target, frame.calls);
    if (!same_picture(first, target))
      return "another picture the second time: " + describe(frame, way);
  }
  return {};
}

}  // namespace kinescope::soak
