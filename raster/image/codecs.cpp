#include "raster/image/codecs.h"

#include <array>

#include "raster/base/error.h"
#include "raster/base/input_file.h"

namespace kinescope {

Image<Srgb8> read_image(std::span<const std::uint8_t> bytes, const std::string& name) {
  const auto begins_with = [bytes](std::span<const std::uint8_t> signature) {
    return bytes.size() >= signature.size() &&
           std::equal(signature.begin(), signature.end(), bytes.begin());
  };
  static constexpr std::array<std::uint8_t, 4> kPng{0x89, 'P', 'N', 'G'};
  static constexpr std::array<std::uint8_t, 3> kJpeg{0xff, 0xd8, 0xff};
  if (bytes.empty()) throw_bad_input("an empty file, not a picture", name);
  if (begins_with(kPng)) return read_png(bytes, name);
  if (begins_with(kJpeg)) return read_jpeg(bytes, name);
  throw_bad_input("neither a PNG nor a JPEG picture", name);
}

Image<Srgb8> read_image_file(const std::string& path) {
  return read_image(read_file(path), path == "-" ? "standard input" : path);
}

}  // namespace kinescope
