#include "raster/aligned_vector.h"

template class std::vector<float, kinescope::CacheLineAllocator<float>>;
