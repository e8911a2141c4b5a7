#include "display/vector/dvg_words.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "display/vector/display_processor.h"
#include "display/vector/operands.h"

namespace kinescope {
namespace {

constexpr int kMostScale = 9;
constexpr std::int64_t kClocksAStep = 8;

constexpr std::array<std::string_view, 7> kNames{"vctr", "labs", "halt", "jsrl",
                                                 "rtsl", "jmpl", "svec"};

/// Sign and magnitude, `bits` bits of magnitude with the sign above them.
Word sign_magnitude(std::int64_t value, int bits) {
  const Word sign = value < 0 ? Word{1} << bits : 0;
  return sign | unsigned_field(value < 0 ? -value : value, bits);
}
int magnitude_of(Word word, int bits) {
  const int magnitude = field(word, 0, bits);
  return field(word, bits, 1) != 0 ? -magnitude : magnitude;
}

/// Of `svec`: two bits of magnitude, their sign above them, and two bits of scale apart.
struct ShortVector {
  int dx, dy, scale, z;
  explicit ShortVector(Word w)
      : dx(magnitude_of(w, 2)),
        dy(magnitude_of(w >> 8, 2)),
        scale(field(w, 3, 1) << 1 | field(w, 11, 1)),
        z(field(w, 4, 4)) {}
};

/// Draws a way, of 10 bits each, by the sum of scales: four bits; beyond 9 the counter stops at
/// once.
void vector(ProcessorCore& core, int dx, int dy, int scale, int z) {
  const ProcessorState& s = core.state();
  const int sum = (scale + s.scale) & 15;
  if (sum > kMostScale) return;
  const double share = std::ldexp(1.0, sum - kMostScale);
  const std::int64_t steps = std::int64_t{1} << (sum + 1);
  core.move_beam(s.x + dx * share, s.y + dy * share, steps * kClocksAStep,
                 static_cast<float>(z) / 15);
}

bool has_second_word(Word op) { return op <= 10; }

}  // namespace

void DvgWords::step(ProcessorCore& core) const {
  ProcessorState& s = core.state();
  const Address at = s.next;
  const std::optional<Word> first = core.read(at);
  if (!first) return;
  const Word w = *first & 0xffff, op = w >> 12;
  core.spend("fetch");
  s.next = at + 1;
  Word second = 0;
  if (has_second_word(op)) {
    const std::optional<Word> more = core.read(at + 1);
    if (!more) return;
    second = *more & 0xffff;
    core.spend("fetch");
    s.next = at + 2;
  }
  if (op <= 9) {
    vector(core, magnitude_of(second, 10), magnitude_of(w, 10), static_cast<int>(op),
           field(second, 12, 4));
  } else if (op == 10) {
    s.scale = field(second, 12, 4);
    core.move_beam(field(second, 0, 10), field(w, 0, 10), core.machine().clocks("labs"), 0);
  } else if (op == 11) {
    core.halt();
  } else if (op == 12) {
    core.call(w & 0xfff, at + 1);
  } else if (op == 13) {
    core.come_back();
  } else if (op == 14) {
    s.next = w & 0xfff;
  } else {
    const ShortVector v(w);
    vector(core, v.dx << 8, v.dy << 8, v.scale + 2, v.z);
  }
}

std::vector<std::string> DvgWords::cost_names() const { return {"fetch", "labs"}; }

std::size_t DvgWords::length(std::string_view name, std::size_t) const {
  if (std::find(kNames.begin(), kNames.end(), name) == kNames.end()) return 0;
  return name == "vctr" || name == "labs" ? 2 : 1;
}

std::vector<Word> DvgWords::encode(std::string_view name, std::span<const std::int64_t> v) const {
  const auto take = [&](std::size_t count) { expect_operands(name, v.size(), count); };
  if (name == "vctr") {
    take(4);
    if (v[2] > kMostScale)
      throw_bad_input(fmt::format("{} must lie from 0 to {}", v[2], kMostScale));
    return {unsigned_field(v[2], 4) << 12 | sign_magnitude(v[1], 10),
            unsigned_field(v[3], 4) << 12 | sign_magnitude(v[0], 10)};
  }
  if (name == "labs") {
    take(3);
    return {0xa000 | unsigned_field(v[1], 10),
            unsigned_field(v[2], 4) << 12 | unsigned_field(v[0], 10)};
  }
  if (name == "svec") {
    take(4);
    const Word scale = unsigned_field(v[2], 2);
    return {0xf000 | (scale & 1) << 11 | sign_magnitude(v[1], 2) << 8 |
            unsigned_field(v[3], 4) << 4 | (scale >> 1) << 3 | sign_magnitude(v[0], 2)};
  }
  if (name == "halt" || name == "rtsl") {
    take(0);
    return {name == "halt" ? Word{0xb000} : Word{0xd000}};
  }
  take(1);
  return {(name == "jsrl" ? Word{0xc000} : Word{0xe000}) | unsigned_field(v[0], 12)};
}

InstructionSet::Text DvgWords::decode(std::span<const Word> words) const {
  const Word w = words[0], op = w >> 12;
  if (op > 15) return {};
  if (has_second_word(op)) {
    if (words.size() < 2 || words[1] > 0xffff) return {};
    const Word second = words[1];
    if (op == 10) {
      return {
          fmt::format("labs {} {} {}", field(second, 0, 10), field(w, 0, 10), field(second, 12, 4)),
          2};
    }
    return {fmt::format("vctr {} {} {} {}", magnitude_of(second, 10), magnitude_of(w, 10), op,
                        field(second, 12, 4)),
            2};
  }
  switch (op) {
    case 11:
      return {"halt", 1};
    case 12:
      return {fmt::format("jsrl {}", w & 0xfff), 1};
    case 13:
      return {"rtsl", 1};
    case 14:
      return {fmt::format("jmpl {}", w & 0xfff), 1};
    default:
      break;
  }
  const ShortVector v(w);
  return {fmt::format("svec {} {} {} {}", v.dx, v.dy, v.scale, v.z), 1};
}

}  // namespace kinescope
