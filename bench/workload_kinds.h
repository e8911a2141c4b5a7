// The families of pictures, and what they share.
#pragma once

#include "bench/workloads.h"

namespace kinescope::bench {

/// The surface and the two point lights of every lit workload.
Material bench_material();
void add_bench_lights(Scene& scene);

/// Quads along the knot and around its tube.
struct KnotShape {
  int along, around;
  ShadingModel shading;
  bool textured;
};
Workload knot_workload(const KnotShape& shape);

/// Quads that fill the picture, one behind another: colours interpolated, or a trilinear texture.
/// Those that are not opaque run from far to near.
Workload layers_workload(int layers, bool near_first, bool textured, float opacity = 1.0f);

/// 40 x 40 boxes seen from the street, in random order.
Workload city_workload();

/// Triangles with legs of `leg_px` pixels at random places and depths of a 1920x1080 picture:
/// `most` of them, or as many as cover 24 pictures.
Workload sweep_workload(int leg_px, int most = 1'000'000);

}  // namespace kinescope::bench
