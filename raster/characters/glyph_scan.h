// An outline character in four steps: scaled to the pixels' grid, fitted to it, filled where
// pixels' centres are inside, and mended where a thin part fell between centres. Source: Apple,
// "The TrueType Font File Format", 1990, the scan converter's rules 1 to 3.
#pragma once

#include <cstdint>

#include "raster/image/image.h"
#include "raster/path/path.h"

namespace kinescope {

/// Why a pixel is on.
enum class GlyphPixel : std::uint8_t {
  kOff,
  kInside,         ///< its centre is
  kDropoutRow,     ///< the outline passes between it and its neighbour at the side
  kDropoutColumn,  ///< or above
};

/// One step at a time. Rows from the top; windings count.
class GlyphScan {
 public:
  enum class Step { kNone, kScale, kFit, kFill, kDropout };

  /// @param place to pixels, y downwards; the outline is cut to width x height pixels
  /// @throws Error (bad input) if the outline reaches beyond what ScanlineFill takes
  GlyphScan(const Path& outline, const PixelsFromPath& place, int width, int height);

  /// Does one more step; false when all four are done.
  bool next();
  Step step() const { return step_; }            ///< the last that was done
  const Path& outline() const { return path_; }  ///< pixels, after the first step
  const Image<GlyphPixel>& pixels() const { return pixels_; }

  /// For characters that are fitted already: the next step is to fill.
  void skip_fitting();

 private:
  void scale();
  void fit();
  void fill();
  void mend(bool columns);
  template <typename Sink>
  void stretches(bool columns, Sink&& sink) const;

  Path path_;
  PixelsFromPath place_;
  Image<GlyphPixel> pixels_;
  Step step_ = Step::kNone;
};

}  // namespace kinescope
