// A turning wireframe on a display machine.
#pragma once

#include <memory>

#include "demos/vector_film.h"
#include "demos/wire_model.h"

namespace kinescope {

/// A model, how it is drawn, and on which machine.
struct WireRequest {
  std::shared_ptr<const WireModel> model;
  WireStyle style;
  VectorMachine machine;
  double turn_rad_per_s = 0;
};

/// Refreshed from two buffers: as each refresh begins, the list of the next is made for that
/// moment, so the model turns in as many steps a second as the tube allows. What the host needs to
/// make a list takes no time of the tube's; its memory is as large as the lists need.
/// @throws Error (usage) if the machine draws no lines
VectorShow wire_show(const WireRequest& request, Size size, Workers& workers);

}  // namespace kinescope
