// Each kind of light against its formula, computed here in double.
#include "shading/light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "tests/shading/batch_arrays.h"

namespace kinescope {
namespace {

void expect_near(glm::vec3 found, glm::dvec3 expected, double tolerance) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(static_cast<double>(found[k]), expected[k], tolerance) << "component " << k;
  }
}

Light spot_down(float inner_rad, float outer_rad) {
  Light light;
  light.kind = LightKind::kSpot;
  light.position = {0, 2, 0};
  light.direction = {0, -3, 0};  // not of unit length
  light.inner_cone_rad = inner_rad;
  light.outer_cone_rad = outer_rad;
  return light;
}

/// The light two below the spot, `angle_rad` off its axis.
float spot_light_at(const Light& light, double angle_rad) {
  const glm::vec3 place(2.0 * std::sin(angle_rad), 2.0 - 2.0 * std::cos(angle_rad), 0.0);
  return incident_light(light, place).colour.x;
}

TEST(Light, DirectionalArrivesAgainstItsDirectionEverywhere) {
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = {0, -2, 0};
  light.colour = {1, 2, 3};
  light.attenuation = {0, 1, 1};  // of no meaning without a distance
  for (const glm::vec3 place : {glm::vec3(0, 0, 0), glm::vec3(1e6f, -5, 2)}) {
    const Incident in = incident_light(light, place);
    expect_near(in.to_light, {0, 1, 0}, 0);
    expect_near(in.colour, {1, 2, 3}, 0);
  }
}

TEST(Light, PointArrivesFromItsPlaceWithoutLossByDefault) {
  Light light;
  light.position = {3, 4, 0};
  light.colour = {0.5f, 1, 2};
  const Incident in = incident_light(light, {0, 0, 0});
  expect_near(in.to_light, {0.6, 0.8, 0}, 1e-6);
  expect_near(in.colour, {0.5, 1, 2}, 0);
}

TEST(Light, AttenuationDividesByItsPolynomial) {
  Light light;
  light.position = {0, 0, 2};
  light.attenuation = {1, 0.5f, 0.25f};
  expect_near(incident_light(light, {0, 0, 0}).colour, glm::dvec3(1.0 / 3.0), 1e-6);  // 1 + 1 + 1
  light.attenuation = {0, 0, 1};
  expect_near(incident_light(light, {0, 0, -1}).colour, glm::dvec3(1.0 / 9.0), 1e-6);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    light.position = random.in_cube(-5, 5);
    light.attenuation = random.in_cube(0.1f, 2);
    const glm::vec3 place = random.in_cube(-5, 5);
    const double d = glm::length(glm::dvec3(light.position) - glm::dvec3(place));
    const glm::dvec3 k = light.attenuation;
    expect_near(incident_light(light, place).colour, glm::dvec3(1 / (k.x + k.y * d + k.z * d * d)),
                1e-5);
  }
}

TEST(Light, AttenuationThatDividesByNothingStaysFinite) {
  Light light;
  light.position = {0, 0, 0};
  light.attenuation = {0, 0, 0};
  EXPECT_TRUE(std::isfinite(incident_light(light, {0, 0, 1}).colour.x));
}

TEST(Light, ALightHasNoDirectionInItsOwnPlace) {
  Light light;
  light.position = {1, 2, 3};
  expect_near(incident_light(light, {1, 2, 3}).to_light, {0, 0, 0}, 0);
}

TEST(Light, SpotIsFullInsideAndDarkOutsideItsCones) {
  const Light light = spot_down(0.3f, 0.6f);
  EXPECT_EQ(spot_light_at(light, 0.0), 1.0f);
  EXPECT_EQ(spot_light_at(light, 0.299), 1.0f);
  EXPECT_EQ(spot_light_at(light, 0.601), 0.0f);
  EXPECT_EQ(spot_light_at(light, 1.5), 0.0f);
  EXPECT_EQ(spot_light_at(light, 3.14159), 0.0f) << "behind the lamp";
}

TEST(Light, SpotFallsBySmoothstepOfTheCosine) {
  const Light light = spot_down(0.3f, 0.6f);
  float last = 1.0f;
  for (double angle = 0.29; angle < 0.62; angle += 0.005) {
    const double t =
        std::clamp((std::cos(angle) - std::cos(0.6)) / (std::cos(0.3) - std::cos(0.6)), 0.0, 1.0);
    const float found = spot_light_at(light, angle);
    EXPECT_NEAR(found, t * t * (3 - 2 * t), 1e-5) << "at " << angle;
    EXPECT_LE(found, last);
    last = found;
  }
  // Half-way between the cosines half of the light is left.
  const double middle = std::acos((std::cos(0.3) + std::cos(0.6)) / 2);
  EXPECT_NEAR(spot_light_at(light, middle), 0.5, 1e-5);
}

TEST(Light, ConesThatCoincideOrCrossCutSharply) {
  for (const float inner : {0.5f, 0.9f}) {
    const Light light = spot_down(inner, 0.5f);
    EXPECT_EQ(spot_light_at(light, 0.499), 1.0f);
    EXPECT_EQ(spot_light_at(light, 0.501), 0.0f);
  }
}

TEST(Light, AWideSpotReachesBehindItself) {
  const Light light = spot_down(2.0f, 2.5f);
  EXPECT_EQ(spot_light_at(light, 1.9), 1.0f);
  EXPECT_EQ(spot_light_at(light, 2.6), 0.0f);
}

TEST(Light, SpotIsAttenuatedToo) {
  Light light = spot_down(0.3f, 0.6f);
  light.attenuation = {0, 0, 1};
  EXPECT_NEAR(spot_light_at(light, 0.0), 0.25, 1e-6);
}

}  // namespace
}  // namespace kinescope
