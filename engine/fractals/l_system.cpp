#include "engine/fractals/l_system.h"

#include <limits>

#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

std::uint64_t add_held(std::uint64_t a, std::uint64_t b) { return a > kMost - b ? kMost : a + b; }

}  // namespace

LSystemGenerations::LSystemGenerations(const LSystem& system, std::size_t longest)
    : system_(system), longest_(longest), string_(system.axiom) {
  if (string_.size() > longest_) throw_bad_input("the L-system's axiom is longer than its limit");
}

void LSystemGenerations::next() {
  // Its length first, so that nothing is written in vain.
  std::size_t length = 0;
  for (const char symbol : string_) {
    const auto rule = system_.rules.find(symbol);
    length += rule == system_.rules.end() ? 1 : rule->second.size();
    if (length > longest_) {
      throw_bad_input("generation " + std::to_string(generation_ + 1) +
                      " of the L-system has more than " + std::to_string(longest_) + " symbols");
    }
  }
  std::string rewritten;
  rewritten.reserve(length);
  for (const char symbol : string_) {
    const auto rule = system_.rules.find(symbol);
    if (rule == system_.rules.end()) {
      rewritten += symbol;
    } else {
      rewritten += rule->second;
    }
  }
  string_ = std::move(rewritten);
  ++generation_;
}

std::string l_system_string(const LSystem& system, int generations, std::size_t longest) {
  LSystemGenerations strings(system, longest);
  while (strings.generation() < generations) {
    // A string that cannot change is what it will be.
    std::string before = strings.string();
    strings.next();
    if (strings.string() == before) break;
  }
  return strings.string();
}

std::map<char, std::uint64_t> l_system_counts(const LSystem& system, int generations) {
  std::map<char, std::uint64_t> counts;
  for (const char symbol : system.axiom) ++counts[symbol];
  for (int i = 0; i < generations; ++i) {
    std::map<char, std::uint64_t> next;
    for (const auto& [symbol, count] : counts) {
      const auto rule = system.rules.find(symbol);
      if (rule == system.rules.end()) {
        next[symbol] = add_held(next[symbol], count);
        continue;
      }
      for (const char made : rule->second) next[made] = add_held(next[made], count);
    }
    if (next == counts) break;
    counts = std::move(next);
  }
  return counts;
}

}  // namespace kinescope
