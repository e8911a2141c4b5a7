// Ambient, diffuse and specular light of one point against the textbook's formulas in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "shading/surface.h"
#include "tests/shading/batch_arrays.h"

namespace kinescope {
namespace {

const glm::vec3 kUp(0, 0, 1);
const glm::vec3 kWhite(1);

void expect_near(glm::vec3 found, glm::dvec3 expected, double tolerance) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(static_cast<double>(found[k]), expected[k], tolerance) << "component " << k;
  }
}

/// A light so far along `way` that nothing but its direction counts.
Light sun(glm::vec3 way) {
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = -way;
  return light;
}

Surface plain(std::span<const Light> lights) {
  Surface surface;
  surface.material.base_colour = {0.5f, 0.25f, 1.0f};
  surface.ambient = glm::vec3(0);
  surface.eye = {0, 0, 10};
  surface.lights = lights;
  return surface;
}

TEST(Illumination, AmbientIsTheBodyColourTimesTheAmbientLight) {
  Surface surface = plain({});
  surface.ambient = {0.2f, 0.4f, 0.1f};
  const LitColour lit = light_point(surface, {0, 0, 0}, kUp, {1, 0.5f, 1}, false);
  expect_near(lit.body, {0.1, 0.05, 0.1}, 1e-7);
  expect_near(lit.highlight, {0, 0, 0}, 0);
}

TEST(Illumination, EmissionAddsAndIsNoPartOfTheBody) {
  Surface surface = plain({});
  surface.material.emission = {0.1f, 2.0f, 0};
  const LitColour lit = light_point(surface, {0, 0, 0}, kUp, kWhite, false);
  expect_near(lit.body, {0, 0, 0}, 0);
  expect_near(lit.highlight, {0.1, 2.0, 0}, 1e-7);
}

TEST(Illumination, DiffuseFollowsTheCosine) {
  for (double angle = 0; angle < 3.2; angle += 0.1) {
    const std::vector<Light> lights = {sun(glm::vec3(std::sin(angle), 0, std::cos(angle)))};
    const LitColour lit = light_point(plain(lights), {0, 0, 0}, kUp, kWhite, false);
    const double cosine = std::max(0.0, std::cos(angle));
    expect_near(lit.body, glm::dvec3(0.5, 0.25, 1.0) * cosine, 1e-6);
  }
}

TEST(Illumination, ReflectionVectorHighlightByHand) {
  // Light at 40 degrees on one side, eye at 30 on the other: 10 degrees between r and v.
  const double degree = std::acos(-1.0) / 180;
  const std::vector<Light> lights = {
      sun(glm::vec3(std::sin(40 * degree), 0, std::cos(40 * degree)))};
  Surface surface = plain(lights);
  surface.eye = glm::vec3(-5 * std::sin(30 * degree), 0, 5 * std::cos(30 * degree));
  surface.material.specular = {0.3f, 0.6f, 0.9f};
  for (const float exponent : {1.0f, 2.0f, 10.0f, 32.0f, 200.0f, 1000.0f}) {
    surface.material.shininess = exponent;
    const double phong = std::pow(std::cos(10 * degree), exponent);
    expect_near(light_point(surface, {0, 0, 0}, kUp, kWhite, false).highlight,
                glm::dvec3(0.3, 0.6, 0.9) * phong, 1e-4);
    // The half vector stands 5 degrees off the normal.
    const double blinn = std::pow(std::cos(5 * degree), exponent);
    expect_near(light_point(surface, {0, 0, 0}, kUp, kWhite, true).highlight,
                glm::dvec3(0.3, 0.6, 0.9) * blinn, 1e-4);
  }
}

TEST(Illumination, MirrorDirectionGivesTheFullHighlight) {
  const std::vector<Light> lights = {sun(kUp)};
  Surface surface = plain(lights);
  surface.material.specular = glm::vec3(1);
  for (const float exponent : {0.0f, 1.0f, 32.0f, 1000.0f}) {
    surface.material.shininess = exponent;
    for (const bool half : {false, true}) {
      expect_near(light_point(surface, {0, 0, 0}, kUp, kWhite, half).highlight, glm::dvec3(1),
                  1e-6);
    }
  }
}

TEST(Illumination, LightFromBehindGivesNothing) {
  // The eye sees the side that the light does not reach, and would stand in its mirror direction.
  const std::vector<Light> lights = {sun({0.6f, 0, -0.8f})};
  Surface surface = plain(lights);
  surface.eye = {-6, 0, -8};
  surface.material.specular = glm::vec3(1);
  surface.material.shininess = 1;
  for (const bool half : {false, true}) {
    const LitColour lit = light_point(surface, {0, 0, 0}, kUp, kWhite, half);
    expect_near(lit.body, {0, 0, 0}, 0);
    expect_near(lit.highlight, {0, 0, 0}, 0);
  }
}

