// Text: glyph outlines through FreeType, scan-converted by exact area.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "raster/image/image.h"
#include "raster/path/path.h"

namespace kinescope {

/// A scalable font. Not for use by several threads at once.
class Font {
 public:
  /// @param bytes a TrueType or OpenType file; must outlive the font. @throws Error (bad input)
  explicit Font(std::span<const std::uint8_t> bytes);
  ~Font();
  Font(Font&&) noexcept;
  Font& operator=(Font&&) noexcept;

  /// The fonts linked into the program: DejaVu Sans and DejaVu Sans Mono.
  static Font sans();
  static Font mono();

  /// Width of a line of UTF-8 text, pixels.
  float width_px(std::string_view text, float size_px) const;
  float ascent_px(float size_px) const;
  float line_height_px(float size_px) const;

  /// A character's outline in the font's own units, y upwards, not hinted; that of the font's mark
  /// for missing characters if it lacks it.
  Path outline(char32_t code) const;
  /// A line of UTF-8 text in the font's own units from a pen at the origin, each character at
  /// the width of what stands before it.
  Path line_outline(std::string_view text) const;
  float units_per_em() const;

  /// Draws one line with its baseline starting at (x, y), blended in linear light, clipped.
  /// @return the pen's x after the text
  float draw(Image<Srgb8>& picture, float x_px, float y_px, std::string_view text, float size_px,
             Srgb8 colour) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kinescope
