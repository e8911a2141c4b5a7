// The vector lookup against the scalar one, on every instruction set.
#include "shading/texture_lookup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shading/procedural_texture.h"
#include "tests/shading/batch_arrays.h"

namespace kinescope {
namespace {

constexpr int kU = vertex_row::kTexcoord;

struct Case {
  Case(int size_in, bool gradients_in) : size(size_in), gradients(gradients_in) {}

  BatchArrays arrays;
  Surface surface;
  int size;
  bool gradients;

  void expect_agreement(const Texture& texture, const std::string& what) const {
    alignas(64) LinearRgba found[Batch::kMaxSize];
    look_up(texture, arrays.batch(size, surface, gradients), kU, found);
    const auto& g = arrays.gradient;
    for (int i = 0; i < size; ++i) {
      const float lod =
          gradients ? level_of_detail(texture, g[0][i], g[1][i], g[2][i], g[3][i]) : 0.0f;
      const LinearRgba expected =
          texture.sample(arrays.attribute[kU][i], arrays.attribute[kU + 1][i], lod);
      ASSERT_NEAR(found[i].r, expected.r, 1e-4) << what << " fragment " << i << " lod " << lod;
      ASSERT_NEAR(found[i].g, expected.g, 1e-4) << what;
      ASSERT_NEAR(found[i].b, expected.b, 1e-4) << what;
      ASSERT_NEAR(found[i].a, expected.a, 1e-4) << what;
    }
  }
};

/// Gradients of any direction whose lengths run over all levels of the chain and beyond.
void fill(Case& c, Random& random, const Texture& texture) {
  for (int i = 0; i < c.size; ++i) {
    c.arrays.attribute[kU][i] = random.uniform(-3, 3);
    c.arrays.attribute[kU + 1][i] = random.uniform(-3, 3);
    const float lod = random.uniform(-2, static_cast<float>(texture.levels()) + 1);
    const float texels = std::exp2(lod);
    for (int side = 0; side < 2; ++side) {
      const float angle = random.uniform(0, 6.3f), length = texels * random.uniform(0.1f, 1);
      c.arrays.gradient[2 * side][i] =
          length * std::cos(angle) / static_cast<float>(texture.view(0).width());
      c.arrays.gradient[2 * side + 1][i] =
          length * std::sin(angle) / static_cast<float>(texture.view(0).height());
    }
  }
}

TEST(TextureLookup, AgreesWithTheScalarOneInEveryModeAndSize) {
  Random random(1);
  for (const auto& [width, height] :
       {std::pair{64, 64}, {1, 1}, {1, 7}, {37, 21}, {256, 2}, {3, 300}}) {
    for (const Wrap wrap : {Wrap::kRepeat, Wrap::kMirror, Wrap::kClamp}) {
      for (const Filter filter : {Filter::kNearest, Filter::kBilinear, Filter::kTrilinear}) {
        const Wrap wrap_v = static_cast<Wrap>(random.below(3));
        const Texture texture(noise<Srgb8>(random, width, height), filter, wrap, wrap_v);
        for (const int size : {1, 5, 8, 17, 256}) {
          Case c(size, size != 17);
          fill(c, random, texture);
          on_every_target([&](const std::string& target) { c.expect_agreement(texture, target); });
        }
      }
    }
  }
}

TEST(TextureLookup, MagnifiedAndUniformFootprintsAgree) {
  Random random(2);
  const Texture texture(noise<Srgb8>(random, 128, 64));
  for (const float texels : {0.01f, 1.0f, 1.5f, 2.0f, 7.9f, 8.1f, 64.0f, 1000.0f}) {
    Case c(Batch::kMaxSize, true);
    fill(c, random, texture);
    for (int i = 0; i < c.size; ++i) {
      c.arrays.gradient[0][i] = texels / 128;
      c.arrays.gradient[3][i] = texels / 64;
      c.arrays.gradient[1][i] = c.arrays.gradient[2][i] = 0;
    }
    on_every_target([&](const std::string& target) { c.expect_agreement(texture, target); });
  }
}

TEST(TextureLookup, MinifiedCheckerboardTurnsGrey) {
  const Texture texture(labelled_checkerboard(256, 256, 32));
  Case c(Batch::kMaxSize, true);
  Random random(3);
  for (int i = 0; i < c.size; ++i) {
    c.arrays.attribute[kU][i] = random.uniform(0.3f, 0.7f);
    c.arrays.attribute[kU + 1][i] = random.uniform(0.3f, 0.7f);
    c.arrays.gradient[0][i] = c.arrays.gradient[3][i] = 16.0f / 256;
    c.arrays.gradient[1][i] = c.arrays.gradient[2][i] = 0;
  }
  const float grey = (decode(Srgb8{225, 0, 0, 255}).r + decode(Srgb8{140, 0, 0, 255}).r) / 2;
  on_every_target([&](const std::string& target) {
    alignas(64) LinearRgba found[Batch::kMaxSize];
    look_up(texture, c.arrays.batch(c.size, c.surface), kU, found);
    for (const LinearRgba& colour : found) ASSERT_NEAR(colour.g, grey, 2e-4) << target;
  });
}

TEST(TextureLookup, StrangeCoordinatesAndGradientsStayInThePicture) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  const float strange[] = {0.0f,
                           -0.0f,
                           kInf,
                           -kInf,
                           std::numeric_limits<float>::quiet_NaN(),
                           -std::numeric_limits<float>::quiet_NaN(),
                           1e30f,
                           -1e30f,
                           3e9f,
                           -1e-30f,
                           16777217.0f,
                           std::numeric_limits<float>::max(),
                           1e-42f};
  Random random(4);
  const auto any = [&] { return strange[random.below(std::size(strange))]; };
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kMirror, Wrap::kClamp}) {
    for (const Filter filter : {Filter::kNearest, Filter::kBilinear, Filter::kTrilinear}) {
      const Texture texture(Image<Linear8>(9, 5, Linear8{255, 255, 255, 255}), filter, wrap, wrap);
      Case c(Batch::kMaxSize, true);
      for (int i = 0; i < c.size; ++i) {
        c.arrays.attribute[kU][i] = any();
        c.arrays.attribute[kU + 1][i] = any();
        for (auto& gradient : c.arrays.gradient) gradient[i] = any();
      }
      on_every_target([&](const std::string& target) {
        alignas(64) LinearRgba found[Batch::kMaxSize];
        look_up(texture, c.arrays.batch(c.size, c.surface), kU, found);
        for (const LinearRgba& colour : found) {
          ASSERT_NEAR(colour.r, 1, 1e-5) << target;
          ASSERT_NEAR(colour.a, 1, 1e-5) << target;
        }
      });
    }
  }
}

}  // namespace
}  // namespace kinescope
