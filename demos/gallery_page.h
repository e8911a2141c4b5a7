// The gallery's page: which demos a search finds, under headings of their chapters, and where each
// lies on a page that scrolls.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "demos/demo.h"
#include "demos/ui/canvas.h"

namespace kinescope {

/// Whether each word is part of the name, chapter, summary or a topic; letters' case counts not.
bool found_by(const DemoInfo& info, std::string_view words);

/// Chapters by their number, those without one last; demos of a chapter in the registry's order.
std::vector<std::size_t> in_order_of_chapters(std::span<const DemoInfo> demos);

class GalleryPage {
 public:
  struct Chapter {
    std::string_view name;
    std::size_t first = 0, count = 0;  ///< places of its demos
    float top = 0;                     ///< of its heading, from the top of the page, pixels
  };

  GalleryPage(std::span<const DemoInfo> demos, int width, int height);

  /// Shows the demos that the words find; all of them if there are none.
  void find(std::string_view words);
  void resize(int width, int height);

  /// Demos by place, from the first on the page to the last.
  std::span<const std::size_t> shown() const { return shown_; }
  std::span<const Chapter> chapters() const { return chapters_; }
  std::size_t chapter_of(std::size_t place) const;

  // In pixels of the window.
  float scale() const { return scale_; }
  Rect header() const;
  Rect rail() const;  ///< of the chapters' names; of no width where there is no room
  Rect room() const;  ///< of the page itself
  Rect rail_entry(std::size_t chapter) const;
  Rect heading(std::size_t chapter) const;
  Rect cell(std::size_t place) const;
  Rect thumbnail(std::size_t place) const;
  std::optional<std::size_t> place_at(int x, int y) const;
  std::optional<std::size_t> chapter_at(int x, int y) const;  ///< of the rail
  float row_height() const;

  void scroll_by(float pixels);
  void scroll_to_chapter(std::size_t chapter);
  /// Scrolls no farther than it must.
  void reveal(std::size_t place);
  /// The place so many rows lower or, if negative, higher; of those at the page's ends, themselves.
  std::size_t beside(std::size_t place, int rows) const;
  int rows_in_view() const;

 private:
  void lay_out();
  Rect on_page(std::size_t place) const;
  float farthest() const;

  std::span<const DemoInfo> demos_;
  std::vector<std::size_t> order_, shown_;
  std::vector<Chapter> chapters_;
  int width_, height_;
  std::size_t columns_ = 1;
  float scale_ = 1, cell_width_ = 1, left_ = 0, scroll_ = 0, length_ = 0;
};

}  // namespace kinescope
