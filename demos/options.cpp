#include "demos/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "raster/base/error.h"
#include "raster/image/codecs.h"

namespace kinescope {
namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& option,
                         const std::string& wanted) {
  throw Error(ErrorKind::kUsage, "\"" + std::string(text) + "\" is not " + wanted, option);
}

/// The whole of `text` as a number, or nothing.
template <typename Number>
std::optional<Number> whole_number(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc() || stop != end) return std::nullopt;
  return value;
}

/// "a" and "b" of "a?b"; b is empty where there is no such character.
std::pair<std::string_view, std::string_view> split(std::string_view text, char at) {
  const std::size_t place = text.find(at);
  if (place == std::string_view::npos) return {text, {}};
  return {text.substr(0, place), text.substr(place + 1)};
}

/// "a" or "a/b", finite and above 0.
std::optional<double> positive_ratio(std::string_view text) {
  const auto [over, under] = split(text, '/');
  const bool is_ratio = text.find('/') != std::string_view::npos;
  const auto a = whole_number<double>(over);
  const auto b = is_ratio ? whole_number<double>(under) : std::optional<double>(1.0);
  if (!a || !b || !(*a > 0) || !(*b > 0) || !std::isfinite(*a / *b)) return std::nullopt;
  return *a / *b;
}

}  // namespace

int parse_whole(std::string_view text, const std::string& option, int least, int most) {
  const auto value = whole_number<int>(text);
  if (!value || *value < least || *value > most) {
    refuse(text, option,
           "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return *value;
}

double parse_number(std::string_view text, const std::string& option) {
  const auto value = whole_number<double>(text);
  if (!value || !std::isfinite(*value)) refuse(text, option, "a number");
  return *value;
}

Size parse_size(std::string_view text, const std::string& option) {
  const auto [across, down] = split(text, 'x');
  const auto width = whole_number<int>(across), height = whole_number<int>(down);
  if (!width || !height || *width < 1 || *height < 1 || *width > kMaxImageSide ||
      *height > kMaxImageSide) {
    refuse(text, option,
           "a size such as 640x480, each side at most " + std::to_string(kMaxImageSide));
  }
  return {*width, *height};
}

FrameRange parse_frames(std::string_view text, const std::string& option) {
  constexpr int kMost = 10'000'000;
  const auto [first_text, last_text] = split(text, '-');
  const auto first = whole_number<int>(first_text);
  if (text.find('-') == std::string_view::npos) {
    if (first && *first >= 1 && *first <= kMost) return {0, *first - 1};
  } else if (const auto last = whole_number<int>(last_text);
             first && last && *first >= 0 && *last >= *first && *last < kMost) {
    return {*first, *last};
  }
  refuse(text, option, "a count of frames such as 60, or a range such as 0-59");
}

Rate parse_rate(std::string_view text, const std::string& option) {
  constexpr double kMost = 1e6;
  const auto hertz = positive_ratio(text);
  if (!hertz || *hertz > kMost || *hertz < 1 / kMost) {
    refuse(text, option, "a rate such as 60, 59.94 or 60000/1001");
  }
  const auto [over, under] = split(text, '/');
  const auto a = whole_number<std::int64_t>(over);
  const auto b = under.empty() ? std::int64_t{1} : whole_number<std::int64_t>(under);
  if (a && b) return Rate{*a, *b}.reduced();
  return Rate{std::llround(*hertz * 1e6), 1'000'000}.reduced();
}

std::optional<Seconds> parse_shutter(std::string_view text, const std::string& option) {
  if (text == "frame") return std::nullopt;
  const auto seconds = positive_ratio(text);
  if (!seconds || *seconds > 3600) refuse(text, option, "frame, or seconds such as 0.004 or 1/240");
  return Seconds(*seconds);
}

Seconds parse_start(std::string_view text, const std::string& option) {
  constexpr double kLatest_s = 1e6;
  if (text == "0") return Seconds(0);
  const auto seconds = positive_ratio(text);
  if (!seconds || *seconds > kLatest_s) refuse(text, option, "a time in seconds, 0 or later");
  return Seconds(*seconds);
}

std::optional<double> parse_gain(std::string_view text, const std::string& option) {
  if (text == "auto") return std::nullopt;
  const auto gain = positive_ratio(text);
  if (!gain || *gain > 1e6) refuse(text, option, "auto, or a factor above 0 such as 2.5");
  return gain;
}

double parse_aspect(std::string_view text, const std::string& option) {
  std::string ratio(text);
  std::replace(ratio.begin(), ratio.end(), ':', '/');
  const auto aspect = positive_ratio(ratio);
  if (!aspect || *aspect > 10 || *aspect < 0.1) refuse(text, option, "a shape such as 4:3 or 16:9");
  return *aspect;
}

RawVideo parse_raw_video(std::string_view text, const std::string& option) {
  const auto [name, rest] = split(text, ':');
  const auto [size_text, rate_text] = split(rest, '@');
  if (size_text.empty() || rate_text.empty()) {
    refuse(text, option, "raw video such as rgb24:640x480@60");
  }
  const Size size = parse_size(size_text, option);
  const Rate rate = parse_rate(rate_text, option);
  if (std::int64_t{size.width} * size.height > kMaxImagePixels) {
    refuse(size_text, option, "a size of at most " + std::to_string(kMaxImagePixels) + " pixels");
  }
  const auto format = raw_format(std::string(name), size.width, size.height);
  if (!format) refuse(name, option, "a format of raw video; there are " + raw_format_names());
  return {*format, rate};
}

glm::vec3 parse_vector(std::string_view text, const std::string& option) {
  const auto [x, rest] = split(text, ',');
  const auto [y, z] = split(rest, ',');
  glm::vec3 vector;
  int axis = 0;
  for (const std::string_view part : {x, y, z}) {
    const auto value = whole_number<float>(part);
    if (!value || !std::isfinite(*value)) refuse(text, option, "three numbers such as 1,2.5,-3");
    vector[axis++] = *value;
  }
  return vector;
}

}  // namespace kinescope
