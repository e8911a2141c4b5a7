#include "demos/palette_course.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "raster/dither/palette_dither.h"

namespace kinescope {
namespace {

/// A field for each entry; those that a cut changed are drawn anew.
void show_changes(Track& track, const Image<Srgb8>& picture, int colours, const Palette& before,
                  const Palette& now) {
  const int side = static_cast<int>(std::ceil(std::sqrt(colours)));
  const int width = picture.width() / side, height = picture.height() / side;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (i < before.size() && before[i] == now[i]) continue;
    const int left = static_cast<int>(i) % side * width, top = static_cast<int>(i) / side * height;
    for (int y = top; y < top + height; ++y) track.span({y, left, left + width}, now[i]);
  }
}

Track rows(const char* name, int pane, const Image<std::uint8_t>& entries, const Palette& palette) {
  Track track(name, {}, pane);
  for (int y = 0; y < entries.height(); ++y) {
    for (int x = 0; x < entries.width(); ++x) track.plot(x, y, palette[entries.at(x, y)]);
    track.step({});
  }
  return track;
}

}  // namespace

Course palette_course(const Image<Srgb8>& picture, int colours) {
  MedianCut cut(picture, colours);
  Course course;
  course.papers = {picture};
  Track boxes("boxes of colours", {"boxes"}, 1);
  Palette palette;
  do {
    const Palette before = std::exchange(palette, cut.palette());
    show_changes(boxes, picture, colours, before, palette);
    boxes.step({double(cut.boxes().size())});
  } while (cut.next());
  course.tracks.push_back(Track("photograph", {}, 0));
  course.tracks.push_back(std::move(boxes));
  course.tracks.push_back(rows("nearest", 2, to_palette(picture, palette), palette));
  course.tracks.push_back(rows("diffused", 3, diffuse_to_palette(picture, palette), palette));
  course.remarks.push_back(fmt::format("{} colours of the 16777216", palette.size()));
  return course;
}

}  // namespace kinescope
