#include "demos/input_script.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "raster/base/error.h"
#include "raster/base/input_file.h"

namespace kinescope {
namespace {

constexpr std::int64_t kMaxFrame = 1'000'000'000;
constexpr int kMaxPlace = 32768;
constexpr int kMaxDragFrames = 100'000;

/// Takes one line apart, word by word.
class Line {
 public:
  Line(std::string_view text, const std::string& file, int number)
      : rest_(text), file_(file), number_(number) {}

  bool at_end() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r"), rest_.size()));
    return rest_.empty();
  }
  std::string_view word(const char* what) {
    if (at_end()) fail(fmt::format("{} is missing", what));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r"));
    rest_.remove_prefix(word.size());
    return word;
  }
  template <typename T>
  T number(const char* what, T minimum, T maximum) {
    const std::string_view text = word(what);
    T value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || end != text.data() + text.size()) {
      fail(fmt::format("{} must be a number, not \"{}\"", what, text));
    }
    // Written so that NaN fails too.
    if (!(value >= minimum && value <= maximum)) {
      fail(fmt::format("{} must lie between {} and {}", what, minimum, maximum));
    }
    return value;
  }
  MouseButton button() {
    if (at_end()) return MouseButton::kLeft;
    const std::string_view name = word("the button");
    if (name == "left") return MouseButton::kLeft;
    if (name == "middle") return MouseButton::kMiddle;
    if (name == "right") return MouseButton::kRight;
    fail(fmt::format("unknown button \"{}\": left, middle or right", name));
  }
  std::string_view all() {
    if (at_end()) fail("the text is missing");
    const std::string_view text = rest_.substr(0, rest_.find_last_not_of(" \t\r") + 1);
    rest_ = {};
    return text;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw_bad_input(what, file_, fmt::format("line {}", number_));
  }

 private:
  std::string_view rest_;
  const std::string& file_;
  int number_;
};

InputEvent mouse(InputKind kind, int x, int y, MouseButton button = MouseButton::kNone) {
  InputEvent event;
  event.kind = kind;
  event.x = x;
  event.y = y;
  event.button = button;
  return event;
}

InputEvent press(InputKind kind, std::string_view name) {
  // Names for keys that a comment or a reader would swallow.
  static const std::map<std::string_view, std::string> kSpelled = {
      {"comma", ","}, {"period", "."}, {"hash", "#"}, {"question", "?"}};
  InputEvent event;
  event.kind = kind;
  const auto spelled = kSpelled.find(name);
  event.key = spelled == kSpelled.end() ? std::string(name) : spelled->second;
  return event;
}

using Events = std::map<std::int64_t, std::vector<InputEvent>>;

void read_drag(Line& line, std::int64_t frame, Events& events) {
  const auto place = [&](const char* what) { return line.number(what, -kMaxPlace, kMaxPlace); };
  const int x0 = place("x0"), y0 = place("y0"), x1 = place("x1"), y1 = place("y1");
  const int frames = line.number("the number of frames", 1, kMaxDragFrames);
  const MouseButton button = line.button();
  events[frame].push_back(mouse(InputKind::kMouseDown, x0, y0, button));
  for (int i = 1; i <= frames; ++i) {
    const double share = static_cast<double>(i) / frames;
    events[frame + i].push_back(mouse(InputKind::kMouseMove,
                                      static_cast<int>(std::lround(std::lerp(x0, x1, share))),
                                      static_cast<int>(std::lround(std::lerp(y0, y1, share)))));
  }
  events[frame + frames].push_back(mouse(InputKind::kMouseUp, x1, y1, button));
}

void read_line(Line& line, Events& events) {
  const auto frame = line.number<std::int64_t>("the frame", 0, kMaxFrame);
  const std::string_view verb = line.word("what happens");
  const auto place = [&](const char* what) { return line.number(what, -kMaxPlace, kMaxPlace); };
  std::vector<InputEvent>& now = events[frame];
  if (verb == "key") {
    const std::string_view name = line.word("the key's name");
    now.push_back(press(InputKind::kKeyDown, name));
    now.push_back(press(InputKind::kKeyUp, name));
  } else if (verb == "move") {
    const int x = place("x");
    now.push_back(mouse(InputKind::kMouseMove, x, place("y")));
  } else if (verb == "click") {
    const int x = place("x"), y = place("y");
    const MouseButton button = line.button();
    now.push_back(mouse(InputKind::kMouseDown, x, y, button));
    now.push_back(mouse(InputKind::kMouseUp, x, y, button));
  } else if (verb == "drag") {
    read_drag(line, frame, events);
  } else if (verb == "wheel") {
    const int x = place("x");
    now.push_back(mouse(InputKind::kWheel, x, place("y")));
    now.back().wheel = line.number<float>("the number of notches", -1000.0f, 1000.0f);
  } else if (verb == "text") {
    now.push_back(press(InputKind::kText, line.all()));
  } else if (verb == "resize") {
    const int width = line.number("the width", 1, kMaxPlace);
    now.push_back(mouse(InputKind::kResize, width, line.number("the height", 1, kMaxPlace)));
  } else {
    line.fail(
        fmt::format("unknown input \"{}\": key, move, click, drag, wheel, text or resize", verb));
  }
  if (!line.at_end()) line.fail(fmt::format("\"{}\" is one word too many", line.word("a word")));
}

}  // namespace

InputScript InputScript::parse(std::string_view text, const std::string& name) {
  InputScript script;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    const std::string_view whole = text.substr(0, length);
    Line line(whole.substr(0, whole.find('#')), name, number);
    if (!line.at_end()) read_line(line, script.events_);
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return script;
}

InputScript InputScript::read(const std::string& path) {
  const std::vector<std::uint8_t> bytes = read_file(path, std::size_t{1} << 26);
  return parse({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

std::vector<InputEvent> InputScript::events_at(std::int64_t frame) const {
  const auto found = events_.find(frame);
  return found == events_.end() ? std::vector<InputEvent>{} : found->second;
}

std::int64_t InputScript::last_frame() const {
  return events_.empty() ? -1 : events_.rbegin()->first;
}

}  // namespace kinescope
