#include "engine/renderer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/frame_mesh.h"
#include "engine/wire_pass.h"

namespace kinescope {
namespace {

const Material& material_of(const Scene& scene, const Mesh& mesh) {
  static const Material kDefault{};
  const auto index = static_cast<std::size_t>(mesh.material);
  return mesh.material >= 0 && index < scene.materials.size() ? scene.materials[index] : kDefault;
}

const Texture* texture_of(const Scene& scene, const Material& material) {
  const auto index = static_cast<std::size_t>(material.base_texture);
  const bool named = material.base_texture >= 0 && index < scene.textures.size();
  return named && scene.textures[index].levels() > 0 ? &scene.textures[index] : nullptr;
}

/// Where light is seen from: parallel projection sees along one direction, as from very far away.
glm::vec3 shading_eye(const Camera& camera) {
  if (camera.projection == Projection::kPerspective) return camera.eye;
  const glm::mat4 view = camera.view_from_world();
  const glm::vec3 back(view[0][2], view[1][2], view[2][2]);
  const float depth = std::min(std::abs(camera.far_plane) + std::abs(camera.near_plane), 1e12f);
  return camera.eye + back * (depth * 1e4f);
}

CullMode cull_mode(const FrameMesh& mesh) {
  if (mesh.surface.material.double_sided) return CullMode::kNone;
  return mesh.world->transform.mirrors ? CullMode::kFront : CullMode::kBack;
}

std::span<const DeviceVertex> vertices_of(const FrameMesh& mesh) {
  const std::size_t count =
      mesh.world->vertices() + (mesh.must_cut() ? mesh.cut.new_vertices() : 0);
  return std::span(mesh.device.vertices).first(count);
}

/// The rows that a shading model's shader reads, and the cut appends to.
struct Rows {
  std::vector<float>& values;
  int stride;
  int count;
};
Rows rows_of(FrameMesh& mesh, ShadingModel shading) {
  if (shading == ShadingModel::kGouraud) {
    const int size = lit_row_size(mesh.surface);
    return {mesh.lit_rows, size, size};
  }
  return {mesh.world->rows, mesh.world->row_stride, mesh.world->row_count};
}

DrawCall draw_call(FrameMesh& mesh, ShadingModel shading) {
  const Rows rows = rows_of(mesh, shading);
  DrawCall call;
  call.vertices = vertices_of(mesh);
  if (mesh.must_cut()) {
    call.indices = mesh.cut.indices();
    call.source_triangle = mesh.cut.source_triangle();
  } else {
    call.indices = std::span(mesh.world->mesh->indices).first(mesh.world->triangles() * 3);
  }
  call.attributes = rows.values;
  call.attribute_count = rows.count;
  call.attributes_read = attributes_read(shading, mesh.surface);
  call.attribute_stride = rows.stride;
  if (mesh.surface.texture != nullptr) call.texcoord_attribute = vertex_row::kTexcoord;
  call.cull = cull_mode(mesh);
  call.shade = shade_function(shading);
  call.constants = &mesh.surface;
  return call;
}

/// Whether light from behind comes through.
bool is_transparent(const Surface& surface) {
  return surface.material.opacity < 1.0f ||
         (surface.texture != nullptr && surface.texture->has_alpha());
}

}  // namespace

struct Renderer::State {
  State(Workers& team, RasterizerOptions options) : workers(team), rasterizer(team, options) {}

  void prepare(const Scene& scene, const Camera& camera, const RenderSettings& settings);
  void cut(const Projector& projector, ShadingModel shading, RenderStats& stats);
  void add_surfaces(const Projector& projector, const RenderSettings& settings, RenderStats& stats);
  void add_hidden_surfaces(const Projector& projector, const LinearRgba& clear, RenderStats& stats);

