// Decays of phosphors drawn: brightness against time on logarithmic scales, the published times
// beside them, and one type in words.
#pragma once

#include <span>
#include <string_view>

#include "demos/studio.h"
#include "demos/ui/canvas.h"
#include "display/phosphor_flash.h"

namespace kinescope {

/// A type and its light after the flash that all of a picture share.
struct FlashedType {
  const PhosphorType* type;
  FlashedSpot spot;
};

struct PhosphorChart {
  const Studio& studio;
  std::span<const FlashedType> types;
  const PhosphorType* chosen;  ///< drawn in front of the others, with its points; or none
  bool points = true;          ///< of every type, not of the chosen one alone

  /// @param now since the excitation ended, marked if above 0
  /// @param again when the next one begins
  void draw_curves(Canvas& canvas, const Rect& room, Seconds now, Seconds again) const;
  /// The chosen type: layers, times by table and law, source.
  void draw_words(Canvas& canvas, const Rect& room) const;

 private:
  void draw_grid(Canvas& canvas, const Rect& plot, float size) const;
  void draw_curve(Canvas& canvas, const Rect& plot, const FlashedType& flashed) const;
  void draw_points(Canvas& canvas, const Rect& plot, const FlashedType& flashed) const;
};

/// One phosphor's light as a patch of its colour, its name below.
void draw_patch(Image<Srgb8>& picture, const Studio& studio, const Rect& cell,
                std::string_view name, Srgb8 light, bool chosen);

/// A linear colour as a mark on the theme's dark ground: not too dark to be seen.
Srgb8 visible_colour(LinearRgb hue);

}  // namespace kinescope
