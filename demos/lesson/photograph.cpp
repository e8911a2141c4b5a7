#include "demos/lesson/photograph.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/renderer.h"
#include "engine/teapot.h"

namespace kinescope {
namespace {

constexpr int kSamples = 4, kFineness = 8;

/// A rectangle of two triangles whose corners have colours of their own.
Mesh rectangle(glm::vec3 corner, glm::vec3 across, glm::vec3 up, glm::vec3 low, glm::vec3 high) {
  Mesh mesh;
  mesh.positions = {corner, corner + across, corner + across + up, corner + up};
  mesh.normals.assign(4, glm::normalize(glm::cross(across, up)));
  mesh.colours = {low, glm::mix(low, high, 0.5f), high, glm::mix(low, high, 0.5f)};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

Scene still_life() {
  Scene scene;
  Material glaze, matt;
  glaze.base_colour = {0.62f, 0.16f, 0.05f};
  glaze.specular = glm::vec3(0.7f);
  glaze.shininess = 48;
  glaze.double_sided = true;
  matt.base_colour = glm::vec3(1);
  matt.specular = glm::vec3(0);
  scene.materials = {glaze, matt};
  scene.meshes = {
      teapot_mesh(kFineness),
      rectangle({-12, 0, 9}, {24, 0, 0}, {0, 0, -15}, {0.16f, 0.3f, 0.12f}, {0.55f, 0.5f, 0.3f}),
      rectangle({-14, 0, -6}, {28, 0, 0}, {0, 12, 0}, {0.45f, 0.42f, 0.5f}, {0.16f, 0.32f, 0.7f})};
  scene.meshes[0].material = 0;
  scene.meshes[1].material = scene.meshes[2].material = 1;
  Node node;
  node.meshes = {0, 1, 2};
  scene.nodes = {node};
  const auto lamp = [](glm::vec3 position, glm::vec3 colour) {
    Light light;
    light.position = position;
    light.colour = colour;
    return Placed<Light>{-1, light};
  };
  scene.lights = {lamp({6, 9, 8}, {1.5f, 1.4f, 1.2f}), lamp({-9, 5, 4}, {0.4f, 0.5f, 0.75f})};
  scene.ambient = glm::vec3(0.2f, 0.22f, 0.26f);
  return scene;
}

}  // namespace

Image<Srgb8> photograph(Workers& workers, int width, int height) {
  Renderer renderer(workers);
  RenderTarget target(width, height, kSamples);
  Camera camera;
  camera.eye = {3.2f, 4.6f, 8.6f};
  camera.look_at = {0.1f, 1.35f, 0};
  camera.set_field_of_view(0.62f, static_cast<float>(width) / static_cast<float>(height));
  RenderSettings settings;
  settings.shading = ShadingModel::kPhong;
  renderer.render(still_life(), camera, settings, target);
  return target.srgb8();
}

Image<Srgb8> lit_ball(int width, int height) {
  Image<Srgb8> image(width, height);
  const double w = image.width(), h = image.height(), r = 0.36 * std::min(w, h);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const double u = (x + 0.5 - w / 2) / r, v = (y + 0.5 - h / 2) / r, n2 = 1 - u * u - v * v;
      const double lit = std::max(0.0, (-0.5 * u - 0.6 * v + 0.62 * std::sqrt(std::max(n2, 0.0))));
      const auto light =
          static_cast<float>(std::clamp(n2 > 0 ? 0.03 + 0.95 * lit : 0.6 * (x + 0.5) / w, 0., 1.));
      image.at(x, y) = encode_srgb8(LinearRgb{light, light, light});
    }
  }
  return image;
}

GreyImage grey_of(const Image<Srgb8>& picture, bool linear) {
  GreyImage grey(picture.width(), picture.height());
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const LinearRgba light = decode(picture.pixels()[i]);
    // Luminance by the weights of Rec. 709.
    const float y = 0.2126f * light.r + 0.7152f * light.g + 0.0722f * light.b;
    grey.pixels()[i] = static_cast<std::uint8_t>(std::lround(255 * (linear ? y : srgb_encode(y))));
  }
  return grey;
}

}  // namespace kinescope
