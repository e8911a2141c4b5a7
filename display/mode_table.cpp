// The table of video modes, and modes from what a user types.
#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "display/data_lines.h"
#include "display/mode_request.h"
#include "display/video_mode.h"
#include "modes_txt.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr const char* kTableFile = "display/data/modes.txt";

SyncTiming parse_timing(const Words& words, std::size_t first, const std::string& where) {
  const auto interval = [&](std::size_t i) {
    return static_cast<int>(parse_number(words[first + i], kTableFile, where));
  };
  const std::string& polarity = words[first + 4];
  if (polarity != "+" && polarity != "-") throw_bad_input("polarity is + or -", kTableFile, where);
  return {interval(0), interval(1), interval(2), interval(3), polarity == "+"};
}

/// A mode of the table by another name.
VideoMode renamed(const std::vector<VideoMode>& modes, const Words& words,
                  const std::string& where) {
  for (VideoMode mode : modes) {
    if (mode.name != words[2]) continue;
    mode.name = words[0];
    return mode;
  }
  throw_bad_input("no mode above has that name", kTableFile, where);
}

std::vector<VideoMode> parse_table() {
  std::vector<VideoMode> modes;
  for_each_data_line(embedded::modes_txt(), [&](const Words& words, const std::string& where) {
    if (words.size() == 3 && words[1] == "=") {
      modes.push_back(renamed(modes, words, where));
      return;
    }
    if (words.size() != 13) throw_bad_input("a mode has 13 words", kTableFile, where);
    VideoMode mode;
    mode.name = words[0];
    mode.pixel_clock_hz = parse_number(words[1], kTableFile, where);
    mode.horizontal = parse_timing(words, 2, where);
    mode.vertical = parse_timing(words, 7, where);
    if (words[12] != "p" && words[12] != "i") {
      throw_bad_input("scan is p or i", kTableFile, where);
    }
    mode.interlaced = words[12] == "i";
    mode.check();
    modes.push_back(mode);
  });
  return modes;
}

[[noreturn]] void refuse_text(std::string_view text, const std::string& why) {
  throw Error(ErrorKind::kUsage, fmt::format("video mode \"{}\": {}", text, why));
}

template <typename Number>
std::optional<Number> take_number(std::string_view& text) {
  Number value{};
  const auto [rest, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  return value;
}

bool take(std::string_view& text, std::string_view expected) {
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(expected.size());
  return true;
}

/// "WxH@HZ", or "WxH@HZi" for interlaced, whose rate is of fields, as it is commonly written.
ModeRequest parse_request(std::string_view whole, std::string_view text) {
  const auto width = take_number<long long>(text);
  const bool by = width && take(text, "x");
  const auto height = by ? take_number<long long>(text) : std::nullopt;
  const bool at = height && take(text, "@");
  const auto rate = at ? take_number<double>(text) : std::nullopt;
  const bool interlaced = rate && take(text, "i");
  if (!rate || !text.empty()) {
    refuse_text(whole,
                "neither a name of the table nor WIDTHxHEIGHT@HERTZ, gtf:WxH@HZ, cvt:WxH@HZ, "
                "cvtrb:WxH@HZ or a Modeline");
  }
  for (const long long side : {*width, *height}) {
    if (side < 1 || side > 16384) refuse_text(whole, "sides are 1 to 16384 pixels");
  }
  const ModeRequest request{static_cast<int>(*width), static_cast<int>(*height),
                            interlaced ? *rate / 2 : *rate, interlaced};
  check_request(request);
  return request;
}

SyncTiming timing_of_ends(std::string_view text, const double* ends) {
  for (int i = 0; i < 4; ++i) {
    if (!(ends[i] >= 0 && ends[i] <= 65536) || ends[i] != std::floor(ends[i])) {
      refuse_text(text, fmt::format("{:g} is not a number of pixels or lines", ends[i]));
    }
  }
  const auto at = [&](int i) { return static_cast<int>(ends[i]); };
  return {at(0), at(1) - at(0), at(2) - at(1), at(3) - at(2), false};
}

void apply_flag(VideoMode& mode, std::string_view text, std::string flag) {
  for (char& c : flag) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (flag == "+hsync" || flag == "-hsync") {
    mode.horizontal.positive_sync = flag[0] == '+';
  } else if (flag == "+vsync" || flag == "-vsync") {
    mode.vertical.positive_sync = flag[0] == '+';
  } else if (flag == "interlace") {
    mode.interlaced = true;
  } else {
    refuse_text(text, "unknown flag " + flag);
  }
}

/// [Modeline] "NAME" CLOCK_MHZ, four ends across, four ends down, flags.
VideoMode parse_modeline(std::string_view text) {
  const std::size_t open = text.find('"');
  const std::size_t close = open == std::string_view::npos ? open : text.find('"', open + 1);
  if (close == std::string_view::npos) refuse_text(text, "a Modeline has its name in quotes");
  VideoMode mode;
  mode.name = std::string(text.substr(open + 1, close - open - 1));
  const Words words = split_words(text.substr(close + 1));
  if (words.size() < 9) refuse_text(text, "a Modeline has a clock and eight numbers");
  double numbers[9];
  for (std::size_t i = 0; i < 9; ++i) {
    std::string_view word = words[i];
    const auto number = take_number<double>(word);
    if (!number || !word.empty()) refuse_text(text, "\"" + words[i] + "\" is not a number");
    numbers[i] = *number;
  }
  mode.pixel_clock_hz = std::round(numbers[0] * 1e6);
  mode.horizontal = timing_of_ends(text, numbers + 1);
  mode.vertical = timing_of_ends(text, numbers + 5);
  for (std::size_t i = 9; i < words.size(); ++i) apply_flag(mode, text, words[i]);
  mode.check();
  return mode;
}

/// A table entry of the same size whose rate is the one asked for, as people write it.
const VideoMode* find_by_rate(const ModeRequest& request) {
  for (const VideoMode& mode : standard_modes()) {
    if (mode.horizontal.active == request.width && mode.vertical.active == request.height &&
        mode.interlaced == request.interlaced &&
        std::abs(mode.frame_rate().hertz() - request.refresh_hz) < 0.05) {
      return &mode;
    }
  }
  return nullptr;
}

}  // namespace

std::span<const VideoMode> standard_modes() {
  static const std::vector<VideoMode> modes = parse_table();
  return modes;
}

VideoMode parse_mode(std::string_view text) {
  for (const VideoMode& mode : standard_modes()) {
    if (mode.name == text) return mode;
  }
  std::string_view rest = text;
  if (text.find('"') != std::string_view::npos) return parse_modeline(text);
  const bool gtf = take(rest, "gtf:");
  const bool reduced = !gtf && take(rest, "cvtrb:");
  const bool formula = gtf || reduced || take(rest, "cvt:");
  const ModeRequest r = parse_request(text, rest);
  if (const VideoMode* known = formula ? nullptr : find_by_rate(r)) return *known;
  return gtf ? gtf_mode(r.width, r.height, r.refresh_hz, r.interlaced)
             : cvt_mode(r.width, r.height, r.refresh_hz, reduced, r.interlaced);
}

}  // namespace kinescope
