// Pictures and film from and to files. Each codec library stays in one file of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "raster/base/units.h"
#include "raster/image/image.h"

namespace kinescope {

/// Largest picture that readers and writers take, pixels a side.
inline constexpr int kMaxImageSide = 32768;
/// Largest picture that readers take, pixels in all.
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 28;

/// Any PNG or JPEG, told apart by content, as 8-bit RGBA.
/// @param name what an Error calls the data
/// @throws Error (bad input)
Image<Srgb8> read_image(std::span<const std::uint8_t> bytes, const std::string& name);
Image<Srgb8> read_image_file(const std::string& path);
Image<Srgb8> read_png(std::span<const std::uint8_t> bytes, const std::string& name);
Image<Srgb8> read_jpeg(std::span<const std::uint8_t> bytes, const std::string& name);

/// RGBA; alpha is left out where it is opaque everywhere. `path` "-" is standard output; a file
/// is replaced only when whole.
/// @throws Error (cannot write)
void write_png(const std::string& path, const Image<Srgb8>& picture);
void write_png(const std::string& path, const Image<Srgb16>& picture);

/// YUV4MPEG2, 4:4:4, 8 bits, BT.601 limited range, which a tag of our own names; readers such as
/// ffmpeg take it as it is.
class Y4mWriter {
 public:
  /// `path` "-" is standard output. @throws Error (cannot write)
  Y4mWriter(const std::string& path, int width, int height, Rate frame_rate);
  ~Y4mWriter();  ///< without close(): removes what was written
  Y4mWriter(const Y4mWriter&) = delete;
  Y4mWriter& operator=(const Y4mWriter&) = delete;
  void write(const Image<Srgb8>& frame);
  /// Ends the film and gives the file its name.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kinescope
