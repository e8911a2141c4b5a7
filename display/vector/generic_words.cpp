#include "display/vector/generic_words.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "display/vector/display_processor.h"
#include "display/vector/operands.h"

namespace kinescope {
namespace {

enum class Op : Word {
  kHalt,
  kNop,
  kMove,
  kDraw,
  kPoint,
  kRelativeMove,
  kRelativeDraw,
  kRelativePoint,
  kShort,
  kChars,
  kTable,
  kIntensity,
  kColour,
  kBlink,
  kScale,
  kJump,
  kCall,
  kReturn,
  kSync,
  kAgain,
  kPen
};

/// What an operation's 24 bits hold.
enum class Operands {
  kNone,
  kPlace,
  kWay,
  kShortWays,
  kThreeBytes,
  kAddress,
  kByte,
  kFlag,
  kScale
};

struct OpRow {
  std::string_view name;
  Operands operands;
};
/// By number of the operation.
constexpr std::array<OpRow, 21> kOps{{
    {"halt", Operands::kNone},         {"nop", Operands::kNone},
    {"move", Operands::kPlace},        {"draw", Operands::kPlace},
    {"point", Operands::kPlace},       {"rmove", Operands::kWay},
    {"rdraw", Operands::kWay},         {"rpoint", Operands::kWay},
    {"short", Operands::kShortWays},   {"chars", Operands::kThreeBytes},
    {"table", Operands::kAddress},     {"intensity", Operands::kByte},
    {"colour", Operands::kThreeBytes}, {"blink", Operands::kFlag},
    {"scale", Operands::kScale},       {"jump", Operands::kAddress},
    {"call", Operands::kAddress},      {"return", Operands::kNone},
    {"sync", Operands::kNone},         {"again", Operands::kNone},
    {"pen", Operands::kFlag},
}};
constexpr int kOperandBits = 24, kScaleBits = 12, kUnity = 16;
constexpr Word kOperandMask = (Word{1} << kOperandBits) - 1;

std::size_t number_of(std::string_view name) {
  const auto found =
      std::find_if(kOps.begin(), kOps.end(), [&](const OpRow& o) { return o.name == name; });
  return static_cast<std::size_t>(found - kOps.begin());
}

std::size_t operand_count(Operands operands) {
  switch (operands) {
    case Operands::kNone:
      return 0;
    case Operands::kPlace:
    case Operands::kWay:
      return 2;
    case Operands::kShortWays:
      return 6;
    case Operands::kThreeBytes:
      return 3;
    default:
      return 1;
  }
}

/// One of the two vectors of a `short`: five bits across, five up, one lit.
Word short_way(std::span<const std::int64_t> v) {
  return signed_field(v[0], 5) << 6 | signed_field(v[1], 5) << 1 | unsigned_field(v[2], 1);
}

Word pack(Operands operands, std::span<const std::int64_t> v) {
  switch (operands) {
    case Operands::kNone:
      return 0;
    case Operands::kPlace:
      return unsigned_field(v[0], 12) << 12 | unsigned_field(v[1], 12);
    case Operands::kWay:
      return signed_field(v[0], 12) << 12 | signed_field(v[1], 12);
    case Operands::kShortWays:
      return short_way(v.first(3)) << 11 | short_way(v.subspan(3));
    case Operands::kThreeBytes:
      return unsigned_field(v[0], 8) << 16 | unsigned_field(v[1], 8) << 8 | unsigned_field(v[2], 8);
    case Operands::kAddress:
      return unsigned_field(v[0], kOperandBits);
    case Operands::kByte:
      return unsigned_field(v[0], 8);
    case Operands::kFlag:
      return unsigned_field(v[0], 1);
    case Operands::kScale:
      return unsigned_field(v[0], kScaleBits);
  }
  return 0;
}

std::string operand_text(Operands operands, Word w) {
  switch (operands) {
    case Operands::kNone:
      return "";
    case Operands::kPlace:
      return fmt::format(" {} {}", field(w, 12, 12), field(w, 0, 12));
    case Operands::kWay:
      return fmt::format(" {} {}", signed_field_of(w, 12, 12), signed_field_of(w, 0, 12));
    case Operands::kShortWays:
      return fmt::format(" {} {} {} {} {} {}", signed_field_of(w, 17, 5), signed_field_of(w, 12, 5),
                         field(w, 11, 1), signed_field_of(w, 6, 5), signed_field_of(w, 1, 5),
                         field(w, 0, 1));
    case Operands::kThreeBytes:
      return fmt::format(" {} {} {}", field(w, 16, 8), field(w, 8, 8), field(w, 0, 8));
    case Operands::kByte:
      return fmt::format(" {}", field(w, 0, 8));
    case Operands::kFlag:
      return fmt::format(" {}", field(w, 0, 1));
    case Operands::kScale:
      return fmt::format(" {}", field(w, 0, kScaleBits));
    default:
      return fmt::format(" {}", w & kOperandMask);
  }
}

/// The beam's ways of one instruction.
class Beam {
 public:
  Beam(ProcessorCore& core, std::string_view name) : core_(core), name_(name) {}

