// Operands of instructions: checked, and packed into words.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string_view>

#include "display/vector/display_memory.h"
#include "raster/base/error.h"

namespace kinescope {

/// The lowest `bits` bits. @throws Error (bad input) if the value does not fit
inline Word unsigned_field(std::int64_t value, int bits) {
  const std::int64_t most = (std::int64_t{1} << bits) - 1;
  if (value < 0 || value > most)
    throw_bad_input(fmt::format("{} must lie from 0 to {}", value, most));
  return static_cast<Word>(value);
}

/// Two's complement.
inline Word signed_field(std::int64_t value, int bits) {
  const std::int64_t half = std::int64_t{1} << (bits - 1);
  if (value < -half || value >= half) {
    throw_bad_input(fmt::format("{} must lie from {} to {}", value, -half, half - 1));
  }
  return static_cast<Word>(value) & ((Word{1} << bits) - 1);
}

/// A field of a word, and one that is in two's complement.
inline int field(Word word, int shift, int bits) {
  return static_cast<int>((word >> shift) & ((Word{1} << bits) - 1));
}
inline int signed_field_of(Word word, int shift, int bits) {
  const int value = field(word, shift, bits), half = 1 << (bits - 1);
  return value >= half ? value - 2 * half : value;
}

inline void expect_operands(std::string_view name, std::size_t got, std::size_t want) {
  if (got != want) throw_bad_input(fmt::format("{} takes {} operands, not {}", name, want, got));
}

}  // namespace kinescope
