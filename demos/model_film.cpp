#include "demos/model_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "demos/chosen_tube.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr double kTurnSeconds = 6;  // of a film without --turntable

[[noreturn]] void refuse(const std::string& option, const std::string& what) {
  throw Error(ErrorKind::kUsage, what, option);
}

void plan_display(ModelFilmPlan& plan, const PictureOptions& picture) {
  plan.bare = picture.display == "none";
  plan.tube = chosen_tube(picture).settings;
  if (plan.bare) {
    plan.size = plan.drawn = picture.size.value_or(Size{1280, 960});
    plan.rate = picture.fps.value_or(Rate{60, 1});
    if (picture.shutter)
      refuse("--shutter", "needs a display; --display none has no light to gather");
    return;
  }
  const VideoMode& mode = plan.tube.mode;
  plan.drawn = {mode.horizontal.active, mode.vertical.active};
  plan.size = picture.size.value_or(Size{2 * plan.drawn.width, 2 * plan.drawn.height});
  plan.rate = picture.fps.value_or(mode.frame_rate());
  plan.shutter = picture.shutter.value_or(mode.frame_period());
}

void plan_frames(ModelFilmPlan& plan, const Options& options) {
  const bool turntable = options.render.turntable;
  const int turn_frames = static_cast<int>(std::ceil(kTurnSeconds * plan.rate.hertz()));
  plan.frames = options.picture.frames.value_or(FrameRange{0, turntable ? turn_frames - 1 : 0});
  const double turn_s =
      turntable ? (plan.frames.last + 1) * plan.rate.period().count() : kTurnSeconds;
  plan.turn_rad_per_s = 2 * std::numbers::pi / turn_s;
  if (plan.several()) check_shutter(plan.shutter, plan.rate, options.picture.shutter.has_value());
}

}  // namespace

ModelFilmPlan plan_model_film(const Options& options) {
  ModelFilmPlan plan;
  plan_display(plan, options.picture);
  plan_frames(plan, options);
  return plan;
}

void check_memory(const ModelFilmPlan& plan, const Options& options) {
  const bool deep = options.picture.depth_bits == 16;
  const std::size_t encoded = deep ? sizeof(Srgb16) : sizeof(Srgb8);
  // The render target; a bare picture of 16 bits is encoded from linear light.
  const std::size_t drawn = deep && plan.bare ? sizeof(LinearRgba) + encoded : sizeof(Srgb8);
  const double tube = plan.bare ? 0 : tube_bytes_a_pixel(encoded);
  check_memory(plan.size, static_cast<double>(drawn) * plan.drawn.width * plan.drawn.height +
                              tube * plan.size.width * plan.size.height);
}

ModelFilm::ModelFilm(ModelView& view, const ModelFilmPlan& plan, const Options& options,
                     Workers& workers)
    : view_(view),
      plan_(plan),
      deep_(options.picture.depth_bits == 16),
      want_hashes_(options.common.json),
      workers_(workers),
      target_(plan.drawn.width, plan.drawn.height, options.render.samples,
              deep_ && plan.bare ? ColourFormat::kLinearFloat : ColourFormat::kSrgb8) {}

void ModelFilm::draw(double turn_rad) {
  draw_.start();
  last_stats_ = view_.draw(turn_rad, target_, want_hashes_);
  draw_.stop();
  if (!want_hashes_) return;
  std::visit(
      [&](const auto& picture) {
        const auto bytes = std::as_bytes(picture.pixels());
        last_colour_hash_ =
            hash_bytes({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                       static_cast<std::uint64_t>(picture.width()));
      },
      target_.colour);
}

template <typename Pixel>
void ModelFilm::finish(Film* film, int frame, const Image<Pixel>& picture) {
  frame_.stop();
  FrameFigures figures{frame, last_stats_, last_colour_hash_, 0};
  if constexpr (std::is_same_v<Pixel, Srgb8>) {
    if (want_hashes_) figures.picture_hash = hash_picture(picture);
  }
  figures_.push_back(figures);
  if (!film) return;
  write_.start();
  film->write(picture, frame);
  write_.stop();
}

void ModelFilm::shoot(Film* film) {
  const int frame = plan_.frames.first + static_cast<int>(figures_.size());
  frame_.start();
  plan_.bare ? shoot_bare(film, frame) : shoot_tube(film, frame);
}

void ModelFilm::shoot_bare(Film* film, int frame) {
  draw(plan_.turn_rad_per_s * frame * plan_.rate.period().count());
  if (!deep_) return finish(film, frame, target_.srgb8());
  const auto picture = encode_picture16(std::get<Image<LinearRgba>>(target_.colour), workers_);
  finish(film, frame, picture);
}

void ModelFilm::shoot_tube(Film* film, int frame) {
  const double first_s = plan_.frames.first * plan_.rate.period().count();
  const double refresh_s = plan_.tube.mode.frame_period().count();
  if (!tube_film_) {
    const auto source = [this, first_s, refresh_s](std::int64_t refresh) -> const Image<Srgb8>& {
      draw(plan_.turn_rad_per_s * (first_s + refresh_s * static_cast<double>(refresh)));
      return target_.srgb8();
    };
    TubeShot shot;
    shot.tube = plan_.tube;
    shot.size = plan_.size;
    shot.aspect = static_cast<double>(plan_.drawn.width) / plan_.drawn.height;
    shot.shutter = plan_.shutter;
    shot.every = plan_.rate.period();
    shot.deep = deep_;
    tube_film_ = std::make_unique<TubeFilm>(shot, source, workers_);
  }
  const Seconds begin(frame * plan_.rate.period().count() - first_s);
  std::visit([&](const auto& picture) { finish(film, frame, picture); }, tube_film_->shoot(begin));
}

void ModelFilm::write_times(JsonWriter& json) const {
  json.key("frame_ms");
  frame_.write(json);
  json.key("stages_ms").begin_object();
  json.member("draw", draw_.median_ms());
  json.member("display", std::max(0.0, frame_.median_ms() - draw_.median_ms()));
  json.member("write", write_.median_ms()).end_object();
}

}  // namespace kinescope
