// How everything that is drawn over a picture looks: colours, sizes, spacing.
#pragma once

#include "raster/colour/colour.h"

namespace kinescope::theme {

inline constexpr Srgb8 kBackground{14, 15, 18, 255};
inline constexpr Srgb8 kPanel{20, 22, 27, 242};
inline constexpr Srgb8 kRule{255, 255, 255, 26};
inline constexpr Srgb8 kKeyCap{52, 56, 66, 255};
inline constexpr Srgb8 kText{236, 234, 226, 255};
inline constexpr Srgb8 kDim{156, 158, 160, 255};
inline constexpr Srgb8 kAccent{255, 178, 72, 255};  // the amber of a terminal
inline constexpr Srgb8 kAccentDark{64, 46, 22, 255};
inline constexpr Srgb8 kCool{104, 190, 255, 255};
inline constexpr Srgb8 kRed{255, 104, 92, 255};
inline constexpr Srgb8 kGreen{112, 220, 128, 255};
inline constexpr Srgb8 kBlue{110, 150, 255, 255};

/// Sizes in pixels at a window height of kReferenceHeight; they grow with the window.
inline constexpr float kReferenceHeight = 960;
inline constexpr float kTitle = 24, kBody = 15.5f, kSmall = 13;
inline constexpr float kMargin = 16, kGap = 8, kRadius = 9;
/// At a window's foot stands its own line, no higher than this.
inline constexpr float kWindowLine = 42;

/// Factor on every size for a picture of that height. A screen of 720 lines is read from as near as
/// one of 960: there type is hardly smaller.
constexpr float scale_for(int height_px) {
  const float scale = static_cast<float>(height_px) / kReferenceHeight;
  if (scale < 0.5f) return scale < 0.3f ? 0.3f : scale;
  if (scale < 0.75f) return 0.5f + 1.5f * (scale - 0.5f);
  if (scale < 1) return 0.875f + 0.5f * (scale - 0.75f);
  return scale > 4 ? 4 : scale;
}

constexpr Srgb8 with_alpha(Srgb8 colour, std::uint8_t alpha) {
  return {colour.r, colour.g, colour.b, alpha};
}

}  // namespace kinescope::theme
