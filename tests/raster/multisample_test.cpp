// Several samples a pixel: where they lie, what they cost, and how they become one colour.
#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "raster/base/error.h"
#include "raster/rasterizer.h"
#include "raster/reference_rasterizer.h"
#include "raster/sample_pattern.h"
#include "tests/raster/triangle_soup.h"

namespace kinescope {
namespace {

TEST(SamplePattern, LiesOnceInEachRowAndColumnOfItsGrid) {
  for (const int samples : {1, 4, 8}) {
    const auto pattern = sample_pattern(samples);
    ASSERT_EQ(pattern.size(), static_cast<std::size_t>(samples));
    std::set<int> columns, rows;
    int sum_x = 0, sum_y = 0;
    for (const SampleOffset& o : pattern) {
      columns.insert(o.x.raw() * samples / 256);
      rows.insert(o.y.raw() * samples / 256);
      EXPECT_EQ(o.x.raw() % 16, 0);
      EXPECT_EQ(o.y.raw() % 16, 0);
      sum_x += o.x.raw() - 128;
      sum_y += o.y.raw() - 128;
    }
    EXPECT_EQ(columns.size(), pattern.size());
    EXPECT_EQ(rows.size(), pattern.size());
    // Their mean is within a sixteenth of the pixel's centre.
    EXPECT_LE(std::abs(sum_x), 16 * samples);
    EXPECT_LE(std::abs(sum_y), 16 * samples);
  }
}

TEST(SamplePattern, FirstOfFourIsAtThreeEighthsAndOneEighth) {
  EXPECT_EQ(sample_pattern(4)[0].x.to_float(), 0.375f);
  EXPECT_EQ(sample_pattern(4)[0].y.to_float(), 0.125f);
  EXPECT_EQ(sample_pattern(8)[7].x.to_float(), 0.9375f);
  EXPECT_EQ(sample_pattern(8)[7].y.to_float(), 0.0625f);
  EXPECT_THROW(sample_pattern(2), Error);
  EXPECT_THROW(sample_pattern(0), Error);
}

LinearRgba colour_of(std::uint32_t triangle) {
  const auto t = static_cast<float>(triangle % 17);
  return {t / 16, 1 - t / 32, 0.25f + t / 64, 0.5f + t / 32};
}

void shade_by_table(const Batch& batch, LinearRgba* out) {
  for (int i = 0; i < batch.size; ++i) out[i] = colour_of(batch.primitive[i]);
}

TEST(Multisample, APixelIsThePlainMeanOfItsSamplesInLinearLight) {
  for (const int samples : {1, 4, 8}) {
    RandomTriangles random(21);
    const TriangleSoup soup = random.soup(300, 70, 50);
    const DrawCall call = soup.call(shade_by_table);
    const ReferenceImage reference = draw_reference(70, 50, samples, {&call, 1});
    Workers workers(2);
    Rasterizer rasterizer(workers);
    RenderTarget linear(70, 50, samples, ColourFormat::kLinearFloat);
    RenderTarget encoded(70, 50, samples);
    linear.clear = encoded.clear = {0.1f, 0.2f, 0.9f, 0};
    rasterizer.draw(linear, {&call, 1});
    rasterizer.draw(encoded, {&call, 1});
    for (int y = 0; y < 50; ++y) {
      for (int x = 0; x < 70; ++x) {
        double r = 0, g = 0, b = 0, a = 0;
        for (int s = 0; s < samples; ++s) {
          const std::uint32_t id =
              reference.id[static_cast<std::size_t>((y * 70 + x) * samples + s)];
          const LinearRgba c = id == ReferenceImage::kNothing ? linear.clear : colour_of(id);
          r += c.r, g += c.g, b += c.b, a += c.a;
        }
        const LinearRgba got = std::get<Image<LinearRgba>>(linear.colour).at(x, y);
        ASSERT_NEAR(got.r, r / samples, 1e-6) << x << "," << y;
        ASSERT_NEAR(got.g, g / samples, 1e-6);
        ASSERT_NEAR(got.b, b / samples, 1e-6);
        ASSERT_NEAR(got.a, a / samples, 1e-6);
        ASSERT_EQ(encoded.srgb8().at(x, y), encode_srgb8(got));
      }
    }
  }
}

TEST(Multisample, HalfCoveredWhiteOnBlackIsHalfTheLightAndCode188) {
  TriangleSoup soup;  // the left half of each sample pattern: two of four, four of eight
  soup.add({-8, -8}, {-8, 24}, {0.5f, 0.5f});
  soup.add({0.5f, 0.5f}, {-8, 24}, {0.5f, 24});
  soup.add({-8, -8}, {0.5f, 0.5f}, {0.5f, -8});
  const DrawCall call = soup.call([](const Batch& batch, LinearRgba* out) {
    std::fill_n(out, batch.size, LinearRgba{1, 1, 1, 1});
  });
  Workers workers(1);
  Rasterizer rasterizer(workers);
  for (const int samples : {4, 8}) {
    RenderTarget target(1, 1, samples);
    rasterizer.draw(target, {&call, 1});
    EXPECT_EQ(target.srgb8().at(0, 0), (Srgb8{188, 188, 188, 255}));
  }
}

std::atomic<int> shades{0};

void count_shades(const Batch& batch, LinearRgba* out) {
  shades += batch.size;
  for (int i = 0; i < batch.size; ++i) out[i] = {};
}

TEST(Multisample, ShadesOncePerPixelAndTriangle) {
  Workers workers(2);
  Rasterizer rasterizer(workers);
  TriangleSoup inside;
  inside.add({-100, -100}, {-100, 300}, {300, -100});
  const DrawCall call = inside.call(count_shades);
  for (const int samples : {1, 4, 8}) {
    RenderTarget target(64, 48, samples);
    shades = 0;
    const RasterStats stats = rasterizer.draw(target, {&call, 1});
    EXPECT_EQ(shades, 64 * 48);
    EXPECT_EQ(stats.fragments, 64u * 48);
  }
  // Cut along a column's middle: each pixel of the column is shaded for both sides.
  TriangleSoup cut;
  cut.add({20.5f, -9000}, {-9000, 0}, {20.5f, 9000});
  cut.add({20.5f, -9000}, {20.5f, 9000}, {9000, 0});
  const DrawCall two = cut.call(count_shades);
  for (const int samples : {4, 8}) {
    RenderTarget target(64, 48, samples);
    shades = 0;
    rasterizer.draw(target, {&two, 1});
    EXPECT_EQ(shades, 64 * 48 + 48);
  }
}

}  // namespace
}  // namespace kinescope
