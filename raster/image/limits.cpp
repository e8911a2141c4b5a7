#include "raster/image/limits.h"

#include "raster/base/error.h"
#include "raster/image/codecs.h"

namespace kinescope {

void check_image_size(std::int64_t width, std::int64_t height, std::int64_t max_pixels,
                      const std::string& name) {
  const std::string size =
      "a picture of " + std::to_string(width) + "x" + std::to_string(height) + " pixels";
  if (width <= 0 || height <= 0) throw_bad_input(size + " has no pixels", name);
  if (width > kMaxImageSide || height > kMaxImageSide || width * height > kMaxImagePixels) {
    throw_bad_input(size + " is too large; the limits are " + std::to_string(kMaxImageSide) +
                        " pixels a side and " + std::to_string(kMaxImagePixels) + " in all",
                    name);
  }
  if (width * height > max_pixels) {
    throw_bad_input(size + " cannot be held by so short a file: it is cut off or damaged", name);
  }
}

}  // namespace kinescope
