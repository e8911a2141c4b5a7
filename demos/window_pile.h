// The windows of a bitmap screen and its menu: a pile, of which the top one lies last in the list,
// drawn back to front.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "raster/image/image.h"
#include "raster/image/raster_op.h"

namespace kinescope {

struct ScreenWindow {
  std::string name;
  glm::ivec2 corner, size;
  std::size_t look;  ///< what is in it, and its title's colour
  PixelRect area() const { return {corner.x, corner.y, corner.x + size.x, corner.y + size.y}; }
};

class WindowPile {
 public:
  static constexpr int kTitle = 15;  ///< height of a title, pixels
  static constexpr std::size_t kMostWindows = 12;

  WindowPile();

  const std::vector<ScreenWindow>& windows() const { return windows_; }
  ScreenWindow& top() { return windows_.back(); }
  const ScreenWindow& top() const { return windows_.back(); }
  /// The top window there, as its place in the list.
  std::optional<std::size_t> at(glm::ivec2 p) const;
  void raise(std::size_t window);

  bool menu_is_open() const { return menu_.has_value(); }
  /// All of it on the screen. @param hit the window that its rows are for
  void open_menu(glm::ivec2 at, glm::ivec2 screen, std::optional<std::size_t> hit);
  void close_menu() { menu_.reset(); }
  std::optional<std::size_t> menu_row(glm::ivec2 p) const;
  /// Does what a row of the menu says.
  void choose(std::size_t row);

  /// @param mouse the row under it is inverted
  void draw_menu(Image<Srgb8>& screen, glm::ivec2 mouse) const;

 private:
  PixelRect menu_area() const;

  std::vector<ScreenWindow> windows_;
  std::optional<glm::ivec2> menu_;  // its corner
  std::optional<std::size_t> aimed_at_;
  std::size_t opened_ = 0;
};

void draw_window(Image<Srgb8>& screen, const ScreenWindow& window);
/// A frame of the window's size with its corner there.
void draw_outline(Image<Srgb8>& screen, const ScreenWindow& window, glm::ivec2 corner, RasterOp op);

}  // namespace kinescope
