// Where error diffusion carries a pixel's error, and in what shares.
#pragma once

#include <array>
#include <string_view>

namespace kinescope {

struct DiffusionKernel {
  struct Tap {
    int dx, dy, weight;  ///< dx along the direction of the scan
  };
  std::string_view name;
  int divisor;
  int count;
  std::array<Tap, 12> taps;
};

/// R. W. Floyd and L. Steinberg, "An adaptive algorithm for spatial grey scale", 1976.
inline constexpr DiffusionKernel kFloydSteinberg{
    "Floyd-Steinberg", 16, 4, {{{1, 0, 7}, {-1, 1, 3}, {1, 1, 1}, {0, 1, 5}}}};

/// J. F. Jarvis, C. N. Judice and W. H. Ninke, "A survey of techniques for the display of
/// continuous tone pictures on bilevel displays", 1976.
inline constexpr DiffusionKernel kJarvis{"Jarvis",
                                         48,
                                         12,
                                         {{{1, 0, 7},
                                           {2, 0, 5},
                                           {-2, 1, 3},
                                           {-1, 1, 5},
                                           {1, 1, 5},
                                           {2, 1, 3},
                                           {-2, 2, 1},
                                           {-1, 2, 3},
                                           {0, 2, 5},
                                           {1, 2, 3},
                                           {2, 2, 1},
                                           {0, 1, 7}}}};

/// B. Atkinson, for the Macintosh, 1984: a quarter of the error is dropped, which keeps light and
/// dark areas clean.
inline constexpr DiffusionKernel kAtkinson{
    "Atkinson", 8, 6, {{{1, 0, 1}, {2, 0, 1}, {-1, 1, 1}, {1, 1, 1}, {0, 2, 1}, {0, 1, 1}}}};

}  // namespace kinescope
