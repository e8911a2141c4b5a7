// Wavefront OBJ with its MTL. tinyobjloader takes the lines apart and reads the materials. It is
// handed one line at a time, so that this reader knows the line at work; vertices, whose colours it
// would not show, and smoothing groups are read here; every index is checked in obj_mesh.
// Source: Wavefront, "Advanced Visualizer Manual", appendix B1, 1992.
#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "engine/io/colours.h"
#include "engine/io/obj_lines.h"
#include "engine/io/obj_mesh.h"
#include "engine/io/picture_finder.h"
#include "engine/io/text.h"
#include "raster/base/input_file.h"

namespace kinescope {
namespace {

float at_most(tinyobj::real_t value, float limit) {
  return value > 0 ? std::min(static_cast<float>(value), limit) : 0.0f;
}

glm::vec3 colour_of(const tinyobj::real_t (&rgb)[3]) {
  return linear_from_srgb(static_cast<double>(rgb[0]), static_cast<double>(rgb[1]),
                          static_cast<double>(rgb[2]));
}

/// Reads MTL files into a scene's materials and textures.
class ObjMaterials : public tinyobj::MaterialReader {
 public:
  ObjMaterials(Scene& scene, const ModelFile& file, const ObjLines& lines)
      : scene_(scene), file_(file), lines_(lines), finder_(file) {}

  bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                  std::map<std::string, int>* indices, std::string* warning,
                  std::string* error) override {
    // The library cuts the line at spaces, which file names may have.
    std::optional<std::string> path = find_beside(file_.path, std::string(lines_.arguments()));
    if (!path) path = find_beside(file_.path, name);
    if (!path) {
      if (missing_.insert(name).second) {
        file_.warn("the material file " + name.substr(0, 80) + " is missing; drawn without it");
      }
      return false;
    }
    try {
      const std::vector<std::uint8_t> bytes = read_file(*path);
      const std::string text = plain_text(as_text(bytes));
      ObjLines lines(text, [](std::string_view) { return false; });
      std::istream stream(&lines);
      tinyobj::LoadMtl(indices, materials, &stream, warning, error);
    } catch (const Error& fault) {
      file_.warnings.push_back(printable(fault.what()));
      return false;
    }
    while (scene_.materials.size() < materials->size()) {
      add((*materials)[scene_.materials.size()]);
    }
    return true;
  }

 private:
  void add(const tinyobj::material_t& mtl) {
    Material material;
    material.name = mtl.name;
    material.base_colour = colour_of(mtl.diffuse);
    // Illumination model 1 has no highlight.
    if (mtl.illum != 1) material.specular = colour_of(mtl.specular);
    material.shininess = std::max(at_most(mtl.shininess, 10000.0f), 1.0f);
    material.emission = colour_of(mtl.emission);
    // Nobody means a material that cannot be seen: some tools write 0 for opaque.
    material.opacity = at_most(mtl.dissolve, 1.0f);
    if (material.opacity == 0.0f) material.opacity = 1.0f;
    material.base_texture = texture_of(mtl);
    const bool is_black = material.base_colour == glm::vec3(0.0f);
    if (material.base_texture >= 0 && is_black) material.base_colour = glm::vec3(1.0f);
    scene_.materials.push_back(std::move(material));
  }

  int texture_of(const tinyobj::material_t& mtl) {
    const std::string& name = mtl.diffuse_texname;
    if (name.empty()) return -1;
    const auto [entry, is_new] = textures_.try_emplace({name, mtl.diffuse_texopt.clamp}, -1);
    if (!is_new) return entry->second;
    const auto picture = finder_.find(name);
    if (!picture) return -1;
    const Wrap wrap = mtl.diffuse_texopt.clamp ? Wrap::kClamp : Wrap::kRepeat;
    entry->second = static_cast<int>(scene_.textures.size());
    scene_.textures.emplace_back(*picture, Filter::kTrilinear, wrap, wrap);
    scene_.textures.back().name = name;
    return entry->second;
  }

  Scene& scene_;
  const ModelFile& file_;
  const ObjLines& lines_;
  PictureFinder finder_;
  std::map<std::pair<std::string, bool>, int> textures_;
  std::set<std::string> missing_;
};

/// Takes what the library and ObjLines find.
class ObjCollector {
 public:
  explicit ObjCollector(const ModelFile& file)
      : file_(file),
        text_(plain_text(as_text(file.bytes))),
        lines_(text_, [this](std::string_view line) { return take(line); }) {}

