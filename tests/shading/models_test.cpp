// Every shading model, on every instruction set, against the scalar law.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "shading/surface.h"
#include "tests/shading/batch_arrays.h"

namespace kinescope {
namespace {

constexpr ShadingModel kModels[] = {ShadingModel::kFlat, ShadingModel::kGouraud,
                                    ShadingModel::kPhong, ShadingModel::kBlinn,
                                    ShadingModel::kUnlit};

void expect_near(LinearRgba found, LinearRgba expected, float tolerance, const std::string& what) {
  EXPECT_NEAR(found.r, expected.r, tolerance) << what;
  EXPECT_NEAR(found.g, expected.g, tolerance) << what;
  EXPECT_NEAR(found.b, expected.b, tolerance) << what;
  EXPECT_NEAR(found.a, expected.a, tolerance) << what;
}

LinearRgba composed(const LitColour& lit, LinearRgba texel, float opacity) {
  return {lit.body.x * texel.r + lit.highlight.x, lit.body.y * texel.g + lit.highlight.y,
          lit.body.z * texel.b + lit.highlight.z, opacity * texel.a};
}

std::vector<Light> some_lights(Random& random, int count) {
  std::vector<Light> lights(static_cast<std::size_t>(count));
  for (Light& light : lights) {
    light.kind = static_cast<LightKind>(random.below(3));
    light.position = random.in_cube(-4, 4);
    light.direction = random.direction();
    light.colour = random.in_cube(0, 1.0f / static_cast<float>(count));
    light.attenuation = {1, random.uniform(0, 0.3f), random.uniform(0, 0.1f)};
    light.inner_cone_rad = random.uniform(0, 0.5f);
    light.outer_cone_rad = light.inner_cone_rad + random.uniform(0.1f, 0.6f);
  }
  return lights;
}

Surface some_surface(Random& random) {
  Surface surface;
  surface.eye = random.in_cube(-6, 6);
  surface.ambient = random.in_cube(0, 0.2f);
  surface.material.base_colour = random.in_cube(0, 1);
  surface.material.specular = random.in_cube(0, 1);
  surface.material.emission = random.in_cube(0, 0.1f);
  surface.material.opacity = random.uniform(0, 1);
  surface.material.shininess = std::pow(1000.0f, random.uniform(0, 1));
  surface.material.double_sided = random.below(2) == 1;
  surface.vertex_colours = random.below(2) == 1;
  return surface;
}

/// Fragments as vertex rows; normals are not of unit length, as after interpolation.
void fill(BatchArrays& arrays, Random& random, int size) {
  for (int i = 0; i < size; ++i) {
    arrays.set_position(i, random.in_cube(-1, 1));
    arrays.set_normal(i, random.direction() * random.uniform(0.5f, 1.5f));
    arrays.attribute[vertex_row::kTexcoord][i] = random.uniform(-2, 2);
    arrays.attribute[vertex_row::kTexcoord + 1][i] = random.uniform(-2, 2);
    arrays.set_colour(i, random.in_cube(0, 1));
    arrays.primitive[i] = static_cast<std::uint32_t>(random.below(5));
    for (auto& gradient : arrays.gradient) gradient[i] = random.uniform(-0.1f, 0.1f);
  }
}

LitColour reference(const Surface& surface, const BatchArrays& arrays, int i, bool half_vector) {
  const glm::vec3 n = glm::normalize(arrays.get3(vertex_row::kNormal, i));
  const glm::vec3 colour =
      surface.vertex_colours ? arrays.get3(vertex_row::kColour, i) : glm::vec3(1);
  return light_point(surface, arrays.get3(vertex_row::kPosition, i), n, colour, half_vector);
}

LinearRgba texel_of(const Surface& surface, const BatchArrays& arrays, int i) {
  if (surface.texture == nullptr) return {1, 1, 1, 1};
  const auto& g = arrays.gradient;
  const float lod = level_of_detail(*surface.texture, g[0][i], g[1][i], g[2][i], g[3][i]);
  return surface.texture->sample(arrays.attribute[vertex_row::kTexcoord][i],
                                 arrays.attribute[vertex_row::kTexcoord + 1][i], lod);
}

TEST(Models, PhongAndBlinnEqualTheScalarLawOnEveryTarget) {
  Random random(3);
  const Texture texture(noise<Srgb8>(random, 33, 20));
  for (int scene = 0; scene < 40; ++scene) {
    const std::vector<Light> lights = some_lights(random, random.below(5));
    Surface surface = some_surface(random);
    surface.lights = lights;
    if (scene % 3 == 0) surface.texture = &texture;
    BatchArrays arrays;
    fill(arrays, random, Batch::kMaxSize);
    const Batch batch = arrays.batch(Batch::kMaxSize, surface);
    on_every_target([&](const std::string& target) {
      for (const ShadingModel model : {ShadingModel::kPhong, ShadingModel::kBlinn}) {
        const std::vector<LinearRgba> found = shaded(model, batch);
        for (int i = 0; i < batch.size; ++i) {
          const LitColour lit = reference(surface, arrays, i, model == ShadingModel::kBlinn);
          // A quarter of the 1/255 that the project allows.
          expect_near(found[static_cast<std::size_t>(i)],
                      composed(lit, texel_of(surface, arrays, i), surface.material.opacity), 1e-3f,
                      target);
        }
      }
    });
  }
}

TEST(Models, DoubleSidedNormalsTurnWithTheirTriangleNotWithTheEye) {
  // Near an outline: the normal leans away from the eye, and from a lamp beside the eye; a lamp
  // behind shines on it.
  std::vector<Light> lights(1);
  lights[0].kind = LightKind::kDirectional;
  lights[0].direction = {0, 0, -1};
  Surface surface;
  surface.eye = {0, 0, 8};
  surface.ambient = glm::vec3(0);
  surface.material.base_colour = glm::vec3(1);
  surface.material.double_sided = true;
  surface.lights = lights;
  BatchArrays arrays;
  alignas(64) float facing[Batch::kMaxSize] = {1, -1};
  arrays.set_position(0, {0, 0, 0});
  arrays.set_normal(0, {0.8f, 0, -0.6f});
  arrays.set_position(1, {0, 0, 0});
  arrays.set_normal(1, {0.8f, 0, -0.6f});
  Batch batch = arrays.batch(2, surface, false);
  batch.facing = facing;
  on_every_target([&](const std::string& target) {
    for (const bool mirrored : {false, true}) {
      surface.mirrored = mirrored;
      const std::vector<LinearRgba> found = shaded(ShadingModel::kPhong, batch);
      EXPECT_NEAR(found[mirrored].r, 0.0f, 1e-5f) << target;
      EXPECT_NEAR(found[!mirrored].r, 0.6f, 1e-5f) << target;
    }
  });
}

TEST(Models, HighlightsOfAllExponentsAreExact) {
  // One light in the eye's place: r.v = cos 2a, n.h = cos a for a normal turned by the angle a.
  std::vector<Light> lights(1);
  lights[0].kind = LightKind::kDirectional;
  lights[0].direction = {0, 0, -1};
  Surface surface;
  surface.eye = {0, 0, 8};
  surface.ambient = surface.material.base_colour = glm::vec3(0);
  surface.material.specular = glm::vec3(1);
  surface.lights = lights;
  BatchArrays arrays;
  for (int i = 0; i < Batch::kMaxSize; ++i) {
    const double angle = 1.2 * i * i / (255.0 * 255.0);
    arrays.set_position(i, {0, 0, 0});
    arrays.set_normal(i, glm::vec3(std::sin(angle), 0, std::cos(angle)));
  }
  const Batch batch = arrays.batch(Batch::kMaxSize, surface, false);
  on_every_target([&](const std::string& target) {
    for (const float exponent : {0.0f, 0.1f, 1.0f, 2.0f, 5.0f, 32.0f, 128.0f, 400.0f, 1000.0f}) {
      surface.material.shininess = exponent;
      const std::vector<LinearRgba> phong = shaded(ShadingModel::kPhong, batch);
      const std::vector<LinearRgba> blinn = shaded(ShadingModel::kBlinn, batch);
      for (int i = 0; i < Batch::kMaxSize; ++i) {
        const double angle = 1.2 * i * i / (255.0 * 255.0);
        const double r_v = std::cos(2 * angle);
        if (std::abs(r_v) < 1e-6) continue;  // where exponent 0 jumps
        EXPECT_NEAR(phong[static_cast<std::size_t>(i)].g, r_v > 0 ? std::pow(r_v, exponent) : 0,
                    5e-4)
            << target << " exponent " << exponent << " angle " << angle;
        EXPECT_NEAR(blinn[static_cast<std::size_t>(i)].g, std::pow(std::cos(angle), exponent), 5e-4)
            << target << " exponent " << exponent << " angle " << angle;
      }
    }
  });
}

TEST(Models, AFragmentsColourDependsNeitherOnItsPlaceNorOnItsNeighbours) {
  Random random(4);
  const std::vector<Light> lights = some_lights(random, 3);
  const Texture texture(noise<Srgb8>(random, 64, 64));
  Surface surface = some_surface(random);
  surface.lights = lights;
  surface.texture = &texture;
  const std::vector<LitColour> triangle_light = {
      {{.1f, .2f, .3f}, {.4f, .5f, .6f}}, {}, {{1, 2, 3}, {0, 0, 0}}, {}, {{0, 0, 0}, {3, 2, 1}}};
  surface.triangle_light = triangle_light;
  BatchArrays all;
  fill(all, random, Batch::kMaxSize);
  on_every_target([&](const std::string& target) {
    for (const ShadingModel model : kModels) {
      const std::vector<LinearRgba> whole = shaded(model, all.batch(Batch::kMaxSize, surface));
      for (int size = 1; size <= Batch::kMaxSize; size += size < 40 ? 1 : 27) {
        BatchArrays tail;  // the last `size` fragments alone
        const int first = Batch::kMaxSize - size;
        for (int i = 0; i < size; ++i) {
          for (int k = 0; k < Batch::kMaxAttributes; ++k) {
            tail.attribute[k][i] = all.attribute[k][first + i];
          }
          for (int k = 0; k < 4; ++k) tail.gradient[k][i] = all.gradient[k][first + i];
          tail.primitive[i] = all.primitive[first + i];
        }
        const std::vector<LinearRgba> found = shaded(model, tail.batch(size, surface));
        ASSERT_TRUE(std::equal(found.begin(), found.end(), whole.begin() + first))
            << target << " model " << static_cast<int>(model) << " size " << size;
      }
    }
  });
}

TEST(Models, GouraudLightsVerticesByTheReflectionVector) {
  Random random(5);
  for (const int count : {1, 2, 7, 63, 64, 65, 200}) {
    const std::vector<Light> lights = some_lights(random, 4);
    Surface surface = some_surface(random);
    surface.lights = lights;
    const Texture texture;
    if (count % 2 == 0) surface.texture = &texture;
    const int stride = surface.vertex_colours ? vertex_row::kStrideWithColour : vertex_row::kStride;
    BatchArrays arrays;
    fill(arrays, random, count);
    std::vector<float> rows(static_cast<std::size_t>(count * stride));
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < stride; ++k) {
        rows[static_cast<std::size_t>(i * stride + k)] = arrays.attribute[k][i];
      }
    }
    const bool apart = keeps_highlight_apart(surface);
    const int size = lit_row_size(surface);
    on_every_target([&](const std::string& target) {
      std::vector<float> lit(static_cast<std::size_t>(count * size + 1), -7.0f);
      light_vertices(surface, rows, std::span(lit).first(lit.size() - 1));
      EXPECT_EQ(lit.back(), -7.0f);
      for (int i = 0; i < count; ++i) {
        LitColour expected = reference(surface, arrays, i, false);
        if (!apart) expected.body += expected.highlight;
        const float* row = lit.data() + i * size;
        for (int k = 0; k < 3; ++k) {
          EXPECT_NEAR(row[lit_row::kBody + k], expected.body[k], 1e-3) << target;
          if (!apart) continue;
          EXPECT_NEAR(row[lit_row::kHighlight + k], expected.highlight[k], 1e-3) << target;
        }
        if (!apart) continue;
        EXPECT_EQ(row[lit_row::kTexcoord], arrays.attribute[vertex_row::kTexcoord][i]);
        EXPECT_EQ(row[lit_row::kTexcoord + 1], arrays.attribute[vertex_row::kTexcoord + 1][i]);
      }
    });
  }
}