  Workers& workers;
  Rasterizer rasterizer;
  WorldMeshes world;
  std::vector<FrameMesh> meshes;
  std::vector<Light> lights;
  std::vector<DrawCall> calls;
  WirePass wires;
};

/// Surfaces, lights, and which meshes can be seen at all.
void Renderer::State::prepare(const Scene& scene, const Camera& camera,
                              const RenderSettings& settings) {
  world.update(workers, scene);
  lights = world_lights(scene);
  const glm::mat4 clip_from_world = camera.clip_from_world();
  meshes.resize(world.items().size());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    FrameMesh& mesh = meshes[i];
    mesh.world = &world.items()[i];
    mesh.seen = mesh.world->mesh != nullptr && !outside_view(clip_from_world, mesh.world->bounds);
    if (!mesh.seen) continue;
    Surface& surface = mesh.surface;
    surface.material = material_of(scene, *mesh.world->mesh);
    surface.texture = settings.textures ? texture_of(scene, surface.material) : nullptr;
    surface.lights = lights;
    surface.ambient = scene.ambient;
    surface.eye = shading_eye(camera);
    surface.mirrored = mesh.world->transform.mirrors;
    surface.vertex_colours = !mesh.world->mesh->colours.empty();
  }
}

void Renderer::State::cut(const Projector& projector, ShadingModel shading, RenderStats& stats) {
  for (FrameMesh& mesh : meshes) {
    if (!mesh.seen || !mesh.must_cut()) continue;
    const Rows rows = rows_of(mesh, shading);
    mesh.cut.cut(workers, projector, DeviceVertex::kGuardBand, mesh.world->positions,
                 mesh.world->mesh->indices, mesh.device, rows.values, rows.stride, rows.count);
    stats.clipped += mesh.cut.cut_count();
  }
}

void Renderer::State::add_surfaces(const Projector& projector, const RenderSettings& settings,
                                   RenderStats& stats) {
  if (settings.shading == ShadingModel::kGouraud) light_mesh_vertices(workers, meshes);
  if (settings.shading == ShadingModel::kFlat) light_mesh_triangles(workers, meshes);
  cut(projector, settings.shading, stats);
  for (FrameMesh& mesh : meshes) {
    if (!mesh.seen) continue;
    DrawCall call = draw_call(mesh, settings.shading);
    if (is_transparent(mesh.surface)) {
      call.blend = BlendMode::kAlpha;
      call.order = BlendOrder::kByDepth;
    }
    calls.push_back(call);
  }
}

/// Surfaces in the colour of the background, which hide what lies behind them.
void Renderer::State::add_hidden_surfaces(const Projector& projector, const LinearRgba& clear,
                                          RenderStats& stats) {
  cut(projector, ShadingModel::kUnlit, stats);
  for (FrameMesh& mesh : meshes) {
    if (!mesh.seen) continue;
    DrawCall call = draw_call(mesh, ShadingModel::kUnlit);
    call.attributes = {};
    call.attribute_count = 0;
    call.texcoord_attribute = -1;
    call.shade = shade_constant;
    call.constants = &clear;
    calls.push_back(call);
  }
}

Renderer::Renderer(Workers& workers, RasterizerOptions options)
    : state_(std::make_unique<State>(workers, options)) {}

Renderer::~Renderer() = default;

void Renderer::invalidate() {
  state_->world.invalidate();
  state_->wires = {};
}

RenderStats Renderer::render(const Scene& scene, const Camera& camera,
                             const RenderSettings& settings, RenderTarget& target,
                             bool want_visibility_hash) {
  State& s = *state_;
  RenderStats stats;
  s.prepare(scene, camera, settings);
  const Viewport viewport{0.0f, 0.0f, static_cast<float>(target.width),
                          static_cast<float>(target.height)};
  const Projector projector =
      make_projector(camera.clip_from_world(), viewport, DeviceVertex::kGuardBand);
  stats.vertices = project_meshes(s.workers, projector, s.meshes);
  s.calls.clear();
  if (settings.wireframe || settings.points) {
    if (settings.hidden_wire) s.add_hidden_surfaces(projector, target.clear, stats);
    s.wires.add_calls(s.workers, projector, camera, settings, target.clear, s.meshes, s.calls);
  } else {
    s.add_surfaces(projector, settings, stats);
  }
  stats.raster = s.rasterizer.draw(target, s.calls, want_visibility_hash);
  return stats;
}

}  // namespace kinescope
