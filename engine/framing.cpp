#include "engine/framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>

namespace kinescope {
namespace {

using Vec = glm::dvec3;

constexpr double kMargin = 0.06;  // of the picture's half height or width, left free on each side

/// Squares of larger numbers overflow in matrices and distances.
constexpr float kFarthest = 1e18f;

bool usable(glm::vec3 p) {
  return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest && std::abs(p.z) <= kFarthest;
}

/// A radius to look at; a single place gets a sphere too.
double visible_radius(const Bounds& bounds) {
  const double radius = std::max<double>(bounds.radius(), 1e-6 * glm::length(Vec(bounds.centre())));
  return radius > 0.0 ? radius : 1.0;
}

/// Calls visit(point) for every finite vertex that a triangle uses, in world space.
template <typename Visit>
void for_each_drawn_point(const Scene& scene, const Visit& visit) {
  const std::vector<glm::mat4> transforms = world_transforms(scene);
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    for (const int index : scene.nodes[n].meshes) {
      if (index < 0 || static_cast<std::size_t>(index) >= scene.meshes.size()) continue;
      const Mesh& mesh = scene.meshes[static_cast<std::size_t>(index)];
      std::vector<bool> seen(mesh.positions.size(), false);
      for (const std::uint32_t i : mesh.indices) {
        if (i >= seen.size() || seen[i]) continue;
        seen[i] = true;
        const glm::vec3 p(transforms[n] * glm::vec4(mesh.positions[i], 1.0f));
        if (usable(p)) visit(p);
      }
    }
  }
}

/// Axes of a view, world space.
struct Axes {
  Vec right, up, back;
};

Axes view_axes(double azimuth_rad, double elevation_rad) {
  const double ca = std::cos(azimuth_rad), sa = std::sin(azimuth_rad);
  const double ce = std::cos(elevation_rad), se = std::sin(elevation_rad);
  return {{ca, 0.0, -sa}, {-sa * se, ce, -ca * se}, {sa * ce, se, ca * ce}};
}

/// One axis of the picture: each point bounds the eye's depth by a line in the eye's place across,
/// because a frustum of half width `slope` per unit of depth must reach it.
struct Reach {
  double plus = -std::numeric_limits<double>::infinity();
  double minus = -std::numeric_limits<double>::infinity();
  void add(double depth_plus, double depth_minus) {
    plus = std::max(plus, depth_plus);
    minus = std::max(minus, depth_minus);
  }
  /// The nearest eye that sees everything: its place across, and its depth.
  double across(double slope) const { return slope * (plus - minus) * 0.5; }
  double depth() const { return (plus + minus) * 0.5; }
};

/// What is to be fitted, and how: common to the ways of framing.
struct Fit {
  Vec centre{0.0};
  double radius = 0.0;
  Axes axes;
  double slope_x, slope_y;
  Reach x, y;
  double nearest = -std::numeric_limits<double>::infinity();  ///< greatest depth of a point

  Fit(const Bounds& bounds, float aspect, float azimuth_rad, float elevation_rad, float fov_y_rad)
      : centre(bounds.centre()),
        radius(visible_radius(bounds)),
        axes(view_axes(azimuth_rad, elevation_rad)),
        slope_y(std::tan(std::clamp(fov_y_rad, 1e-3f, 3.1f) * 0.5) * (1.0 - kMargin)) {
    slope_x = slope_y * aspect;
  }

  double depth() const { return std::max({x.depth(), y.depth(), nearest + radius * 0.01}); }

  Camera camera(const Vec& target, const Vec& eye, float aspect, float fov_y_rad) const {
    Camera c;
    c.look_at = glm::vec3(target);
    c.eye = glm::vec3(eye);
    // Straight from above or below, +y says nothing.
    c.up =
        std::abs(axes.up.y) > 1e-3 ? glm::vec3(0, axes.up.y > 0 ? 1 : -1, 0) : glm::vec3(axes.up);
    c.set_field_of_view(fov_y_rad, aspect);
    const double distance = glm::length(eye - centre);
    // Room for an orbit and for what moves; yet never beyond the nearest point.
    const double gap = glm::dot(eye - centre, axes.back) - nearest;
    const double near = std::max(distance - radius * 1.5, distance * 0.01);
    c.near_plane = static_cast<float>(std::min(near, gap * 0.5));
    c.far_plane = static_cast<float>(distance + radius * 1.5);
    return c;
  }
};

/// What stands for a scene without any extent.
std::array<glm::vec3, 6> points_about(const Vec& centre, double radius) {
  std::array<glm::vec3, 6> points;
  for (int i = 0; i < 6; ++i) {
    Vec p = centre;
    p[i % 3] += i < 3 ? radius : -radius;
    points[static_cast<std::size_t>(i)] = glm::vec3(p);
  }
  return points;
}

/// Bounds of a scene, or of a unit sphere's worth of nothing.
Bounds bounds_or_origin(const Scene& scene) {
  Bounds bounds = world_bounds(scene);
  if (bounds.empty) {
    bounds.add(glm::vec3(-1.0f));
    bounds.add(glm::vec3(1.0f));
  }
  return bounds;
}

/// Gives every drawn point to add(point); a stand-in where there is none or only one place.
template <typename Add>
void fit_points(const Scene& scene, const Bounds& bounds, const Fit& fit, const Add& add) {
  for_each_drawn_point(scene, add);
  if (std::isfinite(fit.nearest) && bounds.radius() > 0.0f) return;
  for (const glm::vec3& p : points_about(fit.centre, fit.radius)) add(p);
}

}  // namespace

