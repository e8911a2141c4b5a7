// A film, or one picture, of a feed on a raster tube.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "demos/film.h"
#include "demos/machine.h"
#include "demos/options.h"
#include "demos/picture_feed.h"
#include "demos/raster_fit.h"
#include "demos/tube_film.h"

namespace kinescope {

/// Everything about such a film that follows from the options and the input.
struct DisplayPlan {
  std::string preset;
  TubeShot shot;
  Rate rate;        ///< of the film
  Rate refresh;     ///< of the display, whole frames
  Rate input_rate;  ///< at which the feed's pictures follow each other
  FrameRange frames;
  bool open_ended = false;  ///< the feed's end ends the film, not frames.last
  bool cut = false;         ///< frames were asked for: a window, too, ends with the last
  Fit fit = Fit::kInside;
  Seconds start{0};
  bool several() const { return open_ended || frames.count() > 1; }
};

/// The display that the options name: preset, mode, size, shutter and gain.
/// @throws Error (usage)
TubeShot plan_shot(const Options& options);
/// @throws Error (usage) on options that do not go together
DisplayPlan plan_display_film(const Options& options, const PictureFeed::Facts& facts);

/// The refresh, from the feed's beginning, from which the display is run: some before the first
/// picture, so that slow phosphors glow.
std::int64_t first_refresh(const DisplayPlan& plan, bool still);

/// Lays the feed's pictures on the raster of the plan's mode.
RasterFit fit_of(const DisplayPlan& plan, const PictureFeed::Facts& facts, Workers& workers);

/// The pictures of a feed by refresh: each is shown until the refresh in which the next is due.
class RefreshFeed {
 public:
  RefreshFeed(PictureFeed& feed, Rate input_rate, Rate refresh, RasterFit fit);
  /// Refreshes are asked for in order; some may be left out. After the feed's end its last picture
  /// stays.
  const Image<Srgb8>& at(std::int64_t refresh);
  /// Whether the feed still lasts at a time that the refresh last asked for contains.
  bool lasts_at(Seconds time);
  std::int64_t pictures() const { return read_; }

 private:
  void read_to(std::int64_t index);

  PictureFeed& feed_;
  RasterFit fit_;
  Rate input_rate_;
  std::int64_t step_, whole_;  // a refresh is step / whole pictures
  std::int64_t phase_ = 0, refresh_ = 0;
  std::int64_t due_ = 0;     // the picture that is due in refresh_
  std::int64_t read_ = 0;    // how many were read; the last one is `latest_`
  std::int64_t fitted_ = 0;  // how many were read when the one that is shown was fitted
  bool ended_ = false;
  Image<Srgb8> latest_;
  const Image<Srgb8>* shown_ = nullptr;
};

class DisplayFilm {
 public:
  DisplayFilm(const DisplayPlan& plan, PictureFeed& feed, bool want_hashes, Workers& workers);
  /// Makes the next frame and writes it, if `film` is given. @return false if there is none
  bool shoot(Film* film);
  struct FrameFigures {
    int frame = 0;
    std::uint64_t picture_hash = 0;  ///< 0 for 16 bits a channel
  };
  const std::vector<FrameFigures>& figures() const { return figures_; }
  std::int64_t pictures_read() const { return feed_.pictures(); }
  void write_times(JsonWriter& json) const;

 private:
  DisplayPlan plan_;
  bool want_hashes_;
  std::int64_t first_refresh_;
  RefreshFeed feed_;
  TubeFilm tube_;
  std::vector<FrameFigures> figures_;
  Stopwatch frame_, write_;
};

}  // namespace kinescope
