// A turtle that walks an L-system's string.
// Source: Prusinkiewicz and Lindenmayer, "The Algorithmic Beauty of Plants", 1990, ch. 1.3.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

#include "engine/fractals/l_system.h"
#include "engine/transform/exact_angle.h"

namespace kinescope {

/// F and G draw a step, f moves one, + turns left, - right, | round; [ keeps the turtle's state and
/// ] returns to it. Other symbols mean nothing. A ] without [ is passed over.
class Turtle {
 public:
  struct State {
    glm::dvec2 position{0.0};
    double heading_deg = 0.0;
  };

  Turtle(std::string_view string, double step, double angle_deg, double start_deg = 0.0)
      : string_(string), step_(step), angle_deg_(angle_deg) {
    state.heading_deg = start_deg;
  }

  /// Obeys one symbol; false at the end. If it drew, sink(from, to).
  template <typename Sink>
  bool next(Sink&& sink) {
    if (at == string_.size()) return false;
    switch (string_[at++]) {
      case 'F':
      case 'G': {
        const glm::dvec2 from = state.position;
        forward();
        sink(from, state.position);
        break;
      }
      case 'f':
        forward();
        break;
      case '+':
        turn(angle_deg_);
        break;
      case '-':
        turn(-angle_deg_);
        break;
      case '|':
        turn(180.0);
        break;
      case '[':
        stack.push_back(state);
        break;
      case ']':
        if (stack.empty()) break;
        state = stack.back();
        stack.pop_back();
        break;
      default:
        break;
    }
    return true;
  }

  State state;
  std::vector<State> stack;  ///< no deeper than the string is long
  std::size_t at = 0;        ///< the next symbol's place

 private:
  void forward() {
    const auto [s, c] = sine_cosine_deg(state.heading_deg);
    state.position += step_ * glm::dvec2(c, s);
  }
  // Kept small, so that a million turns are as exact as one.
  void turn(double by_deg) {
    state.heading_deg = std::remainder(state.heading_deg + by_deg, 360.0);
  }

  std::string_view string_;
  double step_, angle_deg_;
};

/// Calls sink(from, to) for each segment of an L-system after so many generations, the step being
/// length_ratio to their power: the figure keeps its size. @throws Error (bad input) as
/// l_system_string
template <typename Sink>
void draw_l_system(const LSystem& system, int generations, Sink&& sink,
                   std::size_t longest = kLongestLString) {
  const std::string string = l_system_string(system, generations, longest);
  Turtle turtle(string, std::pow(system.length_ratio, generations), system.angle_deg,
                system.start_deg);
  while (turtle.next(sink)) {
  }
}

}  // namespace kinescope