float Bounds::radius() const {
  return empty ? 0.0f : static_cast<float>(glm::length(glm::dvec3(max) - glm::dvec3(min)) * 0.5);
}

void Bounds::add(glm::vec3 point) {
  if (!usable(point)) return;
  min = empty ? point : glm::min(min, point);
  max = empty ? point : glm::max(max, point);
  empty = false;
}

void Bounds::add(const Bounds& other) {
  if (other.empty) return;
  add(other.min);
  add(other.max);
}

Bounds world_bounds(const Scene& scene) {
  Bounds bounds;
  for_each_drawn_point(scene, [&](glm::vec3 p) { bounds.add(p); });
  return bounds;
}

Camera frame_scene(const Scene& scene, float aspect, float azimuth_rad, float elevation_rad,
                   float fov_y_rad) {
  const Bounds bounds = bounds_or_origin(scene);
  Fit fit(bounds, aspect, azimuth_rad, elevation_rad, fov_y_rad);
  fit_points(scene, bounds, fit, [&](glm::vec3 p) {
    const Vec q = Vec(p) - fit.centre;
    const double depth = glm::dot(q, fit.axes.back);
    const double right = glm::dot(q, fit.axes.right) / fit.slope_x;
    const double up = glm::dot(q, fit.axes.up) / fit.slope_y;
    fit.x.add(depth + right, depth - right);
    fit.y.add(depth + up, depth - up);
    fit.nearest = std::max(fit.nearest, depth);
  });
  const Vec target = fit.centre + fit.axes.right * fit.x.across(fit.slope_x) +
                     fit.axes.up * fit.y.across(fit.slope_y);
  return fit.camera(target, target + fit.axes.back * fit.depth(), aspect, fov_y_rad);
}

Camera frame_turntable(const Scene& scene, float aspect, float azimuth_rad, float elevation_rad,
                       float fov_y_rad) {
  const Bounds bounds = bounds_or_origin(scene);
  Fit fit(bounds, aspect, azimuth_rad, elevation_rad, fov_y_rad);
  const double ce = fit.axes.up.y, se = fit.axes.back.y;
  // Each point stands for its circle about the vertical: the greatest of a sine and a cosine.
  fit_points(scene, bounds, fit, [&](glm::vec3 p) {
    const Vec q = Vec(p) - fit.centre;
    const double r = std::hypot(q.x, q.z), h = q.y;
    const double sideways = h * se + r * std::hypot(ce, 1.0 / fit.slope_x);
    fit.x.add(sideways, sideways);
    fit.y.add(h * (se + ce / fit.slope_y) + r * std::abs(ce - se / fit.slope_y),
              h * (se - ce / fit.slope_y) + r * std::abs(ce + se / fit.slope_y));
    fit.nearest = std::max(fit.nearest, h * se + r * std::abs(ce));
  });
  // The target stays on the axis: what it lacks across, it gets by rising along the axis.
  const double rise = std::abs(ce) > 1e-3 ? fit.y.across(fit.slope_y) / ce : 0.0;
  const Vec target = fit.centre + Vec(0.0, rise, 0.0);
  const Vec eye = target + fit.axes.back * (fit.depth() - rise * se);
  return fit.camera(target, eye, aspect, fov_y_rad);
}

void add_default_lights(Scene& scene, const Camera& camera) {
  const Bounds bounds = bounds_or_origin(scene);
  const Vec centre(bounds.centre());
  const double radius = visible_radius(bounds);
  const glm::dmat3 world_from_view(glm::transpose(glm::mat3(camera.view_from_world())));
  const auto add = [&](Vec from, glm::vec3 colour) {
    Light light;
    light.kind = LightKind::kPoint;
    light.position = glm::vec3(centre + world_from_view * (glm::normalize(from) * radius * 4.0));
    light.colour = colour;
    scene.lights.push_back({-1, light});
  };
  add({-0.9, 1.0, 0.8}, {0.95f, 0.92f, 0.86f});  // key: from above, left of the camera
  add({1.0, 0.1, 0.7}, {0.12f, 0.15f, 0.22f});   // fill: weak and cool, from the right
  add({0.5, 0.7, -1.0}, {0.40f, 0.40f, 0.42f});  // rim: from behind, to part it from the ground
}

}  // namespace kinescope
