#include "engine/io/import.h"

#include <cstring>
#include <filesystem>
#include <optional>

#include "engine/io/reader.h"
#include "engine/io/text.h"
#include "raster/base/input_file.h"

namespace kinescope {
namespace {

/// What the first bytes say.
std::optional<ModelFormat> format_by_content(const ModelFile& file) {
  std::string_view text = as_text(file.bytes);
  if (text.starts_with("glTF")) return ModelFormat::kGltf;
  if (is_binary_stl(file)) return ModelFormat::kStl;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
  if (word == "ply") return ModelFormat::kPly;
  if (word.size() <= 7 && word.ends_with("OFF")) return ModelFormat::kOff;
  if (text.starts_with('{')) return ModelFormat::kGltf;
  if (is_ascii_stl(file)) return ModelFormat::kStl;
  return {};
}

std::optional<ModelFormat> format_by_ending(const std::string& path) {
  const std::string ending = lower_case(std::filesystem::path(path).extension().string());
  if (ending == ".gltf" || ending == ".glb") return ModelFormat::kGltf;
  if (ending == ".obj") return ModelFormat::kObj;
  if (ending == ".ply") return ModelFormat::kPly;
  if (ending == ".stl") return ModelFormat::kStl;
  if (ending == ".off") return ModelFormat::kOff;
  return {};
}

}  // namespace

void ModelFile::fail(const std::string& what, const std::string& where) const {
  throw_bad_input(printable(what), path, where);
}

void ModelFile::warn(const std::string& what, const std::string& where) const {
  warnings.push_back(Error(ErrorKind::kBadInput, printable(what), path, printable(where)).what());
}

ModelFormat detect_format(const ModelFile& file) {
  if (file.bytes.empty()) file.fail("the file is empty");
  if (const auto format = format_by_content(file)) return *format;
  if (const auto format = format_by_ending(file.path)) return *format;
  file.fail("not a model file of a known kind (glTF, GLB, OBJ, PLY, STL or OFF)");
}

Scene scene_of(std::vector<Mesh> meshes) {
  Scene scene;
  Node node;
  for (std::size_t i = 0; i < meshes.size(); ++i) node.meshes.push_back(static_cast<int>(i));
  scene.meshes = std::move(meshes);
  scene.nodes.push_back(std::move(node));
  return scene;
}

Scene read_model(const ModelFile& file, ModelFormat format) {
  Scene scene;
  switch (format) {
    case ModelFormat::kGltf:
      scene = read_gltf(file);
      break;
    case ModelFormat::kObj:
      scene = read_obj(file);
      break;
    case ModelFormat::kPly:
      scene = read_ply(file);
      break;
    case ModelFormat::kStl:
      scene = read_stl(file);
      break;
    case ModelFormat::kOff:
      scene = read_off(file);
      break;
  }
  finish(scene, file);
  return scene;
}

Scene import_model(const std::string& path, Warnings& warnings) {
  std::error_code ignored;
  if (path != "-" && std::filesystem::is_directory(path, ignored)) {
    throw_bad_input("this is a folder, not a model file", path);
  }
  const std::vector<std::uint8_t> bytes = read_file(path);
  const ModelFile file{path, bytes, warnings};
  return read_model(file, detect_format(file));
}

bool looks_like_model(const std::string& path, std::span<const std::uint8_t> first_bytes) {
  Warnings unused;
  return format_by_ending(path) || format_by_content({path, first_bytes, unused});
}

}  // namespace kinescope
