#include "demos/space_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "demos/ui/theme.h"
#include "engine/clip_line_homogeneous.h"

namespace kinescope {
namespace {

constexpr int kSamples = 4;
constexpr float kDepthSlack = 2e-4f;
constexpr std::uint8_t kFaint = 70;  // of 255: alpha of what lies behind the solid

Scene scene_of(const Mesh& mesh, const Camera& observer) {
  Scene scene;
  Material material;
  material.base_colour = glm::vec3(1);
  material.specular = glm::vec3(0.25f);
  scene.materials.push_back(material);
  scene.meshes.push_back(mesh);
  scene.meshes[0].material = 0;
  Node node;
  node.meshes = {0};
  scene.nodes.push_back(node);
  Light key;
  key.kind = LightKind::kDirectional;
  const glm::vec3 forward = glm::normalize(observer.look_at - observer.eye);
  const glm::vec3 right = glm::normalize(glm::cross(forward, observer.up));
  key.direction = glm::normalize(forward + right * 0.5f - observer.up * 0.8f);
  key.colour = glm::vec3(0.95f);
  scene.lights = {{-1, key}};
  scene.ambient = glm::vec3(0.16f);
  return scene;
}

}  // namespace

SpaceView::SpaceView(Easel& easel, const Studio& studio, Image<Srgb8>& picture, const Rect& room,
                     Camera observer)
    : easel_(easel),
      studio_(studio),
      picture_(picture),
      canvas_(picture),
      room_(room),
      observer_(observer),
      scale_(theme::scale_for(picture.height())) {
  observer_.set_aspect(room.width / room.height);
  clip_from_space_ = observer_.clip_from_world();
  canvas_.set_clip(room);
}

void SpaceView::solid(const Mesh& mesh, bool wireframe) {
  RenderTarget& target =
      easel_.prepare(static_cast<int>(room_.width), static_cast<int>(room_.height), kSamples);
  target.clear = {0.0085f, 0.0095f, 0.0125f, 1};
  target.keep_depth = true;
  RenderSettings settings;
  settings.wireframe = settings.hidden_wire = wireframe;
  settings.shading = wireframe ? ShadingModel::kUnlit : ShadingModel::kPhong;
  easel_.renderer.invalidate();
  easel_.renderer.render(scene_of(mesh, observer_), observer_, settings, target);
  for (int y = 0; y < target.height; ++y) {
    std::copy_n(target.srgb8().row(y), target.width,
                picture_.row(static_cast<int>(room_.y) + y) + static_cast<int>(room_.x));
  }
}

/// To pixels of the picture and depth. @return false if all of it is out of sight
bool SpaceView::project(glm::vec3& a, glm::vec3& b) const {
  glm::dvec4 p = glm::dvec4(clip_from_space_ * glm::vec4(a, 1));
  glm::dvec4 q = glm::dvec4(clip_from_space_ * glm::vec4(b, 1));
  if (!clip_line(view_volume_planes(), p, q)) return false;
  const ViewportTransform device = device_from_ndc({room_.x, room_.y, room_.width, room_.height});
  const auto to_device = [&](const glm::dvec4& clip) {
    const glm::vec3 ndc = glm::vec3(glm::dvec3(clip) / clip.w);
    return glm::vec3(glm::vec2(ndc) * device.scale + device.offset, ndc.z);
  };
  a = to_device(p);
  b = to_device(q);
  return true;
}

bool SpaceView::hidden(glm::vec3 device) const {
  const Image<float>& depth = easel_.target.depth;
  const int x = static_cast<int>(device.x - room_.x), y = static_cast<int>(device.y - room_.y);
  return depth.contains(x, y) && depth.at(x, y) < device.z - kDepthSlack;
}

void SpaceView::line(glm::vec3 a, glm::vec3 b, float width, Srgb8 colour) {
  if (!project(a, b)) return;
  // In runs of one visibility, tested every few pixels.
  const float length = glm::length(glm::vec2(b - a));
  const int steps = std::clamp(static_cast<int>(length / 3), 1, 2000);
  const auto at = [&](int i) {
    return glm::mix(a, b, static_cast<float>(i) / static_cast<float>(steps));
  };
  const auto behind = [&](int i) { return hidden((at(i) + at(i + 1)) * 0.5f); };
  for (int i = 0; i < steps;) {
    const bool faint = behind(i);
    const int first = i;
    while (i < steps && behind(i) == faint) ++i;
    const auto alpha = static_cast<std::uint8_t>(faint ? colour.a * kFaint / 255 : colour.a);
    canvas_.line(glm::vec2(at(first)), glm::vec2(at(i)), width * scale_,
                 theme::with_alpha(colour, alpha));
  }
}

void SpaceView::axes(glm::vec3 origin, float length, const std::array<std::string_view, 3>& names) {
  constexpr std::array kColours = {theme::kRed, theme::kGreen, theme::kBlue};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    glm::vec3 tip = origin;
    tip[i] += length;
    line(origin, tip, 2, kColours[k]);
    label(origin + (tip - origin) * 1.12f, names[k], kColours[k]);
  }
}

