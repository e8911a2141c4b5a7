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

std::uint32_t attributes_read(ShadingModel model, const Surface& surface) {
  const auto bits = [](int first, int count) { return ((1u << count) - 1) << first; };
  static_assert(vertex_row::kTexcoord == lit_row::kTexcoord);
  const std::uint32_t read = surface.texture != nullptr ? bits(vertex_row::kTexcoord, 2) : 0;
  const std::uint32_t colour = surface.vertex_colours ? bits(vertex_row::kColour, 3) : 0;
  switch (model) {
    case ShadingModel::kFlat:
      return read;
    case ShadingModel::kGouraud:
      return read | bits(lit_row::kBody, 3) |
             (keeps_highlight_apart(surface) ? bits(lit_row::kHighlight, 3) : 0);
    case ShadingModel::kPhong:
    case ShadingModel::kBlinn:
      return read | colour | bits(vertex_row::kPosition, 3) | bits(vertex_row::kNormal, 3);
    case ShadingModel::kUnlit:
      return read | colour;
  }
  return ~0u;
}

}  // namespace kinescope
