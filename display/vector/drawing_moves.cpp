#include "display/vector/drawing_moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "display/phosphor.h"

namespace kinescope {
namespace {

/// No figure at hand: a defocused line of the 4014 is plainly wider.
constexpr float kDefocus = 3;

/// Follows strokes with the beam.
class Hand {
 public:
  Hand(const VectorDrawing& drawing, const VectorMachine& machine, Seconds begin,
       std::vector<BeamMove>& moves)
      : machine_(machine),
        moves_(moves),
        time_(begin),
        one_colour_(!find_phosphor(machine.phosphor).colour),
        origin_(drawing.origin),
        scale_(std::min(static_cast<double>(machine.width) / static_cast<double>(drawing.size.x),
                        static_cast<double>(machine.height) / static_cast<double>(drawing.size.y))),
        left_(0.5 * (machine.width - scale_ * static_cast<double>(drawing.size.x))),
        bottom_(0.5 * (machine.height - scale_ * static_cast<double>(drawing.size.y))) {
    const auto named = [](const InstructionCost& cost) { return cost.name == "move"; };
    knows_move_ = std::any_of(machine.costs.begin(), machine.costs.end(), named);
    const double sigma = machine.spot_sigma_mm / machine.screen_mm * machine.width;
    point_units_ = std::sqrt(2 * std::numbers::pi) * sigma;
  }

  void take_pen(const VectorPen& pen) {
    const LinearRgba c = decode(pen.colour);
    next_.spread = pen.defocused ? kDefocus : 1.0f;
    next_.colour = {c.r, c.g, c.b};
    // Rec. 709's weights.
    current_ = one_colour_ ? 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b : 1.0f;
  }

  void draw(const VectorSegment& s, Address number) {
    const double x0 = x(s.x1), y0 = y(s.y1), x1 = x(s.x2), y1 = y(s.y2);
    next_.address = number;
    const double dark = std::hypot(x0 - x_, y0 - y_);
    if (dark > 0) go(x0, y0, dark_time(dark), 0);
    const double lit = std::max(std::hypot(x1 - x0, y1 - y0), point_units_);
    go(x1, y1, microseconds(lit / machine_.speed_units_us), s.intensity * current_);
  }

  Seconds time() const { return time_; }

 private:
  double x(float at) const { return left_ + scale_ * static_cast<double>(at - origin_.x); }
  double y(float at) const { return bottom_ + scale_ * static_cast<double>(at - origin_.y); }
  Seconds dark_time(double units) const {
    if (!knows_move_) return microseconds(units / machine_.speed_units_us);
    return Seconds(static_cast<double>(machine_.clocks("move", units)) / machine_.clock_hz);
  }
  void go(double to_x, double to_y, Seconds length, float intensity) {
    next_.x0 = x_, next_.y0 = y_, next_.x1 = to_x, next_.y1 = to_y;
    next_.begin = time_;
    next_.end = time_ = time_ + length;
    next_.intensity = intensity;
    moves_.push_back(next_);
    x_ = to_x, y_ = to_y;
  }

  const VectorMachine& machine_;
  std::vector<BeamMove>& moves_;
  Seconds time_;
  bool one_colour_, knows_move_ = false;
  glm::vec2 origin_;
  double scale_, left_, bottom_;
  double point_units_ = 0;  // a point is drawn for as long as a way of this length
  double x_ = 0, y_ = 0;
  float current_ = 1;
  BeamMove next_;
};

}  // namespace

Seconds draw_strokes_of(const VectorDrawing& strokes, const VectorMachine& machine, Seconds begin,
                        std::vector<BeamMove>& moves) {
  Hand hand(strokes, machine, begin, moves);
  for_each_run(strokes, [&](const VectorPen& pen, std::size_t first, std::size_t last) {
    hand.take_pen(pen);
    for (std::size_t i = first; i < last; ++i) {
      hand.draw(strokes.segments[i], static_cast<Address>(i));
    }
  });
  return hand.time();
}

}  // namespace kinescope