  Scene read() {
    Scene scene;
    ObjMaterials materials(scene, file_, lines_);
    std::istream stream(&lines_);
    tinyobj::callback_t callbacks;
    callbacks.normal_cb = [](void* self, float x, float y, float z) {
      static_cast<ObjCollector*>(self)->data_.normals.emplace_back(x, y, z);
    };
    callbacks.texcoord_cb = [](void* self, float u, float v, float) {
      // In OBJ, v runs up from the bottom row.
      static_cast<ObjCollector*>(self)->data_.texcoords.emplace_back(u, 1.0f - v);
    };
    callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      static_cast<ObjCollector*>(self)->add_face(corners, count);
    };
    callbacks.usemtl_cb = [](void* self, const char* name, int index) {
      static_cast<ObjCollector*>(self)->use_material(name, index);
    };
    tinyobj::LoadObjWithCallback(stream, callbacks, this, &materials);
    std::vector<Mesh> meshes = build_obj_meshes(data_, file_);
    Scene shown = scene_of(std::move(meshes));
    shown.materials = std::move(scene.materials);
    shown.textures = std::move(scene.textures);
    return shown;
  }

 private:
  /// Vertices and smoothing groups; and all that no one needs.
  bool take(std::string_view line) {
    const std::string_view key = line.substr(0, line.find_first_of(" \t"));
    if (key == "v") {
      add_vertex(line.substr(1));
    } else if (key == "s") {
      set_smoothing_group(lines_.arguments());
    } else {
      return !(key == "vt" || key == "vn" || key == "f" || key == "usemtl" || key == "mtllib");
    }
    return true;
  }

  void add_vertex(std::string_view numbers) {
    std::array<double, 7> values{};
    std::size_t count = 0;
    while (count < values.size()) {
      numbers.remove_prefix(std::min(numbers.find_first_not_of(" \t"), numbers.size()));
      if (numbers.empty()) break;
      const std::string_view word = numbers.substr(0, numbers.find_first_of(" \t"));
      values[count++] = parse_number(word).value_or(std::numeric_limits<double>::quiet_NaN());
      numbers.remove_prefix(word.size());
    }
    data_.positions.emplace_back(to_float(values[0]), to_float(values[1]), to_float(values[2]));
    if (count < 6 && data_.colours.empty()) return;
    // Six numbers are a position and a colour; seven, with a weight between them.
    const std::size_t first = count == 7 ? 4 : 3;
    data_.colours.resize(data_.positions.size() - 1, glm::vec3(1.0f));
    data_.colours.push_back(
        count < 6 ? glm::vec3(1.0f)
                  : linear_from_srgb(values[first], values[first + 1], values[first + 2]));
  }

  void set_smoothing_group(std::string_view name) {
    const double group = parse_number(name).value_or(0.0);  // "off"
    smoothing_group_ = group >= 1.0 && group < 4e9 ? static_cast<std::uint32_t>(group) : 0;
    data_.has_smoothing_groups = true;
  }

  /// The library takes no care of numbers beyond an int's range.
  static bool has_huge_number(std::string_view text) {
    std::size_t digits = 0;
    for (const char c : text) {
      digits = c >= '0' && c <= '9' ? digits + 1 : 0;
      if (digits > 9) return true;
    }
    return false;
  }

  void add_face(const tinyobj::index_t* corners, int count) {
    if (has_huge_number(lines_.arguments())) {
      data_.corners.insert(data_.corners.end(), 3, ObjData::Corner{-1, -1, -1});
      count = 0;
    }
    for (int i = 0; i < count; ++i) {
      data_.corners.push_back({from_zero(corners[i].vertex_index, data_.positions.size()),
                               from_zero(corners[i].texcoord_index, data_.texcoords.size()),
                               from_zero(corners[i].normal_index, data_.normals.size())});
    }
    data_.faces.push_back({data_.corners.size(), lines_.number(), material_, smoothing_group_});
  }

  /// OBJ counts from 1, or back from the newest with numbers below 0; 0 is none.
  static std::int64_t from_zero(int index, std::size_t count) {
    return index < 0 ? static_cast<std::int64_t>(count) + index : std::int64_t{index} - 1;
  }

  void use_material(const std::string& name, int index) {
    material_ = index;
    if (index >= 0 || !unknown_.insert(name).second) return;
    file_.warn("the material " + name.substr(0, 80) + " is not defined; drawn with the default",
               "line " + std::to_string(lines_.number()));
  }

  const ModelFile& file_;
  std::string text_;
  ObjData data_;
  int material_ = -1;
  std::uint32_t smoothing_group_ = 0;
  std::set<std::string> unknown_;
  ObjLines lines_;
};

}  // namespace

Scene read_obj(const ModelFile& file) { return ObjCollector(file).read(); }

}  // namespace kinescope
