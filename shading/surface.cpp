#include "shading/surface.h"

#include <hwy/targets.h>

#include <cassert>

#include "shading/models/models.h"

namespace kinescope {

ShadeFunction shade_function(ShadingModel model) {
  struct Entry {
    ShadingModel model;
    ShadeFunction (*shader)();
  };
  constexpr Entry kModels[] = {
      {ShadingModel::kFlat, flat_shader},   {ShadingModel::kGouraud, gouraud_shader},
      {ShadingModel::kPhong, phong_shader}, {ShadingModel::kBlinn, blinn_shader},
      {ShadingModel::kUnlit, unlit_shader},
  };
  // Before its first choice Highway would hand out functions that choose again at every call.
  hwy::ChosenTarget& chosen = hwy::GetChosenTarget();
  if (!chosen.IsInitialized()) chosen.Update(hwy::SupportedTargets());
  for (const Entry& entry : kModels) {
    if (entry.model == model) return entry.shader();
  }
  assert(false && "a shading model without a shader");
  return unlit_shader();
}

}  // namespace kinescope
