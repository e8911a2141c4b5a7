// The scalar lookup against definitions computed in double, texel by texel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>
#include <limits>

#include "shading/texture.h"
#include "tests/shading/batch_arrays.h"

namespace kinescope {
namespace {

constexpr Wrap kWraps[] = {Wrap::kRepeat, Wrap::kMirror, Wrap::kClamp};

/// The texel that stands at column (or row) i of the plane that the wrap mode fills with pictures.
int folded(int i, int size, Wrap wrap) {
  if (wrap == Wrap::kClamp) return std::clamp(i, 0, size - 1);
  const int period = wrap == Wrap::kRepeat ? size : 2 * size;
  const int in_period = ((i % period) + period) % period;
  return in_period < size ? in_period : period - 1 - in_period;
}

glm::dvec4 texel(const Texture& texture, int level, int x, int y) {
  const Texture::Level from = texture.view(level);
  const Texel& t =
      from.at(folded(x, from.width(), texture.wrap_u), folded(y, from.height(), texture.wrap_v));
  return glm::dvec4(t.r, t.g, t.b, t.a) / 65535.0;
}

/// Four texels of the wrapped plane around the place, weighted by the opposite areas.
glm::dvec4 bilinear(const Texture& texture, int level, double u, double v) {
  const double x = u * texture.view(level).width() - 0.5;
  const double y = v * texture.view(level).height() - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const double fx = x - x0, fy = y - y0;
  return (1 - fx) * (1 - fy) * texel(texture, level, x0, y0) +
         fx * (1 - fy) * texel(texture, level, x0 + 1, y0) +
         (1 - fx) * fy * texel(texture, level, x0, y0 + 1) +
         fx * fy * texel(texture, level, x0 + 1, y0 + 1);
}

glm::dvec4 trilinear(const Texture& texture, double u, double v, double lod) {
  lod = std::clamp(lod, 0.0, texture.levels() - 1.0);
  const int fine = static_cast<int>(std::floor(lod));
  const int coarse = std::min(fine + 1, texture.levels() - 1);
  const double t = lod - fine;
  return (1 - t) * bilinear(texture, fine, u, v) + t * bilinear(texture, coarse, u, v);
}

void expect_near(LinearRgba found, glm::dvec4 expected, const char* what) {
  EXPECT_NEAR(found.r, expected.r, 1e-5) << what;
  EXPECT_NEAR(found.g, expected.g, 1e-5) << what;
  EXPECT_NEAR(found.b, expected.b, 1e-5) << what;
  EXPECT_NEAR(found.a, expected.a, 1e-5) << what;
}

template <class Check>
void at_many_places(const Check& check) {
  Random random(1);
  for (const auto& [width, height] : {std::pair{16, 8}, {7, 5}, {1, 1}, {1, 6}, {3, 1}, {2, 2}}) {
    for (const Wrap wrap_u : kWraps) {
      for (const Wrap wrap_v : kWraps) {
        Texture texture(noise<Linear8>(random, width, height), Filter::kTrilinear, wrap_u, wrap_v);
        for (int i = 0; i < 200; ++i) {
          check(texture, random.uniform(-2.5f, 2.5f), random.uniform(-2.5f, 2.5f), random);
        }
        // The edges themselves.
        for (const float u : {-1.0f, 0.0f, 1.0f, 2.0f}) check(texture, u, 0.5f - u, random);
      }
    }
  }
}

TEST(TextureSample, NearestIsTheTexelThatHoldsThePlace) {
  at_many_places([](Texture& texture, float u, float v, Random& random) {
    texture.filter = Filter::kNearest;
    const double x = static_cast<double>(u) * texture.view(0).width();
    const double y = static_cast<double>(v) * texture.view(0).height();
    // On the border of two texels either may be taken.
    if (std::abs(x - std::round(x)) < 1e-4 || std::abs(y - std::round(y)) < 1e-4) return;
    expect_near(texture.sample(u, v, random.uniform(-1, 5)),
                texel(texture, 0, static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))),
                "nearest");
  });
}

TEST(TextureSample, BilinearWeightsFourTexelsOfTheFullPicture) {
  at_many_places([](Texture& texture, float u, float v, Random& random) {
    texture.filter = Filter::kBilinear;
    expect_near(texture.sample(u, v, random.uniform(-1, 5)), bilinear(texture, 0, u, v),
                "bilinear");
  });
}

