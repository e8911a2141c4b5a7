// Films made by hand.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "raster/image/video.h"

namespace kinescope::testing {

/// A film of one frame whose planes hold these bytes.
inline std::string film_of(const std::string& header, const std::string& planes) {
  return header + "\nFRAME\n" + planes;
}

/// A film's bytes, and its reader.
class HeldFilm {
 public:
  explicit HeldFilm(const std::string& bytes)
      : bytes_(bytes.begin(), bytes.end()),
        file_(bytes_, "film"),
        reader_(read_y4m(file_, workers_)) {}
  VideoReader& operator*() { return *reader_; }
  VideoReader* operator->() { return reader_.get(); }

 private:
  std::vector<std::uint8_t> bytes_;
  InputFile file_;
  Workers workers_{2};
  std::unique_ptr<VideoReader> reader_;
};

/// The first frame of a film.
inline Image<Srgb8> first_frame(const std::string& bytes) {
  HeldFilm film(bytes);
  Image<Srgb8> frame;
  if (!film->read(frame)) throw std::runtime_error("no frame");
  return frame;
}

}  // namespace kinescope::testing
