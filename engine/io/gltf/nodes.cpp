#include "engine/io/gltf/nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "engine/io/text.h"

namespace kinescope {
namespace {

bool is_finite(const glm::mat4& matrix) {
  for (int i = 0; i < 16; ++i) {
    if (!std::isfinite(matrix[i / 4][i % 4])) return false;
  }
  return true;
}

glm::mat4 parent_from_local(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) {
    glm::mat4 matrix;
    for (std::size_t i = 0; i < 16; ++i) {
      matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = to_float(node.matrix[i]);
    }
    return matrix;
  }
  glm::dmat4 matrix(1.0);
  const auto& t = node.translation;
  if (t.size() == 3) matrix = glm::translate(matrix, glm::dvec3(t[0], t[1], t[2]));
  const auto& r = node.rotation;
  if (r.size() == 4) {
    const glm::dquat rotation(r[3], r[0], r[1], r[2]);
    if (glm::length(rotation) > 0.0) matrix *= glm::mat4_cast(glm::normalize(rotation));
  }
  const auto& s = node.scale;
  if (s.size() == 3) matrix = glm::scale(matrix, glm::dvec3(s[0], s[1], s[2]));
  glm::mat4 narrow;
  for (int i = 0; i < 16; ++i) narrow[i / 4][i % 4] = to_float(matrix[i / 4][i % 4]);
  return narrow;
}

/// Looks along -z of its node.
bool set_camera(Camera& camera, const tinygltf::Camera& source) {
  camera.eye = glm::vec3(0.0f);
  camera.look_at = {0.0f, 0.0f, -1.0f};
  camera.up = {0.0f, 1.0f, 0.0f};
  if (source.type == "orthographic") {
    const auto& lens = source.orthographic;
    camera.projection = Projection::kOrthographic;
    camera.window_max = {to_float(lens.xmag), to_float(lens.ymag)};
    camera.window_min = -camera.window_max;
    camera.near_plane = to_float(lens.znear);
    camera.far_plane = to_float(lens.zfar);
    return lens.xmag > 0.0 && lens.ymag > 0.0 && lens.zfar > lens.znear;
  }
  const auto& lens = source.perspective;
  const double aspect = lens.aspectRatio > 0.0 ? lens.aspectRatio : 4.0 / 3.0;
  camera.set_field_of_view(to_float(lens.yfov), to_float(aspect));
  camera.near_plane = to_float(lens.znear);
  // No far plane means infinitely far; so far that it is out of the way.
  camera.far_plane = to_float(lens.zfar > 0.0 ? lens.zfar : lens.znear * 1e6);
  return lens.yfov > 0.0 && lens.yfov < std::numbers::pi && lens.znear > 0.0 &&
         camera.far_plane > camera.near_plane;
}

/// KHR_lights_punctual. A surface of reflectance 1 sends on 1/pi of the light that falls on it.
bool set_light(Light& light, const tinygltf::Light& source) {
  const auto& c = source.color;
  const double strength = source.intensity / std::numbers::pi;
  if (c.size() == 3) {
    light.colour = {to_float(c[0] * strength), to_float(c[1] * strength),
                    to_float(c[2] * strength)};
  } else {
    light.colour = glm::vec3(to_float(strength));
  }
  for (int i = 0; i < 3; ++i) {
    if (!(light.colour[i] >= 0.0f && std::isfinite(light.colour[i]))) return false;
  }
  if (source.type == "directional") {
    light.kind = LightKind::kDirectional;
    return true;
  }
  // The square of the distance; the constant keeps a light that touches a surface finite.
  light.attenuation = {1e-4f, 0.0f, 1.0f};
  if (source.type == "point") return true;
  light.kind = LightKind::kSpot;
  constexpr double kWidest = std::numbers::pi / 2.0;
  light.outer_cone_rad = to_float(std::clamp(source.spot.outerConeAngle, 0.0, kWidest));
  light.inner_cone_rad = to_float(std::clamp(source.spot.innerConeAngle, 0.0, kWidest));
  return source.type == "spot";
}

int light_of(const tinygltf::Node& node) {
  const auto found = node.extensions.find("KHR_lights_punctual");
  if (found == node.extensions.end() || !found->second.Has("light")) return -1;
  const tinygltf::Value& light = found->second.Get("light");
  return light.IsInt() ? light.GetNumberAsInt() : -1;
}

template <typename T>
bool has(const std::vector<T>& items, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < items.size();
}

class NodeReader {
 public:
  NodeReader(const tinygltf::Model& model, GltfMeshes& meshes, const ModelFile& file, Scene& scene)
      : model_(model), meshes_(meshes), file_(file), scene_(scene), state_(model.nodes.size()) {}

