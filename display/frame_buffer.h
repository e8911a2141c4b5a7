// The frame buffer: bit planes or true colour, and the colour table, that the video controller
// scans out. It holds gun drive; the tube's gamma makes the light.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "raster/colour/colour.h"
#include "raster/image/image.h"

namespace kinescope {

/// Bits a pixel; 8 and below are indices into the colour table. 16 is 5-6-5.
enum class PixelFormat { kIndexed1, kIndexed2, kIndexed4, kIndexed8, kRgb565, kRgb888, kXrgb8888 };
int bits_per_pixel(PixelFormat format);

/// Drive of the three guns, 0 to 255.
struct GunDrive {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const GunDrive&) const = default;
};

class FrameBuffer {
 public:
  FrameBuffer(int width, int height, PixelFormat format, int pages = 2);

  int width() const { return width_; }
  int height() const { return height_; }
  PixelFormat format() const { return format_; }
  int pages() const { return static_cast<int>(pages_.size()); }
  int visible_page() const { return visible_page_; }
  int hidden_page() const { return (visible_page_ + 1) % pages(); }
  /// Bytes a line, and a page's memory as the controller reads it: lines from the top, pixels from
  /// the left, the leftmost pixel in the highest bits of a byte; 16 and more bits little-endian.
  int pitch_bytes() const { return pitch_; }
  std::span<std::uint8_t> memory(int page) { return pages_[static_cast<std::size_t>(page)]; }

  /// Stores a table index, or a true colour packed as the format has it.
  void set_pixel(int page, int x, int y, std::uint32_t value);
  std::uint32_t pixel(int page, int x, int y) const;
  /// Stores a picture of the buffer's size: true-colour formats only.
  void store(int page, const Image<Srgb8>& picture);

  /// Changes a table entry now, from whatever line the beam is on.
  void set_colour(int index, GunDrive drive);
  GunDrive colour(int index) const { return table_[static_cast<std::size_t>(index)]; }
  /// Changes a table entry on every frame as `line` begins (a line of 0 is the frame's start); the
  /// entry returns to its own colour at the next frame's start. Calls add up until cleared.
  void set_colour_at_line(int line, int index, GunDrive drive);
  void clear_line_changes();

  /// Shows `page` from the next vertical retrace on.
  void flip_at_retrace(int page);
  /// Shows `page` at once: the lines not yet scanned come from it (a tear).
  void flip_now(int page);
  /// The controller calls this as vertical retrace begins: carries out a flip that waits.
  void vertical_retrace();

  /// Gun drive of one line of the visible page, the table as it stands on that line.
  void read_line(int line, std::span<GunDrive> out) const;

 private:
  struct LineChange {
    int line, index;
    GunDrive drive;
  };
  int width_, height_;
  PixelFormat format_;
  int pitch_ = 0;
  std::vector<std::vector<std::uint8_t>> pages_;
  std::array<GunDrive, 256> table_{};
  std::vector<LineChange> line_changes_;  // sorted by line, stable
  int visible_page_ = 0;
  std::optional<int> waiting_page_;
};

}  // namespace kinescope
