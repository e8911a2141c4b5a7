// Vertex normals for meshes that bring none.
#pragma once

#include "engine/scene.h"

namespace kinescope {

/// Replaces mesh.normals by unit vertex normals: each vertex sums the normals of its triangles,
/// weighted by the angle at the vertex, so the way a polygon was split does not matter. Vertices
/// are shared by index. Triangles that are degenerate, not finite or index past the end add
/// nothing; a vertex for which nothing is left gets +y.
/// Source: Thuermer and Wuethrich, "Computing Vertex Normals from Polygonal Facets", 1998.
void compute_normals(Mesh& mesh);

}  // namespace kinescope
