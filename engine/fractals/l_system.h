// L-systems: strings rewritten in parallel, all symbols at once.
// Source: Prusinkiewicz and Lindenmayer, "The Algorithmic Beauty of Plants", 1990, ch. 1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kinescope {

struct LSystem {
  std::string name;
  std::string axiom;
  std::map<char, std::string> rules;  ///< a symbol without a rule stays
  double angle_deg = 90.0;            ///< of one + or -
  double start_deg = 0.0;             ///< heading at first
  double length_ratio = 1.0;          ///< of a step, from one generation to the next
};

/// Longer strings are refused, so that a system without end ends.
inline constexpr std::size_t kLongestLString = std::size_t{1} << 26;

/// The string of each generation in turn.
class LSystemGenerations {
 public:
  /// @throws Error (bad input) if the axiom is longer than the limit
  explicit LSystemGenerations(const LSystem& system, std::size_t longest = kLongestLString);

  /// Rewrites once. @throws Error (bad input) if the string would be longer than the limit; the
  /// string then stays as it was
  void next();

  const std::string& string() const { return string_; }
  int generation() const { return generation_; }

 private:
  LSystem system_;
  std::size_t longest_;
  std::string string_;
  int generation_ = 0;
};

/// The string after so many generations. @throws Error (bad input) as above
std::string l_system_string(const LSystem& system, int generations,
                            std::size_t longest = kLongestLString);

/// How often each symbol occurs, from the rules alone: strings too long to be kept can be counted.
/// Counts that do not fit hold at the largest number.
std::map<char, std::uint64_t> l_system_counts(const LSystem& system, int generations);

/// Reads
///   name Koch curve
///   axiom F
///   angle 60
///   start 0
///   ratio 0.333
///   F -> F+F--F+F
/// one a line, in any order; "#" begins a comment. @throws Error (bad input) naming the line
LSystem read_l_system(std::string_view text, const std::string& file = {});

/// The textbook's: Koch curve and snowflake, quadratic Koch, Sierpinski's arrowhead, dragon,
/// plants.
const std::vector<LSystem>& l_system_presets();
/// @throws Error (usage) naming the presets there are
const LSystem& l_system_preset(std::string_view name);

}  // namespace kinescope
