// The user's own model in a window: turned by hand, shaded by keys, on its tube or bare.
#pragma once

#include "demos/demo.h"
#include "demos/model_film.h"
#include "demos/options.h"

namespace kinescope {

/// A demo of the scene. It starts with the view, shading, samples and display that were asked for.
DemoInfo model_demo(Scene scene, const RenderOptions& options, const ModelFilmPlan& plan);

}  // namespace kinescope
