#include "engine/io/obj_mesh.h"

#include <deque>
#include <limits>
#include <map>
#include <span>
#include <unordered_map>

#include "engine/io/crease_normals.h"
#include "engine/io/polygon.h"

namespace kinescope {
namespace {

struct CornerHash {
  std::size_t operator()(const ObjData::Corner& corner) const {
    std::uint64_t hash = 0;
    for (const std::int64_t index : corner) {
      hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

bool is_there(std::int64_t index, std::size_t count) {
  return index >= 0 && static_cast<std::size_t>(index) < count;
}

/// The mesh of one material.
class ObjPart {
 public:
  ObjPart(const ObjData& data, const ModelFile& file, int material)
      : data_(data), sink_(mesh_, file, "line") {
    mesh_.material = material;
  }

  void add(std::span<const ObjData::Corner> corners, const ObjData::Face& face) {
    indices_.clear();
    for (const ObjData::Corner& corner : corners) indices_.push_back(index_of(corner));
    const std::size_t added = sink_.add(indices_, face.line);
    groups_.insert(groups_.end(), added, face.smoothing_group);
  }

  Mesh take() {
    sink_.warn_of_lost();
    if (!has_texcoords_) mesh_.texcoords.clear();
    // Where only some corners lack a normal, finish() fills it in.
    if (!has_normals_) mesh_.normals.clear();
    if (!has_normals_ && data_.has_smoothing_groups) {
      compute_crease_normals(mesh_, kCreaseRad, groups_);
    }
    return std::move(mesh_);
  }

 private:
  std::uint32_t index_of(const ObjData::Corner& corner) {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    if (!is_there(corner[0], data_.positions.size())) return kNone;
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [entry, is_new] = known_.try_emplace(corner, next);
    if (is_new) add_vertex(corner);
    return entry->second;
  }

  void add_vertex(const ObjData::Corner& corner) {
    const auto position = static_cast<std::size_t>(corner[0]);
    mesh_.positions.push_back(data_.positions[position]);
    if (!data_.colours.empty()) mesh_.colours.push_back(data_.colours[position]);
    const bool textured = is_there(corner[1], data_.texcoords.size());
    const bool has_normal = is_there(corner[2], data_.normals.size());
    has_texcoords_ = has_texcoords_ || textured;
    has_normals_ = has_normals_ || has_normal;
    mesh_.texcoords.push_back(textured ? data_.texcoords[static_cast<std::size_t>(corner[1])]
                                       : glm::vec2(0.0f));
    mesh_.normals.push_back(has_normal ? data_.normals[static_cast<std::size_t>(corner[2])]
                                       : glm::vec3(0.0f));
  }

  const ObjData& data_;
  Mesh mesh_;
  PolygonSink sink_;
  std::unordered_map<ObjData::Corner, std::uint32_t, CornerHash> known_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::uint32_t> groups_;
  bool has_texcoords_ = false;
  bool has_normals_ = false;
};

}  // namespace

std::vector<Mesh> build_obj_meshes(const ObjData& data, const ModelFile& file) {
  std::deque<ObjPart> parts;  // in the order in which materials appear; parts do not move
  std::map<int, ObjPart*> part_of;
  std::size_t begin = 0;
  for (const ObjData::Face& face : data.faces) {
    ObjPart*& part = part_of[face.material];
    if (!part) part = &parts.emplace_back(data, file, face.material);
    part->add(std::span(data.corners).subspan(begin, face.end - begin), face);
    begin = face.end;
  }
  std::vector<Mesh> meshes;
  for (ObjPart& part : parts) meshes.push_back(part.take());
  return meshes;
}

}  // namespace kinescope
