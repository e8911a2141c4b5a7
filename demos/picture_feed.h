// What a display is given: one picture, a numbered sequence, a video or a test pattern.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "demos/options.h"
#include "demos/picture.h"
#include "demos/tube_camera.h"
#include "raster/image/video.h"

namespace kinescope {

/// Pictures in order, all of one size.
class PictureFeed {
 public:
  struct Facts {
    Size size;
    std::optional<Rate> rate;            ///< of the pictures; none: the input does not say
    std::optional<double> pixel_aspect;  ///< a pixel's width over its height; none: not said
    FieldOrder fields = FieldOrder::kProgressive;
    TubeSignal signal = TubeSignal::kPicture;
    bool still = false;  ///< one picture, which stays
  };
  virtual ~PictureFeed() = default;
  const Facts& facts() const { return facts_; }
  /// @return false if there are no more. @throws Error (bad input)
  virtual bool next(Image<Srgb8>& picture) = 0;
  /// From any thread: whoever waits in next() for what has not come yet waits no longer.
  virtual void interrupt() {}

 protected:
  Facts facts_;
};

/// Opens what the request names; a test pattern is made of the given size.
/// @param workers must outlive the feed
/// @throws Error (bad input, or usage)
std::unique_ptr<PictureFeed> open_feed(const DisplayRequest& request, Size pattern_size,
                                       Workers& workers);

}  // namespace kinescope
