#include "display/vector/vector_tube.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "display/decay.h"
#include "display/layer_colours.h"
#include "display/vector/light_kernels.h"

namespace kinescope {
namespace {

/// Before an exposure's end, fast terms' light changes along a stroke: it is cut into parts so
/// short that none changes much.
constexpr Seconds kFreshest = milliseconds(2);
constexpr double kPartsAPixel = 1;
constexpr double kMostParts = 512;
/// Light that no picture shows is dropped: thus a screen becomes dark, and its tiles cost nothing.
constexpr float kUnseen = 1e-8f;

}  // namespace

VectorTube::VectorTube(const VectorMachine& machine, int width, int height)
    : dynamics_(machine), picture_(width, height) {
  const PhosphorType& type = find_phosphor(machine.phosphor);
  const auto colours = layer_colours(type);
  int planes = 0;
  for (std::size_t i = 0; i < type.layers.size(); ++i) {
    layers_.push_back(
        {type.layers[i], colours[i], type.colour || machine.penetration ? i : 0, planes});
    planes += 1 + static_cast<int>(type.layers[i].terms.size());
  }
  guns_ = type.colour || machine.penetration;
  light_ = TiledLight(width, height, planes);
  scale_ = std::min(static_cast<double>(width) / machine.width,
                    static_cast<double>(height) / machine.height);
  left_ = 0.5 * (width - scale_ * machine.width);
  bottom_ = 0.5 * (height + scale_ * machine.height);
  const double sigma = machine.spot_sigma_mm / machine.screen_mm * machine.width * scale_;
  sigma_px_ = static_cast<float>(sigma);
  const double speed = machine.speed_units_us * 1e6 * scale_;
  gain_ = speed * std::sqrt(2 * std::numbers::pi) * sigma;
}

bool VectorTube::all_unlit() const {
  for (int tile = 0; tile < light_.tiles(); ++tile) {
    if (light_.lit(tile)) return false;
  }
  return true;
}

bool VectorTube::dark() const {
  return black_ && lasting_.empty() && dynamics_.rests() && all_unlit();
}

/// Gathers the light that what is there gives in the window, and lets it decay.
void VectorTube::fade(Seconds length, Workers& workers) {
  workers.run(light_.tiles(), [&](int tile, int) {
    if (!light_.lit(tile)) return;
    bool any = false;
    for (const Layer& layer : layers_) {
      float* const sum = light_.plane(tile, layer.first_plane);
      std::fill_n(sum, kBeamTilePlane, 0.0f);
      int plane = layer.first_plane;
      for (const DecayTerm& term : layer.phosphor.terms) {
        const Decayed after = decayed(length.count(), term.tau.count());
        any |= fade_light(sum, light_.plane(tile, ++plane), static_cast<float>(after.lost),
                          static_cast<float>(after.left), kUnseen, kBeamTilePlane);
      }
    }
    light_.set_lit(tile, any);
  });
}

/// The part of a move in [begin, end), of an exposure that ends at `until`.
void VectorTube::add_stroke(const BeamMove& move, Seconds begin, Seconds end, Seconds until) {
  const double length = (move.end - move.begin).count();
  const auto place = [&](Seconds t, double from, double to) {
    return length > 0 ? std::lerp(from, to, (t - move.begin).count() / length) : to;
  };
  const auto x = [&](Seconds t) {
    return static_cast<float>(left_ + scale_ * place(t, move.x0, move.x1));
  };
  const auto y = [&](Seconds t) {
    return static_cast<float>(bottom_ - scale_ * place(t, move.y0, move.y1));
  };
  strokes_.push_back({x(begin), y(begin), x(end), y(end), sigma_px_ * move.spread});
  const double dwell = (end - begin).count(), age = (until - begin).count();
  for (const Layer& layer : layers_) {
    const double share_of_gun = guns_ ? static_cast<double>(move.colour[layer.gun]) : 1;
    const double dose = gain_ * dwell * static_cast<double>(move.intensity) * share_of_gun;
    double light = 0;
    for (const DecayTerm& term : layer.phosphor.terms) {
      light += term.share * light_of_dose(0, age, dwell, term.tau.count());
    }
    weights_.push_back(static_cast<float>(dose * light));
    for (const DecayTerm& term : layer.phosphor.terms) {
      weights_.push_back(
          static_cast<float>(dose * term.share * left_of_dose(age, dwell, term.tau.count())));
    }
  }
}

void VectorTube::add_move(const BeamMove& move, Seconds until) {
  const Seconds begin = std::max(move.begin, now_), end = std::min(move.end, until);
  if (!(move.intensity > 0) || end <= begin) return;
  double parts = 1;
  if (end > until - kFreshest) {
    const double way = scale_ * std::hypot(move.x1 - move.x0, move.y1 - move.y0);
    const double share = (end - begin) / (move.end - move.begin);
    parts = std::clamp(std::ceil(way * share * kPartsAPixel), 1.0, kMostParts);
  }
  for (double i = 0; i < parts; ++i) {
    const Seconds from = begin + (end - begin) * (i / parts);
    add_stroke(move, from, begin + (end - begin) * ((i + 1) / parts), until);
  }
}

void VectorTube::compose(Workers& workers) {
  workers.run(light_.tiles(), [&](int number, int) {
    const BeamTile tile = light_.tile(number);
    const int right = std::min(tile.x + kBeamTile, picture_.width());
    const int bottom = std::min(tile.y + kBeamTile, picture_.height());
    for (int y = tile.y; y < bottom; ++y) {
      LinearRgb* const row = picture_.row(y);
      std::fill(row + tile.x, row + right, LinearRgb{});
      for (const Layer& layer : layers_) {
        if (!light_.lit(number)) break;
        const float* light = light_.plane(number, layer.first_plane) + (y - tile.y) * kBeamTile;
        for (int x = tile.x; x < right; ++x, ++light) {
          row[x].r += *light * layer.colour[0];
          row[x].g += *light * layer.colour[1];
          row[x].b += *light * layer.colour[2];
        }
      }
    }
  });
}

bool VectorTube::carries_since(Seconds time) const {
  const auto began = [&](const BeamMove& move) { return move.begin < time; };
  return std::any_of(lasting_.begin(), lasting_.end(), began) || dynamics_.carries_since(time);
}

void VectorTube::gather_strokes(std::span<const BeamMove> moves, Seconds end) {
  dynamics_.follow(moves, end, lasting_);
  strokes_.clear();
  weights_.clear();
  for (const BeamMove& move : lasting_) add_move(move, end);
  std::erase_if(lasting_, [&](const BeamMove& move) { return move.end <= end; });
  // What has lasted for longer than this exposure is not the same in the next one.
  if (carries_since(now_)) repeated_.restart();
}

/// Everything is as it was in the last exposure.
void VectorTube::repeat(Seconds length) {
  dynamics_.repeat(length);
  for (BeamMove& move : lasting_) move.begin += length, move.end += length;
}

void VectorTube::draw_cycle(std::span<const BeamMove> moves, Seconds end, Workers& workers) {
  gather_strokes(moves, end);
  if (strokes_.empty()) return;  // what only fades is no cycle
  if (cycle_.tiles() == 0) {
    cycle_ = TiledLight(light_.width(), light_.height(), light_.planes());
  } else {
    cycle_.clear();
  }
  painter_.draw(strokes_, weights_, cycle_, workers);
  has_cycle_ = true;
}

void VectorTube::add_cycle(Workers& workers) {
  workers.run(light_.tiles(), [&](int tile, int) {
    if (!cycle_.lit(tile)) return;
    add_light(light_.plane(tile, 0), cycle_.plane(tile, 0), light_.planes() * kBeamTilePlane);
    light_.set_lit(tile, true);
  });
}

/// Until of what the slowest term held before the list was shown, a ten-millionth is left.
int VectorTube::exposures_to_balance(Seconds length) const {
  constexpr double kDecays = 16;
  double slowest = 0;
  for (const Layer& layer : layers_) {
    for (const DecayTerm& term : layer.phosphor.terms) {
      slowest = std::max(slowest, term.tau.count());
    }
  }
  const double exposures = kDecays * slowest / std::max(length.count(), 1e-9);
  return static_cast<int>(std::min(1e9, std::ceil(exposures)));
}

const Image<LinearRgb>& VectorTube::expose(std::span<const BeamMove> moves, Seconds end,
                                           Workers& workers) {
  assert(end >= now_);
  // Before a repetition counts, what the beam did earlier must have faded from its amplifiers.
  constexpr int kRepetitions = 2;
  const Seconds length = end - now_;
  const int repeats = repeated_.count(moves, now_, end);
  if (repeats < kRepetitions) has_cycle_ = false;
  if (has_cycle_) {
    repeat(length);
    changed_ = repeats < kRepetitions + exposures_to_balance(length);
  } else if (repeats >= kRepetitions) {
    draw_cycle(moves, end, workers);
    changed_ = true;
  } else {
    gather_strokes(moves, end);
    changed_ = true;
  }
  now_ = end;
  if (!changed_) return picture_;
  const bool nothing = strokes_.empty() && all_unlit();
  if (!nothing) {
    fade(length, workers);
    if (has_cycle_) {
      add_cycle(workers);
    } else {
      painter_.draw(strokes_, weights_, light_, workers);
    }
  }
  changed_ = !nothing || !black_;
  if (changed_) compose(workers);
  black_ = nothing;
  return picture_;
}

}  // namespace kinescope
