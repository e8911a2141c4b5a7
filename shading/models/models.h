// The shading models, one file each: each gives its shader for the instruction set in use.
#pragma once

#include "raster/batch.h"

namespace kinescope {

ShadeFunction flat_shader();
ShadeFunction gouraud_shader();
ShadeFunction phong_shader();
ShadeFunction blinn_shader();
ShadeFunction unlit_shader();

}  // namespace kinescope