  void read() {
    for (const int root : roots()) walk(root);
    if (shared_) file_.warn("a node has two parents; drawn below the first only");
  }

 private:
  enum class State : char { kUnseen, kOpen, kDone };
  /// A node at work: which child comes next, and its number in Scene::nodes.
  struct Step {
    int node;
    std::size_t child;
    int number;
  };

  std::vector<int> roots() const {
    if (!model_.scenes.empty()) {
      const int scene = has(model_.scenes, model_.defaultScene) ? model_.defaultScene : 0;
      return model_.scenes[static_cast<std::size_t>(scene)].nodes;
    }
    std::vector<bool> is_child(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes) {
      for (const int child : node.children) {
        if (has(model_.nodes, child)) is_child[static_cast<std::size_t>(child)] = true;
      }
    }
    std::vector<int> found;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) found.push_back(static_cast<int>(i));
    }
    return found;
  }

  /// Depth first, with a stack of its own: chains may be long.
  void walk(int root) {
    std::vector<Step> stack;
    enter(root, -1, stack);
    while (!stack.empty()) {
      Step& step = stack.back();
      const auto& children = model_.nodes[static_cast<std::size_t>(step.node)].children;
      if (step.child < children.size()) {
        enter(children[step.child++], step.number, stack);
      } else {
        state_[static_cast<std::size_t>(step.node)] = State::kDone;
        stack.pop_back();
      }
    }
  }

  void enter(int node, int parent, std::vector<Step>& stack) {
    const std::string where = "node " + std::to_string(node);
    if (!has(model_.nodes, node)) file_.fail("is not there", where);
    State& state = state_[static_cast<std::size_t>(node)];
    if (state == State::kOpen) file_.fail("is among its own descendants", where);
    if (state == State::kDone) {
      shared_ = true;
      return;
    }
    state = State::kOpen;
    stack.push_back({node, 0, static_cast<int>(scene_.nodes.size())});
    add(model_.nodes[static_cast<std::size_t>(node)], parent, where);
  }

  void add(const tinygltf::Node& source, int parent, const std::string& where) {
    const auto number = static_cast<int>(scene_.nodes.size());
    Node node;
    node.name = source.name;
    node.parent = parent;
    node.parent_from_local = parent_from_local(source);
    if (!is_finite(node.parent_from_local)) {
      file_.warn("its transform is not finite; drawn without it", where);
      node.parent_from_local = glm::mat4(1.0f);
    }
    if (has(model_.meshes, source.mesh)) {
      node.meshes = meshes_.numbers_of(source.mesh);
    } else if (source.mesh >= 0) {
      file_.warn("its mesh is not there", where);
    }
    scene_.nodes.push_back(std::move(node));
    if (has(model_.cameras, source.camera)) {
      Camera camera;
      if (set_camera(camera, model_.cameras[static_cast<std::size_t>(source.camera)])) {
        scene_.cameras.push_back({number, camera});
      } else {
        file_.warn("its camera sees nothing and is not used", where);
      }
    }
    if (const int index = light_of(source); has(model_.lights, index)) {
      Light light;
      if (set_light(light, model_.lights[static_cast<std::size_t>(index)])) {
        scene_.lights.push_back({number, light});
      }
    }
  }

  const tinygltf::Model& model_;
  GltfMeshes& meshes_;
  const ModelFile& file_;
  Scene& scene_;
  std::vector<State> state_;
  bool shared_ = false;
};

}  // namespace

void read_gltf_nodes(const tinygltf::Model& model, GltfMeshes& meshes, const ModelFile& file,
                     Scene& scene) {
  NodeReader(model, meshes, file, scene).read();
}

}  // namespace kinescope
