#include "demos/model_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "demos/arrange.h"
#include "engine/io/import.h"

namespace kinescope {

Scene import_models(const std::vector<std::string>& paths, Warnings& warnings) {
  std::vector<Scene> scenes;
  for (const std::string& path : paths) {
    scenes.push_back(import_model(path, warnings));
    if (drawn_triangle_count(scenes.back()) == 0) throw_bad_input("has no triangles to draw", path);
  }
  return side_by_side(std::move(scenes));
}

RenderOptions with_up_of_files(RenderOptions options) {
  const auto& models = options.models;
  const bool all_stl = std::all_of(models.begin(), models.end(), [](const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".stl";
  });
  if (all_stl && !options.up) options.up = glm::vec3(0, 0, 1);
  return options;
}

}  // namespace kinescope
