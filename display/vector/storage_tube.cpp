#include "display/vector/storage_tube.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "display/decay.h"
#include "display/layer_colours.h"
#include "display/vector/drawing_moves.h"
#include "display/vector/input/beam_strokes.h"

namespace kinescope {
namespace {

enum Plane { kCharge, kStored, kGathered, kPlanes };

/// What a beam has written in a piece of this is stored at its end, whatever the exposures.
constexpr Seconds kStoreStep{1.0 / 240};
constexpr double kUnitLight = 60;  // a second
/// A spot is stored at least so wide, pixels: what a pixel can show without steps.
constexpr double kLeastSigmaPx = 0.6;
/// Steps of brightness in which the contrast fades: half of a picture's 8-bit code.
constexpr double kFadeStep = 1.0 / 256;

VectorMachine writing_beam(const StorageTubeType& type) {
  const double units_mm = type.width / type.screen_mm;
  VectorMachine machine;
  machine.name = type.name;
  machine.width = type.width, machine.height = type.height;
  machine.screen_mm = type.screen_mm;
  machine.spot_sigma_mm = type.sigma_mm;
  machine.speed_units_us = type.speed_mm_ms * 1e-3 * units_mm;
  machine.phosphor = type.phosphor;
  machine.costs = {{"move", type.settle_us, type.settle_us_mm / units_mm}};
  return machine;
}

/// How much of a cell is stored that got a dose, that in a line's middle being 1: a soft threshold.
float stored_share(float charge, float threshold) {
  const auto fourth_power = [](float v) { return v * v * v * v; };
  const float t = fourth_power(threshold), q = fourth_power(charge);
  return q * (1 + t) / (q + t);
}

Seconds step_after(Seconds t) { return std::ceil(t / kStoreStep) * kStoreStep; }

}  // namespace

StorageTube::StorageTube(const StorageTubeType& type, int width, int height)
    : type_(type),
      machine_(writing_beam(type)),
      beam_(machine_, width, height),
      colour_(layer_colours(find_phosphor(type.phosphor))[0]),
      scale_(std::min(static_cast<double>(width) / type.width,
                      static_cast<double>(height) / type.height)),
      left_(0.5 * (width - scale_ * type.width)),
      bottom_(0.5 * (height + scale_ * type.height)),
      dose_(width, height, 1),
      target_(width, height, kPlanes),
      times_(static_cast<std::size_t>(target_.tiles())),
      erasure_(-type.erase),
      picture_(width, height) {}

void StorageTube::draw(const VectorDrawing& drawing) {
  const auto erased_at = [&](std::size_t segments, std::size_t texts) {
    return std::any_of(drawing.events.begin(), drawing.events.end(), [&](const DrawingEvent& e) {
      return e.kind == DrawingEvent::Kind::kErase && e.segments == segments && e.texts == texts;
    });
  };
  const bool empty = drawing.segments.empty() && drawing.texts.empty();
  if (erased_at(0, 0)) erase();
  bool first = true;
  for (const VectorDrawing& page : pages(drawing)) {
    if (!first) erase();
    first = false;
    write(beam_strokes(page));
  }
  if (!empty && erased_at(drawing.segments.size(), drawing.texts.size())) erase();
}

void StorageTube::write(const VectorDrawing& strokes) {
  Job job;
  job.begin = busy_until();
  moves_.clear();
  free_ = job.end = draw_strokes_of(strokes, machine_, job.begin, moves_);
  job.strokes.reserve(moves_.size());
  for (const BeamMove& move : moves_) job.strokes.push_back({move, move.intensity > 0});
  for_each_run(strokes, [&](const VectorPen& pen, std::size_t first, std::size_t last) {
    if (!pen.write_through) return;
    for (Stroke& stroke : job.strokes) {
      if (stroke.move.address < first || stroke.move.address >= last) continue;
      stroke.stored = false;
      stroke.move.intensity *= static_cast<float>(type_.write_through);
    }
  });
  jobs_.push_back(std::move(job));
}

void StorageTube::erase() {
  Job job;
  job.erases = true;
  job.begin = busy_until();
  free_ = job.end = job.begin + type_.erase;
  jobs_.push_back(std::move(job));
}

/// The light of a wholly stored spot.
double StorageTube::flood_light(Seconds begin, Seconds end) const {
  const Seconds ready = erasure_ + type_.erase;
  begin = std::max(begin, ready);
  if (end <= begin) return 0;
  const double tau = type_.half_contrast.count() / std::numbers::ln2;
  return kUnitLight * tau * decayed((begin - ready).count(), tau).left *
         one_minus_exp((end - begin).count() / tau);
}

/// The light of a spot where nothing is stored: a flash, darkness from which the background
/// returns evenly, and the background.
double StorageTube::background_light(Seconds begin, Seconds end) const {
  const Seconds dark = erasure_ + type_.erase_flash, ready = erasure_ + type_.erase;
  const auto within = [&](Seconds from, Seconds to) {
    return std::max(0.0, (std::min(end, to) - std::max(begin, from)).count());
  };
  double light = within(erasure_, dark);
  const Seconds from = std::max(begin, dark), to = std::min(end, ready);
  if (to > from) {
    const double middle = (0.5 * (from + to) - dark) / (ready - dark);
    light += type_.background * middle * (to - from).count();
  }
  const double steady = within(Seconds(-1e9), erasure_) + within(ready, end);
  return kUnitLight * (light + type_.background * steady);
}

/// Brings the light that a tile has given in this exposure up to a time.
void StorageTube::gather(int tile, Seconds time) {
  TileTime& state = times_[static_cast<std::size_t>(tile)];
  float* const gathered = target_.plane(tile, kGathered);
  const float* const stored = target_.plane(tile, kStored);
  if (!state.gathers) {
    std::fill_n(gathered, kBeamTilePlane, 0.0f);
    state = {true, begin_};
  }
  const auto light = static_cast<float>(flood_light(state.until, time));
  for (int i = 0; i < kBeamTilePlane; ++i) gathered[i] += light * stored[i];
  state.until = time;
}

void StorageTube::start_erasure(Seconds begin) {
  for (int tile = 0; tile < target_.tiles(); ++tile) {
    if (!target_.lit(tile)) continue;
    gather(tile, begin);
    std::fill_n(target_.plane(tile, kCharge), kBeamTilePlane, 0.0f);
    std::fill_n(target_.plane(tile, kStored), kBeamTilePlane, 0.0f);
    target_.set_lit(tile, false);
  }
  gathered_background_ += background_light(background_until_, begin);
  background_until_ = begin;
  erasure_ = begin;
}

void StorageTube::add_dose(const BeamMove& move) {
  const auto x = [&](double at) { return static_cast<float>(left_ + scale_ * at); };
  const auto y = [&](double at) { return static_cast<float>(bottom_ - scale_ * at); };
  const double physical = type_.sigma_mm / type_.screen_mm * type_.width * scale_;
  const double spread = static_cast<double>(move.spread);
  const double sigma = std::max(kLeastSigmaPx, physical * spread);
  const double across = std::sqrt(2 * std::numbers::pi) * sigma;
  const double length = scale_ * std::hypot(move.x1 - move.x0, move.y1 - move.y0);
  strokes_.push_back({x(move.x0), y(move.y0), x(move.x1), y(move.y1), static_cast<float>(sigma)});
  weights_.push_back(static_cast<float>(static_cast<double>(move.intensity) / spread * across *
                                        std::max(length, across)));
}

/// Stores what a job's beam has drawn up to a time.
void StorageTube::store(Job& job, Seconds time, Workers& workers) {
  strokes_.clear();
  weights_.clear();
  for (; job.next < job.strokes.size() && job.strokes[job.next].move.end <= time; ++job.next) {
    if (job.strokes[job.next].stored) add_dose(job.strokes[job.next].move);
  }
  if (strokes_.empty()) return;
  painter_.draw(strokes_, weights_, dose_, workers);
  const auto threshold = static_cast<float>(type_.threshold);
  workers.run(dose_.tiles(), [&](int tile, int) {
    if (!dose_.lit(tile)) return;
    gather(tile, time);
    float* const dose = dose_.plane(tile, 0);
    float* const charge = target_.plane(tile, kCharge);
    float* const stored = target_.plane(tile, kStored);
    for (int i = 0; i < kBeamTilePlane; ++i) {
      charge[i] += dose[i];
      dose[i] = 0;
      stored[i] = stored_share(charge[i], threshold);
    }
    dose_.set_lit(tile, false);
    target_.set_lit(tile, true);
  });
}

/// Carries out what is asked for before `end`.
void StorageTube::run_target(Seconds end, Workers& workers) {
  while (!jobs_.empty()) {
    Job& job = jobs_.front();
    if (job.begin >= end) return;
    moves_on_ = true;
    if (job.erases) {
      start_erasure(job.begin);
    } else if (job.next < job.strokes.size()) {
      const Seconds at = std::min(job.end, step_after(job.strokes[job.next].move.end));
      if (at >= end) return;
      store(job, at, workers);
      continue;
    }
    jobs_.pop_front();
  }
}

void StorageTube::pass_beam(Seconds end, Workers& workers) {
  moves_.clear();
  for (Job& job : jobs_) {
    for (; job.passed < job.strokes.size(); ++job.passed) {
      const BeamMove& move = job.strokes[job.passed].move;
      if (move.begin >= end) break;
      moves_.push_back(move);
    }
  }
  if (!moves_.empty() || !beam_.dark()) moves_on_ = true;
  beam_light_ = &beam_.expose(moves_, end, workers);
}

void StorageTube::compose_tile(int tile, float flood, float background) {
  const auto contrast = static_cast<float>(1 - type_.background);
  const auto flash = static_cast<float>(type_.flash);
  TileTime& state = times_[static_cast<std::size_t>(tile)];
  if (state.gathers) {
    gather(tile, now_);
    flood = 1;
  }
  const float* const light = target_.plane(tile, state.gathers ? kGathered : kStored);
  state.gathers = false;
  const BeamTile at = target_.tile(tile);
  const int right = std::min(at.x + kBeamTile, picture_.width());
  const int bottom = std::min(at.y + kBeamTile, picture_.height());
  for (int y = at.y; y < bottom; ++y) {
    const bool on_screen = y >= std::floor(bottom_ - scale_ * type_.height) && y < bottom_;
    const float* from = light + (y - at.y) * kBeamTile - at.x;
    const LinearRgb* const beam = beam_light_->row(y);
    LinearRgb* const row = picture_.row(y);
    for (int x = at.x; x < right; ++x) {
      const bool within = on_screen && x >= std::floor(left_) && x < picture_.width() - left_;
      const float v = contrast * flood * from[x] + (within ? background : 0.0f);
      row[x] = {v * colour_[0] + flash * beam[x].r, v * colour_[1] + flash * beam[x].g,
                v * colour_[2] + flash * beam[x].b};
    }
  }
}

void StorageTube::compose(Workers& workers) {
  const auto flood = static_cast<float>(shown_flood_);
  const auto background = static_cast<float>(shown_background_);
  workers.run(target_.tiles(), [&](int tile, int) { compose_tile(tile, flood, background); });
}

const Image<LinearRgb>& StorageTube::expose(Seconds end, Workers& workers) {
  assert(end >= now_);
  const bool moved_on = moves_on_;
  begin_ = background_until_ = now_;
  moves_on_ = erasing();
  gathered_background_ = 0;
  pass_beam(end, workers);
  run_target(end, workers);
  now_ = end;
  const double flood = flood_light(begin_, end);
  const double background = gathered_background_ + background_light(background_until_, end);
  const auto differs = [](double a, double b) { return std::abs(a - b) > kFadeStep * b; };
  changed_ = moved_on || moves_on_ || differs(flood, shown_flood_) ||
             differs(background, shown_background_);
  still_ = !moves_on_ && jobs_.empty();
  if (!changed_) return picture_;
  shown_flood_ = flood, shown_background_ = background;
  compose(workers);
  return picture_;
}

Image<Srgb8> StorageTube::hard_copy() const {
  Image<Srgb8> copy(picture_.width(), picture_.height());
  for (int y = 0; y < copy.height(); ++y) {
    for (int x = 0; x < copy.width(); ++x) {
      const float paper = 1 - target_.at(kStored, x, y);
      copy.at(x, y) = encode_srgb8(LinearRgb{paper, paper, paper});
    }
  }
  return copy;
}

}  // namespace kinescope
