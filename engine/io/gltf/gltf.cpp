// glTF 2 and GLB. tinygltf parses the JSON and gathers the buffers; files are opened and pictures
// decoded by this project, and every number that says where something lies is checked here.
// Source: Khronos, "glTF 2.0 Specification".
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>

#include "engine/io/gltf/accessors.h"
#include "engine/io/gltf/container.h"
#include "engine/io/gltf/materials.h"
#include "engine/io/gltf/meshes.h"
#include "engine/io/gltf/nodes.h"
#include "engine/io/picture_finder.h"
#include "engine/io/text.h"
#include "raster/base/input_file.h"

namespace kinescope {
namespace {

/// What the library's callbacks need.
struct Folder {
  const ModelFile& file;
  std::uint64_t bytes_left = std::uint64_t{1} << 31;  ///< of all outside files together

  /// The library has undone percent-encoding, and made every '+' a space as forms have it.
  std::optional<std::string> find(const std::string& name) const {
    if (auto path = find_beside(file.path, name)) return path;
    std::string plus = name;
    std::replace(plus.begin(), plus.end(), ' ', '+');
    return find_beside(file.path, plus);
  }
};

bool exists(const std::string& name, void* folder) {
  return static_cast<Folder*>(folder)->find(name).has_value();
}

std::string unchanged(const std::string& name, void*) { return name; }

bool read_beside(std::vector<unsigned char>* bytes, std::string* error, const std::string& name,
                 void* user) {
  Folder& folder = *static_cast<Folder*>(user);
  try {
    *bytes = read_file(folder.find(name).value_or(name), folder.bytes_left);
  } catch (const Error& fault) {
    *error = fault.what();
    return false;
  }
  folder.bytes_left -= bytes->size();
  return true;
}

bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
  return false;
}

/// Keeps a picture as it stands in its file; it is decoded when a material shows it. Those in
/// buffer views are found again by their view, since the library has not checked where that lies.
bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
  if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
  return true;
}

/// The library's complaint as one short line; for its commonest, a clearer one.
std::string first_line(const std::string& text) {
  if (text.starts_with("\"asset\"")) return "it does not say that it is glTF 2 (asset.version)";
  const std::string line = text.substr(0, std::min<std::size_t>(text.find('\n'), 200));
  return line.empty() ? "not a glTF file that can be read" : line;
}

void check_version(const tinygltf::Model& model, const ModelFile& file) {
  const std::string& version = model.asset.version;
  if (version.starts_with("2")) return;
  file.fail("this is glTF version " + version.substr(0, 16) + "; only version 2 is read");
}

bool changes_looks_only(const std::string& extension) {
  static constexpr std::array<std::string_view, 4> kLooks{"KHR_materials_", "KHR_technique",
                                                          "KHR_texture_", "EXT_texture_"};
  return std::any_of(kLooks.begin(), kLooks.end(),
                     [&](std::string_view prefix) { return extension.starts_with(prefix); });
}

void check_extensions(const tinygltf::Model& model, const ModelFile& file) {
  static constexpr std::array<std::string_view, 5> kKnown{
      "KHR_lights_punctual", "KHR_texture_transform", "KHR_mesh_quantization",
      "KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness"};
  for (const std::string& name : model.extensionsRequired) {
    if (std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end()) continue;
    const std::string shown = name.substr(0, 64);
    if (!changes_looks_only(name)) {
      file.fail("it requires the extension " + shown + ", which is not read");
    }
    file.warn("drawn without the extension " + shown);
  }
}

tinygltf::Model parse(const ModelFile& file) {
  tinygltf::TinyGLTF parser;
  Folder folder{file};
  parser.SetFsCallbacks({exists, unchanged, read_beside, write_nothing, &folder});
  parser.SetImageLoader(keep_encoded, nullptr);
  tinygltf::Model model;
  std::string error;
  std::string ignored;  // missing pictures, which are told of when a material asks for them
  const auto size = static_cast<unsigned int>(file.bytes.size());
  bool ok = false;
  try {
    ok = is_glb(file)
             ? parser.LoadBinaryFromMemory(&model, &error, &ignored, file.bytes.data(), size)
             : parser.LoadASCIIFromString(&model, &error, &ignored, as_text(file.bytes).data(),
                                          size, "");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& fault) {
    error = fault.what();
  }
  if (ok) return model;
  // A model that this project cannot show at all says so in a clearer way than by its faults.
  check_version(model, file);
  check_extensions(model, file);
  file.fail(first_line(error));
}

}  // namespace

Scene read_gltf(const ModelFile& file) {
  check_gltf_container(file);
  const tinygltf::Model model = parse(file);
  check_version(model, file);
  check_extensions(model, file);
  Scene scene;
  GltfAccessors accessors(model, file);
  GltfMaterials materials(model, accessors, file, scene);
  materials.read_all();
  GltfMeshes meshes(model, accessors, materials, file, scene);
  read_gltf_nodes(model, meshes, file, scene);
  meshes.warn_of_lost();
  return scene;
}

}  // namespace kinescope
