// Where finished pictures go: one PNG, numbered PNGs, a y4m film or raw RGB; a file or standard
// output.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <variant>

#include "demos/options.h"
#include "demos/picture.h"
#include "raster/base/output_file.h"
#include "raster/base/units.h"
#include "raster/colour/colour.h"
#include "raster/image/codecs.h"

namespace kinescope {

enum class FilmFormat { kPng, kY4m, kRaw };

/// A picture as it is written: 8 or 16 bits a channel.
using FilmPicture = std::variant<Image<Srgb8>, Image<Srgb16>>;

/// The format of an output: `format` ("png", "y4m", "raw") if given, else by the name's ending; "-"
/// and names without an ending hold a PNG for one frame and a y4m film for more.
/// @throws Error (usage) if the ending says nothing, or if several frames are to be one PNG
FilmFormat film_format(const std::string& output, const std::string& format, bool several_frames);

/// @throws Error (usage) if the output cannot be of that format with these options
void check_output(const Options& options, FilmFormat format);

/// @throws Error (cannot write) if the folder is missing or closed to us, so that long work does
/// not end in vain
void check_writable(const std::string& output);

/// Where pictures go that nobody named: out/STEM.png, or .y4m for several frames. Makes the folder.
/// @throws Error (cannot write) if there can be no such folder
std::string output_in_out(const std::string& stem, bool several_frames);

/// Bytes that a pixel of a photographed tube takes: the light of a refresh, the sum over an
/// exposure, the encoded pixel and its copy on black.
constexpr double tube_bytes_a_pixel(std::size_t encoded_bytes) {
  return static_cast<double>(2 * sizeof(LinearRgb) + 2 * encoded_bytes);
}

/// @param bytes that pictures of this size take
/// @throws Error (usage) if there is less memory than that
void check_memory(Size size, double bytes);

/// Takes frames in order. What it wrote appears when it is whole: numbered pictures one by one, a
/// film when closed.
class Film {
 public:
  /// @throws Error (cannot write, or usage)
  Film(std::string output, FilmFormat format, Size size, Rate rate);
  /// @param number of the frame, for numbered names
  void write(const Image<Srgb8>& picture, int number);
  /// @pre the format is PNG
  void write(const Image<Srgb16>& picture, int number);
  void write(const FilmPicture& picture, int number) {
    std::visit([&](const auto& p) { write(p, number); }, picture);
  }
  void close();

 private:
  void write_raw(const Image<Srgb8>& picture);
  std::string output_;
  FilmFormat format_;
  std::unique_ptr<Y4mWriter> y4m_;
  std::unique_ptr<OutputFile> raw_;
};

}  // namespace kinescope
