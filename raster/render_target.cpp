#include "raster/render_target.h"

#include <new>
#include <stdexcept>
#include <string>

#include "raster/base/error.h"
#include "raster/sample_pattern.h"

namespace kinescope {
namespace {

template <typename Pixel>
Image<Pixel> allocate(int width, int height) {
  try {
    return Image<Pixel>(width, height);
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  const auto megabytes = static_cast<unsigned long long>(width) *
                         static_cast<unsigned long long>(height) * sizeof(Pixel) / 1000000;
  throw Error(ErrorKind::kUsage, "no memory for a picture of " + std::to_string(width) + "x" +
                                     std::to_string(height) + " (" + std::to_string(megabytes) +
                                     " MB); ask for a smaller one");
}

}  // namespace

RenderTarget::RenderTarget(int w, int h, int sample_count, ColourFormat format)
    : width(w), height(h), samples(sample_count) {
  if (w < 1 || h < 1 || w > kMaxSize || h > kMaxSize) {
    throw Error(ErrorKind::kUsage, "a picture is 1x1 to " + std::to_string(kMaxSize) + "x" +
                                       std::to_string(kMaxSize) + " pixels, not " +
                                       std::to_string(w) + "x" + std::to_string(h));
  }
  static_cast<void>(sample_pattern(samples));
  switch (format) {
    case ColourFormat::kSrgb8:
      colour = allocate<Srgb8>(w, h);
      break;
    case ColourFormat::kLinear8:
      colour = allocate<Linear8>(w, h);
      break;
    case ColourFormat::kLinearFloat:
      colour = allocate<LinearRgba>(w, h);
      break;
  }
}

}  // namespace kinescope
