// YUV4MPEG2. Source: the format's description in MJPEG Tools (yuv4mpeg(5)); the names of deeper
// samples are ffmpeg's.
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

#include "raster/base/error.h"
#include "raster/image/codecs.h"
#include "raster/image/limits.h"
#include "raster/image/video.h"

namespace kinescope {
namespace {

constexpr std::string_view kMagic = "YUV4MPEG2", kFrame = "FRAME";
constexpr std::size_t kLongestHeader = 1024;
constexpr std::int64_t kMostHertz = 1'000'000, kLargestTerm = 1'000'000'000;

/// What a stream's header says.
struct Header {
  VideoFormat format;
  Rate rate{25, 1};
  std::optional<double> pixel_aspect;
  bool names_matrix = false;
};

struct Colours {
  std::string_view name;
  FrameLayout layout;
  int across, down;
  ChromaSite blue, red;
};

// 4:2:0's four sitings. PAL DV's chromas lie on lines that alternate: Cr on the first, Cb below.
constexpr std::array kColours{
    Colours{"420jpeg", FrameLayout::kYuv, 2, 2, {0.5, 0.5}, {0.5, 0.5}},
    Colours{"420mpeg2", FrameLayout::kYuv, 2, 2, {0, 0.5}, {0, 0.5}},
    Colours{"420paldv", FrameLayout::kYuv, 2, 2, {0, 1}, {0, 0}},
    Colours{"420", FrameLayout::kYuv, 2, 2, {0.5, 0.5}, {0.5, 0.5}},
    Colours{"422", FrameLayout::kYuv, 2, 1, {}, {}},
    Colours{"411", FrameLayout::kYuv, 4, 1, {}, {}},
    Colours{"444", FrameLayout::kYuv, 1, 1, {}, {}},
    Colours{"mono", FrameLayout::kGrey, 1, 1, {}, {}},
};

/// "60000:1001", of numbers that are not negative.
std::optional<std::pair<std::int64_t, std::int64_t>> parse_ratio(std::string_view text) {
  std::pair<std::int64_t, std::int64_t> ratio;
  const char* const end = text.data() + text.size();
  const auto over = std::from_chars(text.data(), end, ratio.first);
  if (over.ec != std::errc() || over.ptr == end || *over.ptr != ':') return std::nullopt;
  const auto under = std::from_chars(over.ptr + 1, end, ratio.second);
  if (under.ec != std::errc() || under.ptr != end) return std::nullopt;
  for (const std::int64_t term : {ratio.first, ratio.second}) {
    if (term < 0 || term > kLargestTerm) return std::nullopt;
  }
  return ratio;
}

/// Reads the header's words into a Header.
class HeaderParser {
 public:
  HeaderParser(const std::string& name, std::string where)
      : name_(name), where_(std::move(where)) {}

  Header parse(std::string_view line) {
    line.remove_prefix(kMagic.size());
    set_colours("420");
    while (!line.empty()) {
      line.remove_prefix(1);  // the blank between words
      const std::string_view word = line.substr(0, line.find(' '));
      line.remove_prefix(word.size());
      if (!word.empty()) take(word);
    }
    VideoFormat& f = header_.format;
    check_image_size(width_, height_, kMaxImagePixels, name_);
    f.width = static_cast<int>(width_);
    f.height = static_cast<int>(height_);
    if (!header_.names_matrix) f.matrix = usual_matrix(f.width, f.height);
    return header_;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw_bad_input(what, name_, where_); }
  [[noreturn]] void refuse_word(std::string_view word, const std::string& why) const {
    refuse("\"" + std::string(word) + "\" in the YUV4MPEG2 header: " + why);
  }

  void take(std::string_view word) {
    const std::string_view value = word.substr(1);
    switch (word.front()) {
      case 'W':
        return take_side(word, value, width_);
      case 'H':
        return take_side(word, value, height_);
      case 'F':
        return take_rate(word, value);
      case 'I':
        return take_fields(word, value);
      case 'A':
        return take_aspect(word, value);
      case 'C':
        if (!set_colours(value)) {
          refuse_word(word, "4:2:0, 4:2:2, 4:1:1, 4:4:4 and mono of 8 to 16 bits are read");
        }
        return;
      case 'X':
        return take_extension(word, value);
      default:
        refuse_word(word, "no such parameter");
    }
  }

  void take_side(std::string_view word, std::string_view value, std::int64_t& side) const {
    const char* const end = value.data() + value.size();
    const auto [stop, fault] = std::from_chars(value.data(), end, side);
    if (fault != std::errc() || stop != end || side < 0 || side > kLargestTerm) {
      refuse_word(word, "not a number of pixels");
    }
  }

  void take_rate(std::string_view word, std::string_view value) {
    const auto ratio = parse_ratio(value);
    if (!ratio) refuse_word(word, "not a rate such as 60000:1001");
    if (*ratio == std::pair<std::int64_t, std::int64_t>{0, 0}) return;  // unknown
    const auto [over, under] = *ratio;
    if (over == 0 || under == 0 || over / under > kMostHertz || under / over > kMostHertz) {
      refuse_word(word, "not a rate at which a film can run");
    }
    header_.rate = Rate{over, under}.reduced();
  }

