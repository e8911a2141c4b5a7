// The pictures that are drawn side by side with other rasterizers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/scene.h"
#include "shading/surface.h"

namespace kinescope::bench {

/// One scene seen by a moving camera. All its meshes are culled by their back faces.
struct Workload {
  std::string name;
  Scene scene;  ///< every mesh has normals and texture coordinates; node transforms are identities
  ShadingModel shading = ShadingModel::kPhong;
  std::function<Camera(int frame, float aspect)> camera;
};

/// The names that make_workload takes, in the order of the table.
std::vector<std::string> workload_names();

/// @throws Error (usage) naming the known ones
Workload make_workload(const std::string& name);

/// A model file as a workload. @throws Error (bad input)
Workload model_workload(const std::string& path);

}  // namespace kinescope::bench
