#include "engine/projection/orthographic.h"

#include "engine/transform/transform3d.h"

namespace kinescope {

glm::dmat4 picture_from_world(OrthographicView view) {
  switch (view) {
    case OrthographicView::kFront:
      return glm::dmat4(1.0);
    case OrthographicView::kTop:
      return rotation_x_deg(90);
    case OrthographicView::kSide:
      return rotation_y_deg(-90);
  }
  return glm::dmat4(1.0);
}

}  // namespace kinescope
