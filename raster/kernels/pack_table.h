// Which lanes a mask of eight chooses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kinescope {

/// Of each mask, bit 0 for the first lane: the chosen lanes in order, then zeros.
inline constexpr auto kChosenLanes = [] {
  std::array<std::array<std::uint8_t, 8>, 256> table{};
  for (std::size_t mask = 0; mask < 256; ++mask) {
    std::size_t n = 0;
    for (std::uint8_t lane = 0; lane < 8; ++lane) {
      if (mask >> lane & 1) table[mask][n++] = lane;
    }
  }
  return table;
}();

/// Of each mask and lane: how many lanes before it the mask chooses.
inline constexpr auto kBitsBefore = [] {
  std::array<std::array<std::uint8_t, 8>, 256> table{};
  for (std::size_t mask = 0; mask < 256; ++mask) {
    for (std::size_t lane = 1; lane < 8; ++lane) {
      table[mask][lane] =
          static_cast<std::uint8_t>(table[mask][lane - 1] + (mask >> (lane - 1) & 1));
    }
  }
  return table;
}();

}  // namespace kinescope