TEST(Illumination, DoubleSidedNormalsFaceTheEye) {
  const std::vector<Light> lights = {sun(kUp)};
  Surface surface = plain(lights);
  surface.material.specular = glm::vec3(1);
  const LitColour front = light_point(surface, {0, 0, 0}, kUp, kWhite, false);
  expect_near(light_point(surface, {0, 0, 0}, -kUp, kWhite, false).body, {0, 0, 0}, 0);
  surface.material.double_sided = true;
  const LitColour back = light_point(surface, {0, 0, 0}, -kUp, kWhite, false);
  expect_near(back.body, front.body, 0);
  expect_near(back.highlight, front.highlight, 0);
  // Seen from the side that the light does not reach, a sheet is dark.
  surface.eye = {0, 0, -10};
  expect_near(light_point(surface, {0, 0, 0}, kUp, kWhite, false).body, {0, 0, 0}, 0);
}

/// All terms by their definitions, in double.
LitColour oracle(const Surface& s, glm::dvec3 p, glm::dvec3 n, glm::dvec3 colour, bool half) {
  const glm::dvec3 v = glm::normalize(glm::dvec3(s.eye) - p);
  if (s.material.double_sided && glm::dot(n, v) < 0) n = -n;
  glm::dvec3 body(s.ambient), highlight(0);
  for (const Light& light : s.lights) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(light.direction));
    const glm::dvec3 way = glm::dvec3(light.position) - p;
    const double d = glm::length(way);
    const glm::dvec3 l = light.kind == LightKind::kDirectional ? -axis : way / d;
    glm::dvec3 arriving = light.colour;
    if (light.kind != LightKind::kDirectional) {
      const glm::dvec3 k = light.attenuation;
      arriving /= k.x + k.y * d + k.z * d * d;
    }
    if (light.kind == LightKind::kSpot) {
      const double inner = std::cos(static_cast<double>(light.inner_cone_rad));
      const double outer = std::cos(static_cast<double>(light.outer_cone_rad));
      const double t = std::clamp((-glm::dot(l, axis) - outer) / (inner - outer), 0.0, 1.0);
      arriving *= t * t * (3 - 2 * t);
    }
    if (glm::dot(n, l) <= 0) continue;
    body += glm::dot(n, l) * arriving;
    const double cosine =
        half ? glm::dot(n, glm::normalize(l + v)) : glm::dot(2 * glm::dot(n, l) * n - l, v);
    if (cosine > 0) {
      highlight += std::pow(cosine, static_cast<double>(s.material.shininess)) * arriving;
    }
  }
  return {glm::dvec3(s.material.base_colour) * colour * body,
          glm::dvec3(s.material.specular) * highlight + glm::dvec3(s.material.emission)};
}

TEST(Illumination, AnyScenesAgreeWithTheFormulas) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    std::vector<Light> lights(static_cast<std::size_t>(random.below(6)));
    for (Light& light : lights) {
      light.kind = static_cast<LightKind>(random.below(3));
      light.position = random.in_cube(-4, 4);
      light.direction = random.direction() * random.uniform(0.5f, 2.0f);
      light.colour = random.in_cube(0, 1);
      light.attenuation = {1, random.uniform(0, 0.3f), random.uniform(0, 0.1f)};
      light.inner_cone_rad = random.uniform(0, 0.5f);
      light.outer_cone_rad = light.inner_cone_rad + random.uniform(0.1f, 0.6f);
    }
    Surface surface = plain(lights);
    surface.eye = random.in_cube(-6, 6);
    surface.ambient = random.in_cube(0, 0.2f);
    surface.material.base_colour = random.in_cube(0, 1);
    surface.material.specular = random.in_cube(0, 1);
    surface.material.emission = random.in_cube(0, 0.1f);
    surface.material.shininess = std::pow(1000.0f, random.uniform(0, 1));
    surface.material.double_sided = random.below(2) == 1;
    const glm::vec3 p = random.in_cube(-1, 1), n = random.direction(), c = random.in_cube(0, 1);
    for (const bool half : {false, true}) {
      const LitColour found = light_point(surface, p, n, c, half);
      const LitColour expected = oracle(surface, p, glm::normalize(glm::dvec3(n)), c, half);
      expect_near(found.body, expected.body, 1e-5);
      // A float's rounding of the cosine, times the exponent.
      expect_near(found.highlight, expected.highlight, 2e-3);
    }
  }
}

}  // namespace
}  // namespace kinescope