  void take_fields(std::string_view word, std::string_view value) {
    FieldOrder& fields = header_.format.fields;
    if (value == "p" || value == "?") {
      fields = FieldOrder::kProgressive;
    } else if (value == "t") {
      fields = FieldOrder::kTopFirst;
    } else if (value == "b") {
      fields = FieldOrder::kBottomFirst;
    } else if (value == "m") {
      refuse_word(word,
                  "interlaced frames among others are not read; ffmpeg's bwdif makes all alike");
    } else {
      refuse_word(word, "p, t or b is the order of fields");
    }
  }

  void take_aspect(std::string_view word, std::string_view value) {
    const auto ratio = parse_ratio(value);
    if (!ratio) refuse_word(word, "not a shape of pixels such as 10:11");
    if (ratio->first == 0 || ratio->second == 0) return;  // unknown
    header_.pixel_aspect = static_cast<double>(ratio->first) / static_cast<double>(ratio->second);
  }

  void take_extension(std::string_view word, std::string_view value) {
    if (value == "COLORRANGE=FULL") header_.format.full_range = true;
    if (value == "COLORRANGE=LIMITED") header_.format.full_range = false;
    if (!value.starts_with("MATRIX=")) return;  // extensions of others say nothing to us
    if (value != "MATRIX=601" && value != "MATRIX=709") refuse_word(word, "601 or 709");
    header_.names_matrix = true;
    header_.format.matrix = value == "MATRIX=601" ? YuvMatrix::kBt601 : YuvMatrix::kBt709;
  }

  /// "420jpeg", "422p10", "mono16" and so on.
  bool set_colours(std::string_view value) {
    for (const Colours& colours : kColours) {
      if (!value.starts_with(colours.name)) continue;
      std::string_view depth = value.substr(colours.name.size());
      int bits = 8;
      if (!depth.empty()) {
        if (colours.layout == FrameLayout::kYuv) {
          if (depth.front() != 'p') continue;
          depth.remove_prefix(1);
        }
        const char* const end = depth.data() + depth.size();
        const auto [stop, fault] = std::from_chars(depth.data(), end, bits);
        if (fault != std::errc() || stop != end || bits < 9 || bits > 16) continue;
      }
      VideoFormat& f = header_.format;
      f.layout = colours.layout;
      f.bits = bits;
      f.chroma_across = colours.across;
      f.chroma_down = colours.down;
      f.blue_site = colours.blue;
      f.red_site = colours.red;
      // ffmpeg's deep 4:2:0 is MPEG-2's.
      if (colours.name == "420" && bits > 8) f.blue_site = f.red_site = {0, 0.5};
      return true;
    }
    return false;
  }

  std::string name_, where_;
  Header header_;
  std::int64_t width_ = 0, height_ = 0;
};

class Y4mReader : public VideoReader {
 public:
  Y4mReader(InputFile& file, Workers& workers, std::optional<YuvMatrix> matrix)
      : VideoReader(file, workers), matrix_(matrix) {
    const Header header = read_header(next_line("header"));
    format_ = header.format;
    rate_ = header.rate;
    pixel_aspect_ = header.pixel_aspect;
  }

  bool read(Image<Srgb8>& frame) override {
    if (file_.peek(1).empty()) return false;
    std::string line = next_line(place());
    if (is(line, kMagic)) {
      check_same(read_header(line));
      if (file_.peek(1).empty()) return false;
      line = next_line(place());
    }
    if (!is(line, kFrame))
      throw_bad_input("no FRAME where one should begin", file_.name(), place());
    read_frame(frame);
    return true;
  }

 private:
  static bool is(std::string_view line, std::string_view word) {
    return line.starts_with(word) && (line.size() == word.size() || line[word.size()] == ' ');
  }

  std::string next_line(const std::string& where) {
    std::string line;
    if (!file_.read_line(line, kLongestHeader)) {
      throw_bad_input("a YUV4MPEG2 film that is cut off or damaged: no end of a header line",
                      file_.name(), where);
    }
    return line;
  }

  Header read_header(const std::string& line) {
    if (!is(line, kMagic)) throw_bad_input("not a YUV4MPEG2 film", file_.name());
    Header header = HeaderParser(file_.name(), number_ == 0 ? "header" : place()).parse(line);
    if (matrix_) header.format.matrix = *matrix_;
    return header;
  }

  void check_same(const Header& now) const {
    const VideoFormat& a = format_;
    const VideoFormat& b = now.format;
    const auto size = [](const VideoFormat& f) {
      return std::to_string(f.width) + "x" + std::to_string(f.height);
    };
    if (a.width != b.width || a.height != b.height) {
      throw_bad_input("the film changes its size from " + size(a) + " to " + size(b), file_.name(),
                      place());
    }
    if (a != b) throw_bad_input("the film changes its format", file_.name(), place());
  }

  std::optional<YuvMatrix> matrix_;
};

}  // namespace

bool is_y4m(InputFile& file) {
  const auto ahead = file.peek(kMagic.size());
  return ahead.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), ahead.begin());
}

std::unique_ptr<VideoReader> read_y4m(InputFile& file, Workers& workers,
                                      std::optional<YuvMatrix> matrix) {
  return std::make_unique<Y4mReader>(file, workers, matrix);
}

}  // namespace kinescope
