// Phong's illumination law for one point: the scalar reference of shading/kernels/illuminate-inl.h.
// Sources: B. T. Phong, "Illumination for computer generated pictures", CACM 18(6), 1975;
// J. F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "shading/limits.h"
#include "shading/surface.h"

namespace kinescope {

LitColour light_point(const Surface& surface, glm::vec3 position, glm::vec3 n, glm::vec3 colour,
                      bool half_vector) {
  const Material& material = surface.material;
  const glm::vec3 to_eye = normalized(surface.eye - position);
  if (material.double_sided && glm::dot(n, to_eye) < 0.0f) n = -n;
  glm::vec3 diffuse = surface.ambient;
  glm::vec3 highlight(0.0f);
  for (const Light& light : surface.lights) {
    const Incident in = incident_light(light, position);
    const float cos_in = glm::dot(n, in.to_light);
    if (!(cos_in > 0.0f)) continue;
    diffuse += cos_in * in.colour;
    const float cos_highlight = half_vector ? glm::dot(n, normalized(in.to_light + to_eye))
                                            : glm::dot(2.0f * cos_in * n - in.to_light, to_eye);
    if (!(cos_highlight > 0.0f)) continue;
    highlight +=
        std::pow(std::min(cos_highlight, 1.0f), std::max(material.shininess, 0.0f)) * in.colour;
  }
  return {material.base_colour * colour * diffuse,
          material.specular * highlight + material.emission};
}

}  // namespace kinescope