  void to(double x, double y, bool lit) {
    const ProcessorState& s = core_.state();
    const double units = std::hypot(x - s.x, y - s.y);
    core_.move_beam(x, y, core_.machine().clocks(name_, units), lit ? s.intensity : 0);
  }
  void by(int dx, int dy, bool lit) {
    const ProcessorState& s = core_.state();
    const double scale = static_cast<double>(s.scale) / kUnity;
    to(s.x + dx * scale, s.y + dy * scale, lit);
  }
  /// Dark to a place, as `move` goes there, then lit for as long as the instruction takes.
  void point(double x, double y) {
    const ProcessorState& s = core_.state();
    const double units = std::hypot(x - s.x, y - s.y);
    const std::int64_t rest = core_.machine().clocks(name_);
    if (units > 0) core_.move_beam(x, y, core_.machine().clocks(name_, units) - rest, 0);
    core_.move_beam(x, y, rest, s.intensity);
  }

 private:
  ProcessorCore& core_;
  std::string_view name_;
};

/// Calls the next of a word's three characters, and comes back to the same word for the others.
void call_character(ProcessorCore& core, Word word, Address at) {
  ProcessorState& s = core.state();
  if (!s.characters) return core.fault("chars before any table of characters");
  core.spend("chars");
  while (s.character < 3) {
    const auto code = static_cast<Address>(field(word, 16 - 8 * s.character, 8));
    ++s.character;
    if (code == 0) continue;
    const std::optional<Word> target = core.read(*s.characters + code);
    if (!target) return;
    return core.call(*target, at);
  }
  s.character = 0;
}

void draw(ProcessorCore& core, Op op, std::string_view name, Word w) {
  Beam beam(core, name);
  const ProcessorState& s = core.state();
  const double x = field(w, 12, 12), y = field(w, 0, 12);
  const int dx = signed_field_of(w, 12, 12), dy = signed_field_of(w, 0, 12);
  const double scale = static_cast<double>(s.scale) / kUnity;
  switch (op) {
    case Op::kMove:
      return beam.to(x, y, false);
    case Op::kDraw:
      return beam.to(x, y, true);
    case Op::kPoint:
      return beam.point(x, y);
    case Op::kRelativeMove:
      return beam.by(dx, dy, false);
    case Op::kRelativeDraw:
      return beam.by(dx, dy, true);
    case Op::kRelativePoint:
      return beam.point(s.x + dx * scale, s.y + dy * scale);
    default:
      beam.by(signed_field_of(w, 17, 5), signed_field_of(w, 12, 5), field(w, 11, 1) != 0);
      if (s.status != ProcessorStatus::kRunning) return;  // the pen saw the first
      if ((w & 0x7ff) != 0)
        beam.by(signed_field_of(w, 6, 5), signed_field_of(w, 1, 5), (w & 1) != 0);
  }
}

void control(ProcessorCore& core, Op op, Word w, Address at) {
  ProcessorState& s = core.state();
  const auto level = [](int v) { return static_cast<float>(v) / 255; };
  switch (op) {
    case Op::kHalt:
      return core.halt();
    case Op::kTable:
      s.characters = w & kOperandMask;
      return;
    case Op::kIntensity:
      s.intensity = level(field(w, 0, 8));
      return;
    case Op::kColour:
      s.colour = {level(field(w, 16, 8)), level(field(w, 8, 8)), level(field(w, 0, 8))};
      return;
    case Op::kBlink:
      s.blinks = field(w, 0, 1) != 0;
      return;
    case Op::kScale:
      s.scale = field(w, 0, kScaleBits);
      return;
    case Op::kJump:
      s.next = w & kOperandMask;
      return;
    case Op::kCall:
      return core.call(w & kOperandMask, at + 1);
    case Op::kReturn:
      return core.come_back();
    case Op::kSync:
      return core.wait_for(core.machine().sync_hz);
    case Op::kAgain:
      s.next = s.start;
      return;
    case Op::kPen:
      s.pen_on = field(w, 0, 1) != 0;
      return;
    default:
      return;
  }
}

bool drives_beam(Op op) { return op >= Op::kMove && op <= Op::kShort; }

}  // namespace

void GenericWords::step(ProcessorCore& core) const {
  ProcessorState& s = core.state();
  const Address at = s.next;
  const std::optional<Word> word = core.read(at);
  if (!word) return;
  const std::size_t number = *word >> kOperandBits;
  if (number >= kOps.size()) return core.fault(fmt::format("{:#010x} is no instruction", *word));
  const Op op = static_cast<Op>(number);
  const std::string_view name = kOps[number].name;
  if (!core.machine().knows(name)) {
    return core.fault(fmt::format("{} has no {}", core.machine().name, name));
  }
  if (op == Op::kChars) {
    call_character(core, *word, at);
    if (s.character == 0 && s.status == ProcessorStatus::kRunning) s.next = at + 1;
    return;
  }
  s.next = at + 1;
  if (drives_beam(op)) return draw(core, op, name, *word);
  core.spend(name);
  control(core, op, *word, at);
}

std::vector<std::string> GenericWords::cost_names() const {
  std::vector<std::string> names;
  for (const OpRow& op : kOps) names.emplace_back(op.name);
  return names;
}

std::size_t GenericWords::length(std::string_view name, std::size_t operands) const {
  const std::size_t number = number_of(name);
  if (number == kOps.size()) return 0;
  return static_cast<Op>(number) == Op::kChars ? std::max<std::size_t>(1, (operands + 2) / 3) : 1;
}

std::vector<Word> GenericWords::encode(std::string_view name,
                                       std::span<const std::int64_t> operands) const {
  const std::size_t number = number_of(name);
  const Word op = static_cast<Word>(number) << kOperandBits;
  std::vector<std::int64_t> v(operands.begin(), operands.end());
  if (static_cast<Op>(number) == Op::kChars) v.resize(3 * length(name, v.size()), 0);
  if (static_cast<Op>(number) == Op::kShort && v.size() == 3) v.resize(6, 0);
  std::vector<Word> words;
  const Operands kind = kOps[number].operands;
  if (static_cast<Op>(number) != Op::kChars) expect_operands(name, v.size(), operand_count(kind));
  for (std::size_t i = 0; i == 0 || i < v.size(); i += operand_count(kind)) {
    words.push_back(op | pack(kind, std::span(v).subspan(i)));
    if (operand_count(kind) == 0) break;
  }
  return words;
}

InstructionSet::Text GenericWords::decode(std::span<const Word> words) const {
  const Word word = words[0];
  const std::size_t number = word >> kOperandBits;
  if (number >= kOps.size()) return {};
  return {std::string(kOps[number].name) + operand_text(kOps[number].operands, word), 1};
}

}  // namespace kinescope
