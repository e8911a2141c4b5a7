#include "demos/lesson/lesson_screen.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "demos/ui/theme.h"
#include "display/tube/preset.h"

namespace kinescope {
namespace {

// Tubes whose raster fills a flat glass, so that guides and handles lie where the beam draws.
constexpr std::array kPresets = {"vga-colour", "vga-green", "vga-white"};
constexpr int kGridFrom = 8;  // screen pixels a side of cells that show their borders

TubeSettings tube(int display) {
  return find_tube_preset(kPresets[static_cast<std::size_t>(display)]).settings;
}

}  // namespace

const std::vector<std::string>& LessonScreen::names() {
  static const std::vector<std::string> kNames = {"colour tube", "green tube", "white tube",
                                                  "flat"};
  return kNames;
}

LessonScreen::LessonScreen(const Rect& room)
    : monitor_(tube(0), PixelFormat::kXrgb8888, room),
      shown_(std::make_shared<Image<Srgb8>>(World::kScreenWidth, World::kScreenHeight)) {}

bool LessonScreen::flat() const { return display_ == static_cast<int>(kPresets.size()); }

void LessonScreen::choose(int display, Seconds now) {
  if (display == display_) return;
  display_ = display;
  if (flat()) return monitor_.switch_off();
  monitor_.adjust(tube(display), now);
  waits_ = true;
}

void LessonScreen::show(const World& world, const std::vector<Image<Srgb8>>& panes) {
  auto screen = std::make_shared<Image<Srgb8>>(World::kScreenWidth, World::kScreenHeight);
  const int cell = world.cell, drawn = cell >= kGridFrom ? cell - 1 : cell;
  for (int pane = 0; pane < static_cast<int>(panes.size()); ++pane) {
    const Image<Srgb8>& picture = panes[static_cast<std::size_t>(pane)];
    const glm::ivec2 corner = world.corner(pane);
    for (int y = 0; y < picture.height() * cell; ++y) {
      if (y % cell >= drawn) continue;
      Srgb8* row = screen->row(corner.y + y) + corner.x;
      const Srgb8* cells = picture.row(y / cell);
      for (int x = 0; x < picture.width(); ++x) std::fill_n(row + x * cell, drawn, cells[x]);
    }
  }
  shown_ = std::move(screen);
  waits_ = true;
}

void LessonScreen::draw(const Step& step, Workers& workers, Image<Srgb8>& picture) {
  if (flat()) return draw_flat(workers, picture);
  if (monitor_.frame_begins(step) && waits_) {
    monitor_.show(*shown_);
    waits_ = false;
  }
  monitor_.expose(step, workers, picture);
}

void LessonScreen::draw_flat(Workers& workers, Image<Srgb8>& picture) const {
  const int left = static_cast<int>(face().x), top = static_cast<int>(face().y);
  const int width = std::min(static_cast<int>(face().width), picture.width() - left);
  const int height = std::min(static_cast<int>(face().height), picture.height() - top);
  run_rows(workers, height, [&](int y) {
    const Srgb8* in = shown_->row(y * World::kScreenHeight / static_cast<int>(face().height));
    Srgb8* out = picture.row(top + y) + left;
    for (int x = 0; x < width; ++x) {
      out[x] = in[x * World::kScreenWidth / static_cast<int>(face().width)];
    }
  });
}

LessonScreen::Spot LessonScreen::spot(const World& world, int x, int y) const {
  const Spot whole = spot_in(world, 0, x, y);
  const auto part = [](double at, int cell, int size, int panes) {
    return std::clamp(static_cast<int>(std::floor(at * cell * panes / size)), 0, panes - 1);
  };
  const int column = part(whole.at.x, world.cell, World::kScreenWidth, world.panes.x);
  const int row = part(whole.at.y, world.cell, World::kScreenHeight, world.panes.y);
  return spot_in(world, row * world.panes.x + column, x, y);
}

LessonScreen::Spot LessonScreen::spot_in(const World& world, int pane, int x, int y) const {
  const glm::dvec2 on_face(x + 0.5 - double(face().x), y + 0.5 - double(face().y));
  const glm::dvec2 on_screen = on_face / glm::dvec2(face().width, face().height) *
                               glm::dvec2(World::kScreenWidth, World::kScreenHeight);
  return {pane, (on_screen - glm::dvec2(world.corner(pane))) / double(world.cell)};
}

glm::vec2 LessonScreen::place(const World& world, const Spot& spot) const {
  const glm::dvec2 on_screen = glm::dvec2(world.corner(spot.pane)) + spot.at * double(world.cell);
  return {face().x + static_cast<float>(on_screen.x / World::kScreenWidth) * face().width,
          face().y + static_cast<float>(on_screen.y / World::kScreenHeight) * face().height};
}

}  // namespace kinescope
