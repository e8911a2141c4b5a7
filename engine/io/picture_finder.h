// Finds and reads the pictures and other files that a model names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/io/reader.h"
#include "raster/colour/colour.h"
#include "raster/image/image.h"

namespace kinescope {

/// The path of a file that a model names relative to its own folder; nothing if it is not there.
/// A name made on Windows (with backslashes) is understood. An absolute one is not
/// followed: what it ends in is looked for beside the model instead.
std::optional<std::string> find_beside(const std::string& model_path, const std::string& name);

class PictureFinder {
 public:
  explicit PictureFinder(const ModelFile& file) : file_(file) {}

  /// Reads a PNG or JPEG; warns, and gives nothing, where it is missing or no picture.
  std::optional<Image<Srgb8>> find(const std::string& name) const;
  std::optional<Image<Srgb8>> decode(std::span<const std::uint8_t> bytes,
                                     const std::string& name) const;

 private:
  const ModelFile& file_;
};

}  // namespace kinescope
