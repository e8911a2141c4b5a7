#include "demos/display_film.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "demos/chosen_tube.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

// Refreshes of a video that pass unseen before the first picture, so that slow phosphors glow.
constexpr std::int64_t kLeadIn = 60;
constexpr int kLeastLines = 960;  // of a picture whose size nobody named

/// A whole number of output lines a scan line, at least two.
Size usual_size(int lines, double aspect) {
  const int height = lines * std::max(2, (kLeastLines + lines - 1) / lines);
  return {static_cast<int>(std::lround(height * aspect)), height};
}

Size raster_of(const VideoMode& mode) { return {mode.horizontal.active, mode.vertical.active}; }

void check_fields(const VideoMode& mode, const PictureFeed::Facts& facts) {
  if (facts.fields == FieldOrder::kProgressive) return;
  if (mode.interlaced && mode.vertical.active == facts.size.height) return;
  const std::string lines = std::to_string(facts.size.height);
  throw Error(ErrorKind::kUsage,
              "the video is interlaced with " + lines +
                  " lines: show it in an interlaced mode of as many, such as ntsc (480) or pal "
                  "(576), or make it progressive with ffmpeg -vf bwdif",
              "--mode");
}

}  // namespace

std::int64_t first_refresh(const DisplayPlan& plan, bool still) {
  const double begin_s = plan.start.count() + plan.frames.first * plan.rate.period().count();
  const auto refresh = static_cast<std::int64_t>(begin_s * plan.refresh.hertz() + 1e-6);
  return still ? refresh : std::max<std::int64_t>(0, refresh - kLeadIn);
}

RasterFit fit_of(const DisplayPlan& plan, const PictureFeed::Facts& facts, Workers& workers) {
  const double pixels = static_cast<double>(facts.size.width) / facts.size.height;
  return {facts.size,
          pixels * facts.pixel_aspect.value_or(1),
          raster_of(plan.shot.tube.mode),
          plan.shot.aspect,
          plan.fit,
          facts.fields,
          workers};
}

TubeShot plan_shot(const Options& options) {
  const DisplayRequest& request = options.display;
  const PictureOptions& picture = options.picture;
  TubeShot shot;
  shot.tube = chosen_tube(picture).settings;
  if (request.mode) shot.tube.mode = parse_mode(*request.mode);
  shot.aspect = request.aspect.value_or(shot.tube.glass.aspect);
  shot.size = picture.size.value_or(usual_size(shot.tube.mode.vertical.active, shot.aspect));
  shot.shutter = picture.shutter.value_or(shot.tube.mode.frame_period());
  shot.gain = request.gain;
  shot.deep = picture.depth_bits == 16;
  return shot;
}

DisplayPlan plan_display_film(const Options& options, const PictureFeed::Facts& facts) {
  const DisplayRequest& request = options.display;
  const PictureOptions& picture = options.picture;
  DisplayPlan plan;
  plan.preset = chosen_tube(picture).name;
  plan.fit = request.fit;
  plan.shot = plan_shot(options);
  plan.shot.signal = facts.signal;
  if (request.gun_drive) {
    plan.shot.signal = *request.gun_drive ? TubeSignal::kGunDrive : TubeSignal::kPicture;
  }
  check_fields(plan.shot.tube.mode, facts);
  plan.refresh = plan.shot.tube.mode.frame_rate();
  plan.rate = picture.fps.value_or(plan.refresh);
  plan.shot.every = plan.rate.period();
  plan.input_rate = request.input_rate.value_or(facts.rate.value_or(plan.refresh));
  plan.open_ended = !picture.frames && !facts.still;
  plan.cut = picture.frames.has_value();
  plan.frames = picture.frames.value_or(FrameRange{});
  plan.start = request.start;
  if (plan.several()) check_shutter(plan.shot.shutter, plan.rate, picture.shutter.has_value());
  return plan;
}

RefreshFeed::RefreshFeed(PictureFeed& feed, Rate input_rate, Rate refresh, RasterFit fit)
    : feed_(feed), fit_(std::move(fit)), input_rate_(input_rate) {
  const Rate ratio =
      Rate{input_rate.numerator * refresh.denominator, input_rate.denominator * refresh.numerator}
          .reduced();
  step_ = ratio.numerator;
  whole_ = ratio.denominator;
}

void RefreshFeed::read_to(std::int64_t index) {
  while (!ended_ && read_ <= index) {
    ended_ = !feed_.next(latest_);
    if (!ended_) ++read_;
  }
}

const Image<Srgb8>& RefreshFeed::at(std::int64_t refresh) {
  for (; refresh_ < refresh; ++refresh_) {
    for (phase_ += step_; phase_ >= whole_; phase_ -= whole_) ++due_;
  }
  read_to(due_);
  const bool is_due = read_ <= due_ + 1;  // else it was read ahead
  if (is_due && fitted_ != read_) {
    shown_ = &fit_(latest_);
    fitted_ = read_;
  }
  return *shown_;
}

bool RefreshFeed::lasts_at(Seconds time) {
  if (feed_.facts().still) return true;
  const auto index = static_cast<std::int64_t>(time.count() * input_rate_.hertz() + 1e-7);
  read_to(index);
  return read_ > index;
}

DisplayFilm::DisplayFilm(const DisplayPlan& plan, PictureFeed& feed, bool want_hashes,
                         Workers& workers)
    : plan_(plan),
      want_hashes_(want_hashes),
      first_refresh_(first_refresh(plan, feed.facts().still)),
      feed_(feed, plan.input_rate, plan.refresh, fit_of(plan, feed.facts(), workers)),
      tube_(
          plan.shot,
          [this](std::int64_t refresh) -> const Image<Srgb8>& {
            return feed_.at(first_refresh_ + refresh);
          },
          workers) {}

bool DisplayFilm::shoot(Film* film) {
  const int frame = plan_.frames.first + static_cast<int>(figures_.size());
  if (!plan_.open_ended && frame > plan_.frames.last) return false;
  const Seconds time = plan_.start + Seconds(frame * plan_.rate.period().count());
  const Seconds begin = time - Seconds(static_cast<double>(first_refresh_) / plan_.refresh.hertz());
  frame_.start();
  tube_.pass_to(begin);
  if (!feed_.lasts_at(time)) return false;
  const FilmPicture picture = tube_.shoot(begin);
  frame_.stop();
  FrameFigures figures{frame, 0};
  const auto* shallow = std::get_if<Image<Srgb8>>(&picture);
  if (want_hashes_ && shallow) figures.picture_hash = hash_picture(*shallow);
  figures_.push_back(figures);
  if (!film) return true;
  write_.start();
  film->write(picture, frame);
  write_.stop();
  return true;
}

void DisplayFilm::write_times(JsonWriter& json) const {
  json.key("frame_ms");
  frame_.write(json);
  json.key("write_ms");
  write_.write(json);
}

}  // namespace kinescope
