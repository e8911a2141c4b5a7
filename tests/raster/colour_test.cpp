#include "raster/colour/colour.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "raster/base/simd.h"
#include "raster/colour/encode.h"

namespace kinescope {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// IEC 61966-2-1, written down once more, in the widest type there is.
long double curve(long double x) {
  if (!(x > 0)) return 0;
  if (x >= 1) return 1;
  return x <= 0.0031308L ? 12.92L * x : 1.055L * std::pow(x, 1 / 2.4L) - 0.055L;
}

long rounded(long double code) { return static_cast<long>(std::floor(code + 0.5L)); }

/// The smallest float whose code is `code`, by bisection over the bits.
float first_with(int code) {
  std::uint32_t low = 0, high = std::bit_cast<std::uint32_t>(1.0f);
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (rounded(255 * curve(std::bit_cast<float>(middle))) >= code ? high : low) = middle;
  }
  return std::bit_cast<float>(high);
}

/// All that is interesting: both sides of every step between codes, a walk through all floats, and
/// what no picture should hold.
std::vector<float> values() {
  std::vector<float> all{0.0f,
                         -0.0f,
                         1.0f,
                         -1.0f,
                         kNan,
                         -kNan,
                         kInf,
                         -kInf,
                         1e30f,
                         1e-42f,
                         0x1p-13f,
                         2.0f,
                         std::nextafter(1.0f, 0.0f)};
  for (int code = 1; code < 256; ++code) {
    const float step = first_with(code);
    all.push_back(step);
    all.push_back(std::nextafter(step, 0.0f));
  }
  for (std::uint32_t bits = 0x30000000u; bits < 0x40000000u; bits += 3001) {
    all.push_back(std::bit_cast<float>(bits));
  }
  while (all.size() % 3) all.push_back(0);
  return all;
}

TEST(Srgb, CurveAndItsInverse) {
  EXPECT_EQ(srgb_encode(0), 0);
  EXPECT_EQ(srgb_encode(1), 1);
  EXPECT_EQ(srgb_decode(1), 1);
  EXPECT_FLOAT_EQ(srgb_encode(0.214041140f), 0.5f);
  EXPECT_FLOAT_EQ(srgb_decode(0.5f), 0.214041140f);
  EXPECT_FLOAT_EQ(srgb_decode(0.04f), 0.04f / 12.92f);
  for (const float x : {-1.0f, kNan, -kInf}) EXPECT_EQ(srgb_encode(x), 0) << x;
  for (const float x : {1.5f, kInf}) EXPECT_EQ(srgb_decode(x), 1) << x;
  for (int i = 0; i <= 1000; ++i) {
    const float x = static_cast<float>(i) / 1000;
    EXPECT_NEAR(srgb_decode(srgb_encode(x)), x, 1e-6) << x;
  }
}

TEST(Srgb, EveryCodeDecodesAndEncodesToItself) {
  for (int i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i);
    const Srgb8 colour{code, static_cast<std::uint8_t>(255 - i), 0, code};
    const LinearRgba light = decode(colour);
    EXPECT_EQ(encode_srgb8(light), colour) << i;
    EXPECT_FLOAT_EQ(light.r, srgb_decode(static_cast<float>(i / 255.0))) << i;
    EXPECT_FLOAT_EQ(light.a, static_cast<float>(i) / 255) << i;
  }
}

TEST(Srgb, ScalarCodesAreTheRoundedCurve) {
  for (const float x : values()) {
    const long expected = rounded(255 * curve(x));
    ASSERT_EQ(encode_srgb8(LinearRgb{x, 0, 0}).r, expected) << std::hexfloat << x;
    ASSERT_EQ(encode_srgb8(LinearRgba{0, 0, x, 1}).b, expected) << std::hexfloat << x;
    // At a tie of the curve the last bit of a double may decide.
    ASSERT_NEAR(encode_srgb16(LinearRgb{0, x, 0}).g, 65535 * curve(x), 0.5 + 1e-6) << x;
  }
}

class EncodeRow : public ::testing::Test {
 protected:
  ~EncodeRow() override { use_simd_target("best"); }
};

TEST_F(EncodeRow, EqualsTheScalarCodesOnEveryTarget) {
  const std::vector<float> all = values();
  std::vector<LinearRgb> rgb;
  std::vector<LinearRgba> rgba;
  for (std::size_t i = 0; i + 2 < all.size(); i += 3) {
    rgb.push_back({all[i], all[i + 1], all[i + 2]});
    rgba.push_back({all[i + 1], all[i + 2], all[i], all[i + 1]});
  }
  for (const std::string& target : simd_targets()) {
    use_simd_target(target);
    std::vector<Srgb8> from_rgb(rgb.size()), from_rgba(rgba.size());
    std::vector<Srgb16> deep(rgb.size());
    encode_row(rgb, from_rgb);
    encode_row(rgba, from_rgba);
    encode_row(rgb, deep);
    for (std::size_t i = 0; i < rgb.size(); ++i) {
      ASSERT_EQ(from_rgb[i], encode_srgb8(rgb[i])) << target << ' ' << i;
      ASSERT_EQ(from_rgba[i], encode_srgb8(rgba[i])) << target << ' ' << i;
      const Srgb16 exact = encode_srgb16(rgb[i]);
      ASSERT_NEAR(deep[i].r, exact.r, 1) << target << ' ' << rgb[i].r;
      ASSERT_NEAR(deep[i].g, exact.g, 1) << target << ' ' << rgb[i].g;
      ASSERT_NEAR(deep[i].b, exact.b, 1) << target << ' ' << rgb[i].b;
      ASSERT_EQ(deep[i].a, 65535);
    }
  }
}

TEST_F(EncodeRow, WritesEachLengthAndNothingBeyond) {
  const Srgb8 untouched{1, 2, 3, 4};
  const Srgb16 untouched16{1, 2, 3, 4};
  for (const std::string& target : simd_targets()) {
    use_simd_target(target);
    for (std::size_t length = 0; length <= 40; ++length) {
      const std::vector<LinearRgba> rgba(length, LinearRgba{1, 0.5f, 0, 0.5f});
      const std::vector<LinearRgb> rgb(length, LinearRgb{0, 1, 0.5f});
      std::vector<Srgb8> a(length + 1, untouched), b(length + 1, untouched);
      std::vector<Srgb16> c(length + 1, untouched16);
      encode_row(rgba, a);
      encode_row(rgb, b);
      encode_row(rgb, c);
      for (std::size_t i = 0; i < length; ++i) {
        ASSERT_EQ(a[i], (Srgb8{255, 188, 0, 128}));
        ASSERT_EQ(b[i], (Srgb8{0, 255, 188, 255}));
        ASSERT_EQ(c[i].g, 65535);
      }
      ASSERT_EQ(a[length], untouched);
      ASSERT_EQ(b[length], untouched);
      ASSERT_EQ(c[length], untouched16);
    }
  }
}

}  // namespace
}  // namespace kinescope