TEST(Models, LightingNoVerticesIsNothing) { light_vertices(Surface{}, {}, {}); }

TEST(Models, TheTextureMultipliesTheBodyAndLeavesTheHighlight) {
  Image<Linear8> picture(1, 1, Linear8{255, 51, 0, 102});  // 1, 0.2, 0, opacity 0.4
  const Texture texture(picture);
  Surface surface;
  surface.texture = &texture;
  surface.material.opacity = 0.5f;
  const std::vector<LitColour> triangle_light = {{{.5f, .5f, .5f}, {.1f, .2f, .3f}}};
  surface.triangle_light = triangle_light;
  BatchArrays lit, flat;
  for (int i = 0; i < 3; ++i) {
    lit.set3(lit_row::kBody, i, {.5f, .5f, .5f});
    lit.set3(lit_row::kHighlight, i, {.1f, .2f, .3f});
    for (BatchArrays* arrays : {&lit, &flat}) {
      arrays->attribute[6][i] = arrays->attribute[7][i] = 0.3f;
      arrays->primitive[i] = 0;
    }
  }
  const LinearRgba expected{.5f + .1f, .1f + .2f, .3f, .2f};
  on_every_target([&](const std::string& target) {
    expect_near(shaded(ShadingModel::kGouraud, lit.batch(3, surface, false))[2], expected, 1e-5f,
                target);
    expect_near(shaded(ShadingModel::kFlat, flat.batch(3, surface, false))[2], expected, 1e-5f,
                target);
  });
}

