#include "display/vector/stroke_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "display/vector/instruction_set.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

using Point = std::array<int, 2>;

/// A stroke as one of its ends has it.
struct End {
  Point at, other;
  std::size_t twin;  // the other end's place in the list of ends
  bool drawn = false;
};

Point point_of(float x, float y, const VectorMachine& machine) {
  return {std::clamp(static_cast<int>(std::lround(x)), 0, machine.width - 1),
          std::clamp(static_cast<int>(std::lround(y)), 0, machine.height - 1)};
}

/// Both ends of every stroke, by place: a place's strokes lie side by side.
std::vector<End> ends_of(std::span<const VectorSegment> strokes, const VectorMachine& machine) {
  std::vector<std::array<Point, 2>> ways;
  for (const VectorSegment& s : strokes) {
    const Point a = point_of(s.x1, s.y1, machine), b = point_of(s.x2, s.y2, machine);
    if (a == b) continue;
    ways.push_back({a, b});
    ways.push_back({b, a});
  }
  std::sort(ways.begin(), ways.end());
  ways.erase(std::unique(ways.begin(), ways.end()), ways.end());
  std::vector<End> ends;
  ends.reserve(ways.size());
  for (const auto& [at, other] : ways) {
    const auto twin = std::lower_bound(ways.begin(), ways.end(), std::array{other, at});
    ends.push_back({at, other, static_cast<std::size_t>(twin - ways.begin())});
  }
  return ends;
}

class Trails {
 public:
  explicit Trails(std::vector<End> ends) : ends_(std::move(ends)) {}

  /// Calls move(point) and draw(point). Trails begin first where one must: at places of an odd
  /// number of strokes.
  template <typename Move, typename Draw>
  void walk(const Move& move, const Draw& draw) {
    for (const bool odd_only : {true, false}) {
      for (std::size_t i = 0; i < ends_.size(); i = end_of_place(i)) {
        if (odd_only && (end_of_place(i) - i) % 2 == 0) continue;
        for (std::size_t first = i; first < end_of_place(i); ++first) {
          if (ends_[first].drawn) continue;
          move(ends_[first].at);
          follow(first, draw);
          if (odd_only) break;
        }
      }
    }
  }

 private:
  std::size_t end_of_place(std::size_t i) const {
    const Point at = ends_[i].at;
    while (i < ends_.size() && ends_[i].at == at) ++i;
    return i;
  }
  std::size_t begin_of_place(std::size_t i) const {
    while (i > 0 && ends_[i - 1].at == ends_[i].at) --i;
    return i;
  }
  template <typename Draw>
  void follow(std::size_t i, const Draw& draw) {
    while (!ends_[i].drawn) {
      const std::size_t twin = ends_[i].twin;
      ends_[i].drawn = ends_[twin].drawn = true;
      draw(ends_[i].other);
      const std::size_t end = end_of_place(twin);
      for (i = begin_of_place(twin); i + 1 < end && ends_[i].drawn;) ++i;
    }
  }

  std::vector<End> ends_;
};

}  // namespace

std::vector<Word> stroke_list(std::span<const VectorSegment> strokes,
                              const VectorMachine& machine) {
  if (machine.words != "generic" || !machine.knows("draw")) {
    throw Error(ErrorKind::kUsage, "the machine " + machine.name + " has no lines by two places",
                "--machine");
  }
  const InstructionSet& set = instruction_set(machine.words);
  std::vector<Word> words;
  std::int64_t clocks = machine.clocks("sync") + machine.clocks("again");
  const auto add = [&](std::string_view name, std::span<const std::int64_t> operands) {
    for (const Word word : set.encode(name, operands)) words.push_back(word);
  };
  Point beam{0, 0};
  const auto go = [&](std::string_view name, Point to) {
    add(name, std::array<std::int64_t, 2>{to[0], to[1]});
    clocks += machine.clocks(name, std::hypot(to[0] - beam[0], to[1] - beam[1]));
    beam = to;
  };
  add("sync", {});
  Trails(ends_of(strokes, machine))
      .walk([&](Point to) { go("move", to); }, [&](Point to) { go("draw", to); });
  add("again", {});
  const bool fits = static_cast<double>(clocks) * machine.sync_hz < machine.clock_hz;
  if (!fits) words.front() = set.encode("nop", {}).front();
  return words;
}

}  // namespace kinescope