void SpaceView::grid(float reach, float pitch) {
  for (float s = -reach; s <= reach + 1e-3f; s += pitch) {
    const Srgb8 colour = theme::with_alpha(theme::kText, std::abs(s) < 1e-3f ? 60 : 28);
    line({s, 0, -reach}, {s, 0, reach}, 1, colour);
    line({-reach, 0, s}, {reach, 0, s}, 1, colour);
  }
}

void SpaceView::box(const std::array<glm::vec3, 8>& corners, float width, Srgb8 colour) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t bit = 1; bit < corners.size(); bit *= 2) {
      if ((i & bit) == 0) line(corners[i], corners[i | bit], width, colour);
    }
  }
}

void SpaceView::label(glm::vec3 place, std::string_view text, Srgb8 colour) {
  glm::vec3 end = place;
  if (!project(place, end)) return;
  const float size = theme::kSmall * scale_;
  canvas_.text(studio_.sans, glm::vec2(place) + glm::vec2(0, size * 0.36f), text, size, colour,
               Align::kCentre);
}

void SpaceView::caption(std::string_view title, std::string_view note) {
  const float margin = theme::kMargin * scale_, size = theme::kBody * scale_;
  canvas_.text(studio_.sans, {room_.x + margin, room_.y + margin + size * 0.8f}, title, size * 1.1f,
               theme::kText);
  canvas_.text(studio_.sans, {room_.x + margin, room_.y + margin + size * 2.3f}, note,
               theme::kSmall * scale_, theme::kDim);
  canvas_.frame(room_, std::max(1.0f, scale_), theme::kRule);
}

void SpaceView::pixel_axes() {
  const float margin = theme::kMargin * scale_, size = theme::kSmall * scale_;
  const glm::vec2 corner(room_.x + margin * 1.6f, room_.y + margin * 5.5f);
  const glm::vec2 end(room_.right() - margin * 1.6f, room_.bottom() - margin * 2.2f);
  canvas_.arrow(corner, {end.x, corner.y}, 1.6f * scale_, theme::kRed);
  canvas_.arrow(corner, {corner.x, end.y}, 1.6f * scale_, theme::kGreen);
  canvas_.text(studio_.sans, corner + glm::vec2(0, -size * 0.5f), "(0, 0)", size, theme::kDim);
  canvas_.text(studio_.sans, {end.x, corner.y - size * 0.5f},
               fmt::format("x to {:.0f}", room_.width), size, theme::kRed, Align::kRight);
  canvas_.text(studio_.sans, {corner.x, end.y + size * 1.2f},
               fmt::format("y to {:.0f}", room_.height), size, theme::kGreen);
}

void SpaceView::matrix(std::string_view name, const glm::mat4& m) {
  const float size = theme::kSmall * scale_ * 0.92f, row = size * 1.4f;
  const float right = room_.right() - theme::kMargin * scale_;
  // Above the window's own line, where that is in this pane.
  const bool lowest = room_.bottom() + 1 >= static_cast<float>(picture_.height());
  const float below = (lowest ? 3 : 1) * theme::kMargin * scale_;
  float y = room_.bottom() - below - 4 * row;
  canvas_.text(studio_.sans, {right, y}, name, size, theme::kDim, Align::kRight);
  for (int i = 0; i < 4; ++i) {
    y += row;
    // Adding 0 turns a negative zero into 0.
    const auto number = [&](int column) { return std::round(m[column][i] * 100) / 100 + 0.0f; };
    canvas_.text(
        studio_.mono, {right, y},
        fmt::format("{:6.2f} {:6.2f} {:6.2f} {:6.2f}", number(0), number(1), number(2), number(3)),
        size, theme::kText, Align::kRight);
  }
}

}  // namespace kinescope