TEST(TextureSample, TrilinearMixesTwoLevels) {
  at_many_places([](Texture& texture, float u, float v, Random& random) {
    const float lod = random.uniform(-2, 7);
    expect_near(texture.sample(u, v, lod), trilinear(texture, u, v, lod), "trilinear");
  });
}

TEST(TextureSample, TrilinearAtAWholeLevelIsBilinearInThatLevel) {
  at_many_places([](Texture& texture, float u, float v, Random&) {
    for (int level = 0; level < texture.levels(); ++level) {
      expect_near(texture.sample(u, v, static_cast<float>(level)), bilinear(texture, level, u, v),
                  "whole level");
    }
    const LinearRgba full = texture.sample(u, v, 0);
    texture.filter = Filter::kBilinear;
    EXPECT_EQ(texture.sample(u, v, 0), full);
    texture.filter = Filter::kTrilinear;
  });
}

TEST(TextureSample, RowZeroIsTheTop) {
  Image<Linear8> picture(2, 2);
  picture.at(0, 0) = {255, 0, 0, 255};
  picture.at(1, 0) = {0, 255, 0, 255};
  picture.at(0, 1) = {0, 0, 255, 255};
  picture.at(1, 1) = {255, 255, 255, 255};
  const Texture texture(picture, Filter::kNearest);
  EXPECT_EQ(texture.sample(0.25f, 0.25f, 0), (LinearRgba{1, 0, 0, 1}));
  EXPECT_EQ(texture.sample(0.75f, 0.25f, 0), (LinearRgba{0, 1, 0, 1}));
  EXPECT_EQ(texture.sample(0.25f, 0.75f, 0), (LinearRgba{0, 0, 1, 1}));
}

TEST(TextureSample, RepeatHasNoGapAtItsEdge) {
  Random random(2);
  const Texture texture(noise<Linear8>(random, 8, 8), Filter::kBilinear);
  for (int i = 0; i < 100; ++i) {
    const float v = random.uniform(0, 1);
    const LinearRgba left = texture.sample(-1e-6f, v, 0), right = texture.sample(1e-6f, v, 0);
    EXPECT_NEAR(left.r, right.r, 1e-4);
    const LinearRgba above = texture.sample(v, -1e-6f, 0), below = texture.sample(v, 1e-6f, 0);
    EXPECT_NEAR(above.g, below.g, 1e-4);
  }
}

TEST(TextureSample, StrangeCoordinatesStayInThePicture) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  const float strange[] = {kInf,    -kInf,       std::numeric_limits<float>::quiet_NaN(),
                           1e30f,   -1e30f,      3e9f,
                           -1e-30f, 16777217.0f, std::numeric_limits<float>::max()};
  for (const Wrap wrap : kWraps) {
    for (const Filter filter : {Filter::kNearest, Filter::kBilinear, Filter::kTrilinear}) {
      const Texture texture(Image<Linear8>(5, 3, Linear8{255, 255, 255, 255}), filter, wrap, wrap);
      for (const float u : strange) {
        for (const float v : strange) {
          for (const float lod : {0.5f, u}) {
            expect_near(texture.sample(u, v, lod), {1, 1, 1, 1}, "strange");
          }
        }
      }
    }
  }
}

TEST(TextureSample, LevelOfDetailIsTheLogarithmOfTheLongerSide) {
  const Texture texture(Image<Linear8>(64, 16));
  EXPECT_NEAR(level_of_detail(texture, 1 / 64.0f, 0, 0, 1 / 16.0f), 0, 1e-6);
  EXPECT_NEAR(level_of_detail(texture, 4 / 64.0f, 0, 0, 1 / 16.0f), 2, 1e-6);
  EXPECT_NEAR(level_of_detail(texture, 1 / 64.0f, 0, 0, 0.5f), 3, 1e-6);
  // 3 texels right and 4 down: a side of 5.
  EXPECT_NEAR(level_of_detail(texture, 3 / 64.0f, 4 / 16.0f, 0, 0), std::log2(5.0), 1e-6);
  EXPECT_LT(level_of_detail(texture, 0, 0, 0, 0), 0);
}

}  // namespace
}  // namespace kinescope