TEST(Models, FlatTakesTheLightOfEachFragmentsTriangle) {
  Random random(6);
  std::vector<LitColour> triangle_light(100);
  for (LitColour& lit : triangle_light) lit = {random.in_cube(0, 1), random.in_cube(0, 1)};
  Surface surface;
  surface.triangle_light = triangle_light;
  BatchArrays arrays;
  for (int i = 0; i < 37; ++i) arrays.primitive[i] = static_cast<std::uint32_t>(random.below(100));
  on_every_target([&](const std::string& target) {
    const std::vector<LinearRgba> found =
        shaded(ShadingModel::kFlat, arrays.batch(37, surface, false));
    for (int i = 0; i < 37; ++i) {
      expect_near(found[static_cast<std::size_t>(i)],
                  composed(triangle_light[arrays.primitive[i]], {1, 1, 1, 1}, 1), 1e-6f, target);
    }
  });
}

TEST(Models, UnlitShowsTheSurfacesOwnColour) {
  Random random(7);
  Surface surface = some_surface(random);
  surface.vertex_colours = true;
  BatchArrays arrays;
  fill(arrays, random, 9);
  on_every_target([&](const std::string& target) {
    const std::vector<LinearRgba> found = shaded(ShadingModel::kUnlit, arrays.batch(9, surface));
    for (int i = 0; i < 9; ++i) {
      const glm::vec3 body = surface.material.base_colour * arrays.get3(vertex_row::kColour, i);
      expect_near(
          found[static_cast<std::size_t>(i)],
          composed({body, surface.material.emission}, {1, 1, 1, 1}, surface.material.opacity),
          1e-6f, target);
    }
  });
}

