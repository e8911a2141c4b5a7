// Fractal image compression: a picture told as how each of its small blocks looks like a larger
// one. Source: Jacquin, "Image Coding Based on a Fractal Theory of Iterated Contractive Image
// Transformations", 1992.
#pragma once

#include <cstdint>
#include <vector>

namespace kinescope {

class Workers;

/// Grey levels of a square picture, 0 to 1, row by row.
struct GreySquare {
  int side = 0;
  std::vector<float> level;
};

/// How one block is made of one of twice its size: shrunk, turned, its contrast and brightness set.
struct BlockMap {
  std::uint16_t domain_x = 0, domain_y = 0;  ///< in steps of domains
  std::uint8_t turn = 0;                     ///< one of the square's eight symmetries
  float contrast = 0.0f;                     ///< below 1 either way, so that decoding settles
  float brightness = 0.0f;
};

struct FractalCode {
  int blocks = 0;    ///< along a side
  int block_px = 0;  ///< of the picture that was coded
  int domain_step_px = 0;
  std::vector<BlockMap> maps;
};

/// The best of all domains for every block, by least squares.
/// @param block_px divides the side, at least twice. @throws Error (bad input) for other sizes, or
///                 levels that are not finite
FractalCode compress_fractally(const GreySquare& picture, int block_px, int domain_step_px,
                               Workers& workers);

/// Starts from grey, or any picture, and applies the code again and again.
class FractalDecoder {
 public:
  /// @param zoom the code knows no size: the picture may be decoded larger than it was
  /// @throws Error (bad input) for a zoom that is not 1 to 16, or a code that points outside
  explicit FractalDecoder(const FractalCode& code, int zoom = 1);

  /// One iteration; the largest change of a level.
  float next();

  GreySquare picture;

 private:
  FractalCode code_;
  int zoom_;
};

}  // namespace kinescope
