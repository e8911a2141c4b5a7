#include "bench/svg_fills.h"

#include <zlib.h>

#include <array>
#include <cstdio>
#include <optional>
#include <string_view>

#include "raster/base/error.h"
#include "raster/path/svg_path.h"

namespace kinescope::bench {
namespace {

/// zlib reads plain files as they are.
std::string read_text(const std::string& path) {
  const gzFile file = gzopen(path.c_str(), "rb");
  if (!file) throw_bad_input("cannot be opened", path);
  std::string text;
  std::array<char, 65536> part;
  int count = 0;
  while ((count = gzread(file, part.data(), part.size())) > 0) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  gzclose(file);
  if (count < 0) throw_bad_input("is not a whole gzip file", path);
  return text;
}

std::optional<std::string> attribute(std::string_view tag, const std::string& name) {
  for (std::size_t at = 0; (at = tag.find(name + "=\"", at)) != std::string_view::npos; ++at) {
    const char before = at > 0 ? tag[at - 1] : ' ';
    if (before != ' ' && before != '\n' && before != '\t') continue;
    const std::size_t begin = at + name.size() + 2;
    return std::string(tag.substr(begin, tag.find('"', begin) - begin));
  }
  return std::nullopt;
}

std::optional<LinearRgba> colour(const std::string& text) {
  int r = 0, g = 0, b = 0;
  if (std::sscanf(text.c_str(), "rgb(%d,%d,%d)", &r, &g, &b) != 3) return std::nullopt;
  const auto channel = [](int code) { return static_cast<float>(code) / 255; };
  return LinearRgba{channel(r), channel(g), channel(b), 1};
}

PixelsFromPath product(const PixelsFromPath& a, const PixelsFromPath& b) {
  return {a * glm::vec3(b[0], 0), a * glm::vec3(b[1], 0), a * glm::vec3(b[2], 1)};
}

PixelsFromPath transform(const std::string& text) {
  float m[6]{1, 0, 0, 1, 0, 0};
  if (std::sscanf(text.c_str(), "matrix(%f,%f,%f,%f,%f,%f)", m, m + 1, m + 2, m + 3, m + 4,
                  m + 5) != 6) {
    std::sscanf(text.c_str(), "translate(%f,%f)", m + 4, m + 5);
  }
  return {m[0], m[1], m[2], m[3], m[4], m[5]};
}

struct Group {
  PixelsFromPath place{1, 0, 0, 1, 0, 0};
  std::optional<LinearRgba> fill = LinearRgba{0, 0, 0, 1};
  FillRule rule = FillRule::kNonZero;
};

void inherit(std::string_view tag, Group& group) {
  if (const auto text = attribute(tag, "fill")) group.fill = colour(*text);
  if (const auto text = attribute(tag, "transform")) {
    group.place = product(group.place, transform(*text));
  }
  if (const auto text = attribute(tag, "fill-rule")) {
    group.rule = *text == "evenodd" ? FillRule::kEvenOdd : FillRule::kNonZero;
  }
}

}  // namespace

SvgFills read_svg_fills(const std::string& path) {
  const std::string text = read_text(path);
  SvgFills svg;
  std::vector<Group> groups(1);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) throw_bad_input("ends within a tag", path);
    const std::string_view tag = std::string_view(text).substr(at + 1, end - at - 1);
    const std::string_view name = tag.substr(0, tag.find_first_of(" \n\t/", 1));
    at = end;
    if (name == "svg" || name == "g") {
      groups.push_back(groups.back());
      inherit(tag, groups.back());
      float box[4]{};
      if (const auto view = attribute(tag, "viewBox")) {
        std::sscanf(view->c_str(), "%f %f %f %f", box, box + 1, box + 2, box + 3);
        svg.size = {box[2], box[3]};
      }
      if (tag.back() == '/') groups.pop_back();
    } else if ((name == "/svg" || name == "/g") && groups.size() > 1) {
      groups.pop_back();
    } else if (name == "path") {
      Group own = groups.back();
      inherit(tag, own);
      const auto data = attribute(tag, "d");
      if (!own.fill || !data) continue;
      svg.paths.push_back(parse_svg_path(*data));
      svg.fills.push_back({&svg.paths.back(), own.place, own.rule, {*own.fill}});
    }
  }
  if (svg.fills.empty() || !(svg.size.x > 0 && svg.size.y > 0)) {
    throw_bad_input("holds no view box and filled paths", path);
  }
  return svg;
}

}  // namespace kinescope::bench