TEST(Models, AHundredLightsAreAllSeen) {
  Random random(8);
  const std::vector<Light> lights = some_lights(random, 100);
  Surface surface = some_surface(random);
  surface.lights = lights;
  BatchArrays arrays;
  fill(arrays, random, 21);
  on_every_target([&](const std::string& target) {
    const std::vector<LinearRgba> found = shaded(ShadingModel::kPhong, arrays.batch(21, surface));
    for (int i = 0; i < 21; ++i) {
      expect_near(
          found[static_cast<std::size_t>(i)],
          composed(reference(surface, arrays, i, false), {1, 1, 1, 1}, surface.material.opacity),
          1e-3f, target);
    }
  });
}

TEST(Models, DegenerateSurfacesGiveFiniteColours) {
  std::vector<Light> lights(3);
  lights[0].position = {0, 0, 0};  // in the point itself
  lights[0].attenuation = {0, 0, 0};
  lights[1].kind = LightKind::kDirectional;
  lights[1].direction = {0, 0, 0};
  lights[2].kind = LightKind::kSpot;
  lights[2].direction = {0, 0, 0};
  lights[2].inner_cone_rad = lights[2].outer_cone_rad = 0;
  Surface surface;
  surface.eye = {0, 0, 0};  // in the point too
  surface.lights = lights;
  surface.material.specular = glm::vec3(1);
  surface.material.shininess = -3;
  BatchArrays arrays;
  arrays.set_position(0, {0, 0, 0});
  arrays.set_normal(0, {0, 0, 0});
  arrays.set_position(1, {0, 0, 0});
  arrays.set_normal(1, {0, 1, 0});
  arrays.set_position(2, {1e18f, 0, 0});
  arrays.set_normal(2, {1e-18f, 0, 0});
  on_every_target([&](const std::string& target) {
    for (const ShadingModel model : {ShadingModel::kPhong, ShadingModel::kBlinn}) {
      for (const LinearRgba& c : shaded(model, arrays.batch(3, surface))) {
        EXPECT_TRUE(std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b)) << target;
      }
    }
  });
}

}  // namespace
}  // namespace kinescope
