// One scene, one image: for threads, tiles, instruction sets, and against the scalar reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

#include "raster/base/simd.h"
#include "raster/rasterizer.h"
#include "raster/reference_rasterizer.h"
#include "tests/raster/triangle_soup.h"

namespace kinescope {
namespace {

/// Returns to the best target when a test ends.
class SimdGuard {
 public:
  ~SimdGuard() { use_simd_target("best"); }
};

struct Drawn {
  std::uint64_t hash = 0;
  std::uint64_t triangles = 0;
  Image<LinearRgba> colour;
  bool operator==(const Drawn&) const = default;
};

void shade_by_triangle_and_place(const Batch& batch, LinearRgba* out) {
  for (int i = 0; i < batch.size; ++i) {
    const auto p = static_cast<float>(batch.primitive[i]);
    out[i] = {p * 0.37f, batch.attribute[0][i], batch.attribute[1][i], 1};
  }
}

struct TestScene {
  TestScene(int count, int width, int height, unsigned seed)
      : soup(RandomTriangles(seed).soup(count, width, height)) {
    RandomTriangles random(seed + 1);
    for (std::size_t i = 0; i < 2 * 3 * soup.size(); ++i) rows.push_back(random.between(0, 1));
  }
  /// Three calls over the same triangles, so that calls mix in every tile.
  std::vector<DrawCall> calls() const {
    std::vector<DrawCall> out;
    const std::size_t third = soup.size() / 3;
    for (std::size_t i = 0; i < 3; ++i) {
      DrawCall c = soup.call(shade_by_triangle_and_place, CullMode::kNone);
      const std::size_t end = i == 2 ? soup.size() : (i + 1) * third;
      c.indices = c.indices.subspan(3 * i * third, 3 * (end - i * third));
      c.attributes = rows;
      c.attribute_count = c.attribute_stride = 2;
      out.push_back(c);
    }
    return out;
  }
  TriangleSoup soup;
  std::vector<float> rows;
};

Drawn draw(const TestScene& scene, int width, int height, int samples, int threads,
           RasterizerOptions options = {}) {
  Workers workers(threads);
  Rasterizer rasterizer(workers, options);
  RenderTarget target(width, height, samples, ColourFormat::kLinearFloat);
  const auto calls = scene.calls();
  const RasterStats stats = rasterizer.draw(target, calls, true);
  return {stats.visibility_hash, stats.drawn, std::get<Image<LinearRgba>>(target.colour)};
}

TEST(Determinism, EqualsTheReferenceOnEveryInstructionSet) {
  const SimdGuard guard;
  for (const int samples : {1, 4, 8}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const TestScene scene(700, 150, 110, seed);
      const auto calls = scene.calls();
      const ReferenceImage reference = draw_reference(150, 110, samples, calls);
      for (const std::string& name : simd_targets()) {
        use_simd_target(name);
        EXPECT_EQ(draw(scene, 150, 110, samples, 2).hash, reference.visibility_hash)
            << name << ", " << samples << " samples, seed " << seed;
      }
      use_simd_target("best");
    }
  }
}

/// Depth and visibility sample by sample: a hash alone would not say where they part.
TEST(Determinism, DepthEqualsTheReferenceBitByBit) {
  const TestScene scene(500, 97, 61, 9);
  const auto calls = scene.calls();
  for (const int samples : {1, 4, 8}) {
    const ReferenceImage reference = draw_reference(97, 61, samples, calls);
    Workers workers(2);
    Rasterizer rasterizer(workers);
    RenderTarget target(97, 61, samples);
    target.keep_depth = true;
    rasterizer.draw(target, calls);
    for (int y = 0; y < 61; ++y) {
      for (int x = 0; x < 97; ++x) {
        ASSERT_EQ(target.depth.at(x, y),
                  reference.depth[static_cast<std::size_t>((y * 97 + x) * samples)])
            << x << "," << y;
      }
    }
  }
}

/// Layers over the whole target, some crossing, some at one depth: what hides whole tiles must not
/// hide a sample that the reference shows.
TEST(Determinism, LayersInAnyOrderEqualTheReference) {
  for (const int samples : {1, 4}) {
    for (unsigned seed = 0; seed < 6; ++seed) {
      RandomTriangles random(seed);
      TriangleSoup soup;
      for (int i = 0; i < 24; ++i) {
        const float base = seed % 3 == 0   ? static_cast<float>(24 - i) / 26
                           : seed % 3 == 1 ? static_cast<float>(i) / 26
                                           : 0.5f;
        const float tilt = i % 3 == 0 ? 0.0f : 0.03f;
        const auto corner = [&](float x, float y) {
          return TestVertex{x, y, base + random.between(0, tilt)};
        };
        const auto a = corner(-9, -9), b = corner(-9, 120), c = corner(170, 120);
        soup.add(a, b, c);
        soup.add(a, c, corner(170, -9));
        for (int k = 0; k < 20; ++k) {
          const auto t = random.triangle(random.between(0, 160), random.between(0, 110), 12);
          soup.add(t[0], t[1], t[2]);
        }
      }
      const DrawCall call = soup.call(nullptr);
      Workers workers(2);
      Rasterizer rasterizer(workers);
      RenderTarget target(160, 110, samples);
      EXPECT_EQ(rasterizer.draw(target, {&call, 1}, true).visibility_hash,
                draw_reference(160, 110, samples, {&call, 1}).visibility_hash)
          << samples << " samples, seed " << seed;
    }
  }
}

/// On every instruction set, in tiles of several sides.
void expect_the_reference(const DrawCall& call, int width, int height, int samples) {
  const SimdGuard guard;
  const std::uint64_t want = draw_reference(width, height, samples, {&call, 1}).visibility_hash;
  for (const std::string& name : simd_targets()) {
    use_simd_target(name);
    for (const auto& [tile_width, tile_height] :
         {std::pair{0, 0}, {8, 8}, {24, 40}, {56, 16}, {64, 64}}) {
      Workers workers(2);
      Rasterizer rasterizer(workers, {tile_width, tile_height});
      RenderTarget target(width, height, samples);
      EXPECT_EQ(rasterizer.draw(target, {&call, 1}, true).visibility_hash, want)
          << name << ", " << samples << " samples, tiles of " << tile_width << "x" << tile_height;
    }
  }
}

/// Triangles of a pixel or less, on pixels' centres and corners among others, many at one depth:
/// they are told and finished before they reach a tile.
TEST(Determinism, TrianglesOfAPixelEqualTheReference) {
  constexpr int kWidth = 139, kHeight = 90;
  RandomTriangles random(5);
  TriangleSoup soup;
  for (int i = 0; i < 6000; ++i) {
    const auto t = random.triangle(random.between(-1, kWidth + 1), random.between(-1, kHeight + 1),
                                   random.between(0.1f, 1.5f));
    soup.add(t[0], t[1], t[2]);
  }
  const DrawCall call = soup.call(nullptr);
  for (const int samples : {1, 4}) expect_the_reference(call, kWidth, kHeight, samples);
}

/// Triangles of middle size many layers deep, among them thin ones that cross several tiles; depths
/// repeat, so that of equals the first must win where later ones are left out as hidden.
TEST(Determinism, DeepMediumTrianglesEqualTheReference) {
  constexpr int kWidth = 139, kHeight = 90;
  RandomTriangles random(31);
  TriangleSoup soup;
  for (int i = 0; i < 2500; ++i) {
    const float x = random.between(-9, kWidth + 9), y = random.between(-9, kHeight + 9);
    const float z = std::floor(random.between(0, 12)) / 13;
    const float tilt = i % 3 == 0 ? 0.05f : 0.0f;
    const auto corner = [&](float dx, float dy) {
      return TestVertex{x + dx, y + dy, z + random.between(0, tilt)};
    };
    if (i % 2 == 0) {
      const float width = random.between(10, 31);
      soup.add(corner(0, 0), corner(random.between(-width, 0), width), corner(width, 0));
    } else {
      const float dx = random.between(-62, 62), dy = random.between(-62, 62);
      soup.add(corner(0, 0), corner(dx, dy), corner(dx + random.between(-9, 9), dy));
    }
  }
  const DrawCall call = soup.call(nullptr, CullMode::kNone);
  for (const int samples : {1, 4, 8}) expect_the_reference(call, kWidth, kHeight, samples);
}

TEST(Determinism, SameForAnyThreadCount) {
  for (const int samples : {1, 4, 8}) {
    const TestScene scene(3000, 200, 160, 11);
    const Drawn one = draw(scene, 200, 160, samples, 1);
    EXPECT_NE(one.hash, 0u);
    for (const int threads : {2, 8}) EXPECT_EQ(draw(scene, 200, 160, samples, threads), one);
  }
}

TEST(Determinism, SameForAnyTileSize) {
  for (const int samples : {1, 4}) {
    const TestScene scene(900, 143, 131, 12);
    const Drawn usual = draw(scene, 143, 131, samples, 2);
    for (const auto& [w, h] : {std::pair{8, 8}, {16, 64}, {24, 40}, {64, 64}, {64, 8}}) {
      EXPECT_EQ(draw(scene, 143, 131, samples, 2, {w, h}), usual) << w << "x" << h;
    }
  }
}

void shade_all_that_a_batch_holds(const Batch& batch, LinearRgba* out) {
  for (int i = 0; i < batch.size; ++i) {
    const float place = static_cast<float>(batch.x[i]) + 1000.0f * static_cast<float>(batch.y[i]);
    const float mark = static_cast<float>(batch.primitive[i]) * batch.facing[i];
    const float steps =
        batch.du_dx[i] + 3 * batch.dv_dx[i] + 5 * batch.du_dy[i] + 7 * batch.dv_dy[i];
    out[i] = {place, mark, steps, batch.attribute[0][i] + 3 * batch.attribute[4][i]};
  }
}
void shade_nothing(const Batch& batch, LinearRgba* out) {
  std::fill_n(out, batch.size, LinearRgba{0, 0, 0, 0});
}

/// Whole blocks have a road of their own, save where something is blended in the tile: both must
/// lead to the same bits.
TEST(Determinism, SameWhetherBlocksAreShadedWholeOrByFragment) {
  const SimdGuard guard;
  TriangleSoup soup;
  RandomTriangles random(21);
  for (int i = 0; i < 60; ++i) {  // large ones, so that blocks have from one owner to many
    const auto vertex = [&](float x, float y) {
      return TestVertex{x, y, random.between(0, 1), random.between(0.2f, 3)};
    };
    const float x = random.between(-50, 200), y = random.between(-50, 150);
    soup.add(vertex(x, y), vertex(x + random.between(-90, 90), y + random.between(-90, 90)),
             vertex(x + random.between(-90, 90), y + random.between(-90, 90)));
  }
  std::vector<float> rows(3 * soup.size() * 5);
  for (float& value : rows) value = random.between(-2, 2);
  DrawCall call = soup.call(shade_all_that_a_batch_holds);
  call.attributes = rows;
  call.attribute_count = call.attribute_stride = 5;
  call.texcoord_attribute = 2;
  TriangleSoup unseen;
  unseen.add({-10, -10, 0}, {-10, 900, 0}, {900, -10, 0});
  DrawCall veil = unseen.call(shade_nothing);
  veil.blend = BlendMode::kAlpha;
  const std::vector<DrawCall> plain = {call}, veiled = {call, veil};
  for (const std::string& name : simd_targets()) {
    use_simd_target(name);
    Workers workers(2);
    Rasterizer rasterizer(workers);
    RenderTarget blocks(200, 160, 1, ColourFormat::kLinearFloat), fragments = blocks;
    rasterizer.draw(blocks, plain);
    rasterizer.draw(fragments, veiled);
    const auto& expected = std::get<Image<LinearRgba>>(fragments.colour);
    const auto& found = std::get<Image<LinearRgba>>(blocks.colour);
    for (int y = 0; y < 160; ++y) {
      for (int x = 0; x < 200; ++x) {
        ASSERT_EQ(found.at(x, y), expected.at(x, y)) << name << " " << x << "," << y;
      }
    }
  }
}

TEST(Determinism, SameFrameAfterFrame) {
  const TestScene scene(900, 90, 80, 13), other(2000, 64, 200, 14);
  Workers workers(2);
  Rasterizer rasterizer(workers);
  RenderTarget small(90, 80, 4), tall(64, 200, 1);
  const auto calls = scene.calls(), other_calls = other.calls();
  const RasterStats first = rasterizer.draw(small, calls, true);
  const Image<Srgb8> picture = small.srgb8();
  rasterizer.draw(tall, other_calls, true);
  const RasterStats again = rasterizer.draw(small, calls, true);
  EXPECT_EQ(first.visibility_hash, again.visibility_hash);
  EXPECT_EQ(first.fragments, again.fragments);
  EXPECT_EQ(picture, small.srgb8());
}

TEST(Determinism, TheHashSeesOneTriangleAndOneBitOfDepth) {
  TriangleSoup a, b, c;
  a.add({0, 0, 0.5f}, {0, 8, 0.5f}, {8, 8, 0.5f});
  const float z = std::nextafter(0.5f, 1.0f);
  b.add({0, 0, z}, {0, 8, z}, {8, 8, z});
  c.add({20, 20}, {20, 20}, {20, 20});  // covers nothing, but the next triangle's number is 1
  c.add({0, 0, 0.5f}, {0, 8, 0.5f}, {8, 8, 0.5f});
  Workers workers(1);
  Rasterizer rasterizer(workers);
  RenderTarget target(8, 8);
  std::set<std::uint64_t> hashes;
  for (const TriangleSoup* soup : {&a, &b, &c}) {
    const DrawCall call = soup->call(nullptr);
    hashes.insert(rasterizer.draw(target, {&call, 1}, true).visibility_hash);
  }
  EXPECT_EQ(hashes.size(), 3u);
  EXPECT_EQ(rasterizer.draw(target, {}, true).visibility_hash, 0u);
}

/// Threads that shade wait for one another here.
struct Meeting {
  std::mutex mutex;
  std::condition_variable arrival;
  std::set<std::thread::id> seen;
  std::size_t wanted = 0;
};

void shade_when_all_have_met(const Batch& batch, LinearRgba* out) {
  Meeting& meeting = *static_cast<Meeting*>(const_cast<void*>(batch.constants));
  std::unique_lock lock(meeting.mutex);
  meeting.seen.insert(std::this_thread::get_id());
  meeting.arrival.notify_all();
  // Waits long only where the test is about to fail.
  meeting.arrival.wait_for(lock, std::chrono::seconds(100),
                           [&] { return meeting.seen.size() >= meeting.wanted; });
  meeting.wanted = 0;
  for (int i = 0; i < batch.size; ++i) out[i] = {};
}

TEST(Determinism, AsManyThreadsShadeAsWereAskedFor) {
  TriangleSoup soup;
  soup.add({0, 0}, {0, 600}, {600, 0});
  for (const std::size_t threads : {1u, 2u, 8u}) {
    Meeting meeting;
    meeting.wanted = threads;
    Workers workers(static_cast<int>(threads));
    Rasterizer rasterizer(workers, {32, 32});
    RenderTarget target(300, 300);
    DrawCall call = soup.call(shade_when_all_have_met);
    call.constants = &meeting;
    rasterizer.draw(target, {&call, 1});
    EXPECT_EQ(meeting.seen.size(), threads);
  }
}

}  // namespace
}  // namespace kinescope
