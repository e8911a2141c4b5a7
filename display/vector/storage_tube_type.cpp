#include "display/vector/storage_tube_type.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "display/data_lines.h"
#include "display/phosphor.h"
#include "raster/base/error.h"
#include "storage_tubes_txt.h"

namespace kinescope {
namespace {

using Type = StorageTubeType;

using Key = NumberKey<Type>;

constexpr std::array kNumbers{
    Key{"screen_mm", 10, 2000, [](Type& t, double v) { t.screen_mm = v; }},
    Key{"sigma_mm", 0.001, 50, [](Type& t, double v) { t.sigma_mm = v; }},
    Key{"threshold", 0.01, 0.99, [](Type& t, double v) { t.threshold = v; }},
    Key{"speed_mm_ms", 0.001, 1e9, [](Type& t, double v) { t.speed_mm_ms = v; }},
    Key{"flash", 0, 1000, [](Type& t, double v) { t.flash = v; }},
    Key{"background", 0, 1, [](Type& t, double v) { t.background = v; }},
    Key{"write_through", 0, 1, [](Type& t, double v) { t.write_through = v; }},
    Key{"erase_s", 0.001, 100, [](Type& t, double v) { t.erase = Seconds(v); }},
    Key{"erase_flash_s", 0, 100, [](Type& t, double v) { t.erase_flash = Seconds(v); }},
    Key{"fade_minutes", 0.01, 1e6, [](Type& t, double v) { t.half_contrast = Seconds(60 * v); }},
};

class TubeReader {
 public:
  explicit TubeReader(const std::string& file) : file_(file) {}

  std::vector<Type> read(std::string_view text) {
    for_each_data_line(text, [&](const Words& words, const std::string& where) {
      where_ = where;
      if (words.size() < 2) fail(words[0] + " lacks its value");
      if (words[0] == "tube") {
        tubes_.emplace_back();
        tubes_.back().name = words[1];
      } else if (tubes_.empty()) {
        fail("tube NAME must come first");
      } else {
        read_line(words, tubes_.back());
      }
    });
    return std::move(tubes_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw_bad_input(what, file_, where_); }

  double number(const Words& words, std::size_t i, double least, double most) const {
    return bounded_number(words, i, least, most, file_, where_);
  }

  void read_line(const Words& words, Type& tube) const {
    const std::string& key = words[0];
    if (set_number(kNumbers, tube, words, file_, where_)) {
      if (tube.erase_flash > tube.erase) fail("the flash outlasts the erasure");
    } else if (key == "size") {
      tube.width = static_cast<int>(number(words, 1, 2, 1 << 16));
      tube.height = static_cast<int>(number(words, 2, 2, 1 << 16));
    } else if (key == "settle_us") {
      tube.settle_us = number(words, 1, 0, 1e6);
      tube.settle_us_mm = number(words, 2, 0, 1e6);
    } else if (key == "note") {
      tube.note = words_after_key(words);
    } else if (key == "source") {
      tube.source += (tube.source.empty() ? "" : " ") + words_after_key(words);
    } else if (key == "phosphor") {
      tube.phosphor = words[1];
    } else {
      fail("\"" + key + "\" is not known");
    }
  }

  std::string file_, where_;
  std::vector<Type> tubes_;
};

}  // namespace

std::vector<Type> parse_storage_tubes(std::string_view text, const std::string& file) {
  return TubeReader(file).read(text);
}

std::span<const Type> storage_tube_types() {
  static const std::vector<Type> all =
      parse_storage_tubes(embedded::storage_tubes_txt(), "display/data/storage_tubes.txt");
  return all;
}

const Type& find_storage_tube(std::string_view name) {
  std::string names;
  for (const Type& type : storage_tube_types()) {
    if (type.name == name) return type;
    names += (names.empty() ? "" : ", ") + type.name;
  }
  throw Error(ErrorKind::kUsage, fmt::format("no storage tube \"{}\"; there are {}", name, names));
}

}  // namespace kinescope
