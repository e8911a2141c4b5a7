#include "raster/kernels/batch_storage.h"

#include <cstddef>

namespace kinescope {

Batch batch_of(const DrawCall& draw, BatchStorage& storage, int size) {
  Batch batch;
  batch.size = size;
  batch.constants = draw.constants;
  batch.x = storage.x.data();
  batch.y = storage.y.data();
  batch.primitive = storage.triangle.data();
  if (!draw.source_triangle.empty()) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
      storage.primitive[i] = draw.source_triangle[storage.triangle[i]];
    }
    batch.primitive = storage.primitive.data();
  }
  for (std::size_t a = 0; a < static_cast<std::size_t>(draw.attribute_count); ++a) {
    batch.attribute[a] = storage.attribute[a].data();
  }
  if (draw.cull == CullMode::kNone) batch.facing = storage.facing.data();
  if (draw.texcoord_attribute >= 0) {
    batch.du_dx = storage.gradient[0].data();
    batch.dv_dx = storage.gradient[1].data();
    batch.du_dy = storage.gradient[2].data();
    batch.dv_dy = storage.gradient[3].data();
  }
  return batch;
}

}  // namespace kinescope
