#include "display/vector/vector_tube.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "display/decay.h"
#include "display/vector/light_kernels.h"
#include "display/vector/stroke_law.h"

namespace kinescope {
namespace {

/// Before an exposure's end, fast terms' light changes along a stroke: it is cut into parts so
/// short that none changes much.
constexpr Seconds kFreshest = milliseconds(2);
constexpr double kPartsAPixel = 1;
constexpr double kMostParts = 512;
/// Spans whose pieces one worker makes at a time, and those that are drawn together: enough for
/// every tile, few enough for the caches.
constexpr std::size_t kChunkSpans = 2048, kBatchSpans = 16 * kChunkSpans;
/// Moves that are followed at a time.
constexpr std::size_t kBatchMoves = 1 << 14;
/// Light that no picture shows is dropped: thus a screen becomes dark, and its tiles cost nothing.
constexpr float kUnseen = 1e-8f;

}  // namespace

VectorTube::VectorTube(const VectorMachine& machine, int width, int height)
    : guns_(machine.penetration || find_phosphor(machine.phosphor).colour),
      dose_light_(find_phosphor(machine.phosphor), guns_),
      dynamics_(machine),
      cutter_(machine),
      light_(width, height, dose_light_.planes()),
      picture_(width, height) {
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

/// Gathers the light that what is there gives in the window, lets it decay, and adds what each
/// cycle does.
void VectorTube::fade(int tile, Seconds length) {
  const bool cycles = has_cycle_ && cycle_.lit(tile);
  if (!light_.lit(tile) && !cycles) return;
  bool any = cycles;
  const auto more = [&](int plane) { return cycles ? cycle_.plane(tile, plane) : nullptr; };
  for (const LightLayer& layer : dose_light_.layers()) {
    int plane = layer.first_plane;
    float* const sum = light_.plane(tile, plane);
    if (cycles) {
      std::copy_n(more(plane), kBeamTilePlane, sum);
    } else {
      std::fill_n(sum, kBeamTilePlane, 0.0f);
    }
    for (const DecayTerm& term : layer.phosphor.terms) {
      const Decayed after = decayed(length.count(), term.tau.count());
      float* const held = light_.plane(tile, ++plane);
      any |= fade_light(sum, held, more(plane), static_cast<float>(after.lost),
                        static_cast<float>(after.left), kUnseen, kBeamTilePlane);
    }
  }
  light_.set_lit(tile, any);
}

/// The share of each gun.
std::array<float, 3> VectorTube::guns_of(const BeamSpan& span) const {
  return guns_ ? span.colour : std::array<float, 3>{1, 1, 1};
}

double VectorTube::dose_of(double seconds, float current) const {
  return gain_ * seconds * static_cast<double>(current);
}

/// Of a stroke that ends shortly before the exposure does, in parts.
void VectorTube::add_even(const BeamSpan& span, const BeamPiece& piece, Seconds until,
                          BeamMarks& marks) const {
  const auto place = [&](double t, double from, double to) { return from + t * (to - from); };
  const auto x = [&](double t) {
    return static_cast<float>(left_ + scale_ * place(t, piece.x[0], piece.x[1]));
  };
  const auto y = [&](double t) {
    return static_cast<float>(bottom_ - scale_ * place(t, piece.y[0], piece.y[1]));
  };
  const double length = piece.to - piece.from;
  double parts = 1;
  if (span.at + Seconds(piece.to) > until - kFreshest) {
    const double way = scale_ * std::hypot(piece.x[1] - piece.x[0], piece.y[1] - piece.y[0]);
    parts = std::clamp(std::ceil(way * kPartsAPixel), 1.0, kMostParts);
  }
  const double dose = dose_of(length / parts, piece.current);
  for (double i = 0; i < parts; ++i) {
    const double from = i / parts, to = (i + 1) / parts;
    marks.strokes.push_back({x(from), y(from), x(to), y(to), sigma_px_ * piece.spread[0]});
    const Seconds begin = span.at + Seconds(piece.from + length * from);
    const Seconds end = span.at + Seconds(piece.from + length * to);
    dose_light_.add_weights(dose, guns_of(span), begin, end, until, marks.stroke_weights);
  }
}

/// One by one shortly before the exposure ends.
void VectorTube::add_spots(const BeamSpan& span, const BeamPiece& piece, Seconds until,
                           BeamMarks& marks) const {
  const double length = piece.to - piece.from, dose = dose_of(length, piece.current);
  const bool fresh = span.at + Seconds(piece.to) > until - kFreshest;
  const auto& rule = stroke_law::kQuadratures[static_cast<std::size_t>(piece.spots - 1)];
  BeamSpots spots;
  double from = piece.from;
  for (std::size_t i = 0; i < static_cast<std::size_t>(piece.spots); ++i) {
    const auto at = static_cast<std::size_t>(spots.count++);
    spots.x[at] = static_cast<float>(left_ + scale_ * piece.x[i]);
    spots.y[at] = static_cast<float>(bottom_ - scale_ * piece.y[i]);
    spots.sigma[at] = sigma_px_ * piece.spread[i];
    spots.share[at] = fresh ? 1 : piece.share[i];
    if (!fresh) continue;
    marks.spots.push_back(spots);
    const double to = from + length * static_cast<double>(rule.weight[i]);
    dose_light_.add_weights(dose * static_cast<double>(piece.share[i]), guns_of(span),
                            span.at + Seconds(from), span.at + Seconds(std::min(to, piece.to)),
                            until, marks.spot_weights);
    spots.count = 0, from = to;
  }
  if (fresh) return;
  marks.spots.push_back(spots);
  dose_light_.add_weights(dose, guns_of(span), span.at + Seconds(piece.from),
                          span.at + Seconds(piece.to), until, marks.spot_weights);
}

/// What a span leaves between the last exposure's end and this one's.
void VectorTube::add_marks(const BeamSpan& span, Seconds until, std::vector<BeamPiece>& pieces,
                           BeamMarks& marks) const {
  pieces.clear();
  const double from = std::max(span.from, (now_ - span.at).count());
  const double to = std::min(span.to, (until - span.at).count());
  if (from < to) cutter_.cut(span, from, to, pieces);
  for (const BeamPiece& piece : pieces) {
    if (piece.spots == 0) {
      add_even(span, piece, until, marks);
    } else {
      add_spots(span, piece, until, marks);
    }
  }
}

void VectorTube::compose(int number) {
  const BeamTile tile = light_.tile(number);
  const int right = std::min(tile.x + kBeamTile, picture_.width());
  const int bottom = std::min(tile.y + kBeamTile, picture_.height());
  for (int y = tile.y; y < bottom; ++y) {
    LinearRgb* const row = picture_.row(y);
    std::fill(row + tile.x, row + right, LinearRgb{});
    for (const LightLayer& layer : dose_light_.layers()) {
      if (!light_.lit(number)) break;
      const float* light = light_.plane(number, layer.first_plane) + (y - tile.y) * kBeamTile;
      for (int x = tile.x; x < right; ++x, ++light) {
        row[x].r += *light * layer.colour[0];
        row[x].g += *light * layer.colour[1];
        row[x].b += *light * layer.colour[2];
      }
    }
  }
}

bool VectorTube::carries_since(Seconds time) const {
  const auto began = [&](const BeamSpan& span) { return span.begin() < time; };
  return std::any_of(lasting_.begin(), lasting_.end(), began) || dynamics_.carries_since(time);
}

/// Draws what was followed. Chunks are cut and sorted apart from each other, and drawn tile by tile
/// in their order. @return whether there was anything
bool VectorTube::draw_spans(Seconds until, TiledLight& light, Workers& workers) {
  const std::size_t chunks = (spans_.size() + kChunkSpans - 1) / kChunkSpans;
  if (chunks == 0) return false;
  if (marks_.size() < chunks) marks_.resize(chunks);
  workers.run(static_cast<int>(chunks), [&](int number, int) {
    const std::size_t first = static_cast<std::size_t>(number) * kChunkSpans;
    const std::size_t last = std::min(first + kChunkSpans, spans_.size());
    BeamMarks& marks = marks_[static_cast<std::size_t>(number)];
    marks.clear();
    std::vector<BeamPiece> pieces;
    for (std::size_t i = first; i < last; ++i) add_marks(spans_[i], until, pieces, marks);
  });
  painter_.draw(std::span(marks_).first(chunks), light, workers);
  for (const BeamSpan& span : spans_) {
    if (span.end() > until) lasting_.push_back(span);
  }
  spans_.clear();
  return true;
}

/// @return whether anything was drawn
bool VectorTube::draw_moves(std::span<const BeamMove> moves, Seconds end, TiledLight& light,
                            Workers& workers) {
  spans_.swap(lasting_);
  lasting_.clear();
  bool drawn = false;
  do {
    const auto some = moves.first(std::min(kBatchMoves, moves.size()));
    moves = moves.subspan(some.size());
    dynamics_.follow(some, moves.empty() ? end : std::min(end, moves.front().begin), spans_);
    if (moves.empty() || spans_.size() >= kBatchSpans) drawn |= draw_spans(end, light, workers);
  } while (!moves.empty());
  // What has lasted for longer than this exposure is not the same in the next one.
  if (carries_since(now_)) repeated_.restart();
  return drawn;
}

/// Everything is as it was in the last exposure.
void VectorTube::repeat(Seconds length) {
  dynamics_.repeat(length);
  for (BeamSpan& span : lasting_) span.at += length;
}

void VectorTube::draw_cycle(std::span<const BeamMove> moves, Seconds end, Workers& workers) {
  if (cycle_.tiles() == 0) {
    cycle_ = TiledLight(light_.width(), light_.height(), light_.planes());
  } else {
    cycle_.clear();
  }
  has_cycle_ = draw_moves(moves, end, cycle_, workers);  // what only fades is no cycle
}

/// Until of what the slowest term held before the list was shown, a ten-millionth is left.
int VectorTube::exposures_to_balance(Seconds length) const {
  constexpr double kDecays = 16;
  const double exposures = kDecays * dose_light_.slowest() / std::max(length, Seconds(1e-9));
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
  changed_ = true;
  if (has_cycle_) {
    repeat(length);
    changed_ = repeats < kRepetitions + exposures_to_balance(length);
  }
  if (!changed_) {
    now_ = end;
    return picture_;
  }
  const bool idle = moves.empty() && lasting_.empty() && dynamics_.rests();
  const bool was_unlit = all_unlit();
  const bool draws_cycle = !has_cycle_ && !idle && repeats >= kRepetitions;
  if (draws_cycle) draw_cycle(moves, end, workers);
  const bool drawn_anew = !has_cycle_ && !draws_cycle;
  bool nothing = !has_cycle_ && was_unlit;
  if (drawn_anew) {
    workers.run(light_.tiles(), [&](int tile, int) { fade(tile, length); });
    nothing = !draw_moves(moves, end, light_, workers) && was_unlit;
  }
  now_ = end;
  changed_ = !nothing || !black_;
  black_ = nothing;
  if (!changed_) return picture_;
  // A tile's planes stay in the cache for all that is done with them.
  workers.run(light_.tiles(), [&](int tile, int) {
    if (!drawn_anew) fade(tile, length);
    compose(tile);
  });
  return picture_;
}

}  // namespace kinescope
