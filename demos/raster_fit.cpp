#include "demos/raster_fit.h"

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

Srgb8 over_black(Srgb8 code) {
  const LinearRgba c = decode(code);
  return encode_srgb8(LinearRgb{c.r * c.a, c.g * c.a, c.b * c.a});
}

}  // namespace

Size fitted_box(Size picture, double picture_aspect, Size raster, double face_aspect, Fit fit) {
  if (fit == Fit::kNative) return picture;
  if (fit == Fit::kFill || picture == raster) return raster;
  // Shares of the face across and down; a border of under 2% is left out, as it would be on a set.
  const double shape = picture_aspect / face_aspect;
  constexpr double kNearly = 0.98;
  const double across = shape < kNearly ? shape : 1, down = 1 / shape < kNearly ? 1 / shape : 1;
  return {std::max(1, static_cast<int>(std::lround(raster.width * across))),
          std::max(1, static_cast<int>(std::lround(raster.height * down)))};
}

RasterFit::RasterFit(Size picture, double picture_aspect, Size raster, double face_aspect, Fit fit,
                     FieldOrder fields, Workers& workers)
    : picture_(picture),
      raster_(raster),
      box_(fitted_box(picture, picture_aspect, raster, face_aspect, fit)),
      line_lower_(fields == FieldOrder::kBottomFirst),
      workers_(workers),
      out_(raster.width, raster.height) {
  if (fields != FieldOrder::kProgressive) box_.height = raster.height;
  if (box_.width % picture.width == 0 && box_.height % picture.height == 0) return;
  resample_.emplace(picture.width, picture.height, box_.width, box_.height);
}

void RasterFit::repeat(const Image<Srgb8>& picture) {
  // Pixels that would lie beyond the raster are cut off on both sides alike.
  const int across = box_.width / picture_.width, down = box_.height / picture_.height;
  const int left = (raster_.width - box_.width) / 2, top = (raster_.height - box_.height) / 2;
  const int first_x = std::max(0, left), end_x = std::min(raster_.width, left + box_.width);
  for (int y = std::max(0, top); y < std::min(raster_.height, top + box_.height); ++y) {
    const Srgb8* const from = picture.row((y - top) / down);
    Srgb8* const to = out_.row(y);
    for (int x = first_x; x < end_x; ++x) {
      const Srgb8 c = from[(x - left) / across];
      to[x] = c.a == 255 ? c : over_black(c);
    }
  }
}

void RasterFit::lay_down(const Image<Srgb8>& picture) {
  const int left = (raster_.width - box_.width) / 2, top = (raster_.height - box_.height) / 2;
  for (int y = 0; y < box_.height; ++y) {
    std::copy_n(picture.row(y), box_.width, out_.row(top + y) + left);
  }
}

const Image<Srgb8>& RasterFit::operator()(const Image<Srgb8>& picture) {
  resample_ ? lay_down((*resample_)(picture, workers_)) : repeat(picture);
  // A frame whose lower field comes first, moved down a line, has its upper field first.
  if (line_lower_) {
    for (int y = raster_.height - 1; y > 0; --y) {
      std::copy_n(out_.row(y - 1), raster_.width, out_.row(y));
    }
    std::fill_n(out_.row(0), raster_.width, Srgb8{});
  }
  return out_;
}

}  // namespace kinescope
