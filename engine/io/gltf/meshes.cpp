#include "engine/io/gltf/meshes.h"

#include <limits>

namespace kinescope {
namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

/// The corners of triangles, three each, from indices in any of the modes that make triangles.
std::vector<std::uint32_t> unrolled(const std::vector<std::uint32_t>& in, int mode) {
  std::vector<std::uint32_t> out;
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    out.assign(in.begin(), in.end() - static_cast<std::ptrdiff_t>(in.size() % 3));
    return out;
  }
  for (std::size_t i = 2; i < in.size(); ++i) {
    const bool fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
    const bool odd = !fan && i % 2 == 1;
    const std::uint32_t first = fan ? in[0] : in[i - 2];
    out.insert(out.end(), {odd ? in[i - 1] : first, odd ? in[i - 2] : in[i - 1], in[i]});
  }
  return out;
}

template <typename Vec>
Vec vec_at(const GltfNumbers& numbers, std::size_t i) {
  const float* from = &numbers.values[i * static_cast<std::size_t>(numbers.components)];
  Vec vec;
  for (int c = 0; c < Vec::length(); ++c) vec[c] = from[c];
  return vec;
}

template <typename Vec>
std::vector<Vec> gather(const GltfNumbers* numbers, const std::vector<std::uint32_t>& used) {
  std::vector<Vec> gathered;
  if (!numbers) return gathered;
  gathered.reserve(used.size());
  for (const std::uint32_t i : used) gathered.push_back(vec_at<Vec>(*numbers, i));
  return gathered;
}

}  // namespace

GltfMeshes::GltfMeshes(const tinygltf::Model& model, GltfAccessors& accessors,
                       const GltfMaterials& materials, const ModelFile& file, Scene& scene)
    : model_(model),
      accessors_(accessors),
      materials_(materials),
      file_(file),
      scene_(scene),
      // An index takes a byte at least; primitives that share them must not multiply them far.
      budget_(4 * accessors.total_bytes() + (1u << 20)) {}

const std::vector<int>& GltfMeshes::numbers_of(int mesh) {
  const auto [entry, is_new] = numbers_.try_emplace(mesh);
  if (!is_new) return entry->second;
  const tinygltf::Mesh& source = model_.meshes[static_cast<std::size_t>(mesh)];
  for (const tinygltf::Primitive& primitive : source.primitives) {
    std::optional<Mesh> read_mesh = read(primitive);
    if (!read_mesh) continue;
    read_mesh->name = source.name;
    entry->second.push_back(static_cast<int>(scene_.meshes.size()));
    scene_.meshes.push_back(std::move(*read_mesh));
  }
  return entry->second;
}

void GltfMeshes::warn_of_lost() const {
  if (lost_primitives_ != 0) {
    file_.warn("left out " + std::to_string(lost_primitives_) +
               " primitives that are points or lines");
  }
  if (lost_triangles_ != 0) {
    file_.warn("left out " + std::to_string(lost_triangles_) +
                   " triangles that name a vertex which is not there",
               first_lost_ < 0 ? "" : "accessor " + std::to_string(first_lost_));
  }
}

void GltfMeshes::spend(std::size_t indices) {
  if (indices > budget_) file_.fail("too many primitives share the same indices");
  budget_ -= indices;
}

std::vector<std::uint32_t> GltfMeshes::triangles_of(const tinygltf::Primitive& primitive,
                                                    std::size_t vertex_count) {
  std::vector<std::uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = accessors_.indices(primitive.indices);
    spend(indices.size());
  } else {
    spend(vertex_count);
    indices.resize(vertex_count);
    for (std::size_t i = 0; i < vertex_count; ++i) indices[i] = static_cast<std::uint32_t>(i);
  }
  std::vector<std::uint32_t> triangles = unrolled(indices, primitive.mode);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::uint32_t* corner = &triangles[i];
    const bool good =
        corner[0] < vertex_count && corner[1] < vertex_count && corner[2] < vertex_count;
    if (good) {
      for (std::size_t k = 0; k < 3; ++k) triangles[kept++] = corner[k];
    } else if (lost_triangles_++ == 0) {
      first_lost_ = primitive.indices;
    }
  }
  triangles.resize(kept);
  return triangles;
}

const GltfNumbers* GltfMeshes::attribute(const tinygltf::Primitive& primitive,
                                         const std::string& name, int least_components,
                                         std::size_t vertex_count) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end()) return nullptr;
  const GltfNumbers& numbers = accessors_.floats(found->second);
  if (numbers.components >= least_components && numbers.count >= vertex_count) return &numbers;
  file_.warn(name + " does not fit the positions; drawn without it",
             "accessor " + std::to_string(found->second));
  return nullptr;
}

/// Makes indices count only the vertices that they name, which are returned: primitives often share
/// one large accessor and show a part of it each.
std::vector<std::uint32_t> GltfMeshes::take_used(std::vector<std::uint32_t>& indices,
                                                 std::size_t vertex_count) {
  if (new_index_.size() < vertex_count) new_index_.resize(vertex_count, kUnused);
  std::vector<std::uint32_t> used;
  for (std::uint32_t& index : indices) {
    std::uint32_t& number = new_index_[index];
    if (number == kUnused) {
      number = static_cast<std::uint32_t>(used.size());
      used.push_back(index);
    }
    index = number;
  }
  for (const std::uint32_t index : used) new_index_[index] = kUnused;
  return used;
}

std::optional<Mesh> GltfMeshes::read(const tinygltf::Primitive& primitive) {
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    ++lost_primitives_;
    return {};
  }
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) return {};
  const GltfNumbers& positions = accessors_.floats(position->second);
  if (positions.components != 3) {
    file_.fail("positions must be VEC3", "accessor " + std::to_string(position->second));
  }
  Mesh mesh;
  mesh.indices = triangles_of(primitive, positions.count);
  const std::vector<std::uint32_t> used = take_used(mesh.indices, positions.count);
  mesh.positions = gather<glm::vec3>(&positions, used);
  mesh.normals = gather<glm::vec3>(attribute(primitive, "NORMAL", 3, positions.count), used);
  mesh.colours = gather<glm::vec3>(attribute(primitive, "COLOR_0", 3, positions.count), used);
  const bool has_material = primitive.material >= 0 &&
                            static_cast<std::size_t>(primitive.material) < model_.materials.size();
  mesh.material = has_material ? primitive.material : -1;
  const GltfTexcoords texcoords = materials_.texcoords_of(mesh.material);
  mesh.texcoords = gather<glm::vec2>(
      attribute(primitive, "TEXCOORD_" + std::to_string(texcoords.set), 2, positions.count), used);
  for (glm::vec2& uv : mesh.texcoords) uv = texcoords.apply(uv);
  return mesh;
}

}  // namespace kinescope
