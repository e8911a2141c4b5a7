// What every fuzz target checks of a reader: hostile bytes give a value or one clear line, never
// anything else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

#include "raster/base/error.h"

namespace kinescope {

/// Calls read(bytes); an Error must be of bad input and one line of printable text. Every other
/// exception is a finding.
template <typename Read>
void fuzz_reader(const std::uint8_t* data, std::size_t size, Read&& read) {
  try {
    read(std::span<const std::uint8_t>(data, size));
  } catch (const Error& error) {
    const std::string line = error.what();
    if (line.empty() || error.kind() != ErrorKind::kBadInput) std::abort();
    for (const char c : line) {
      if (static_cast<unsigned char>(c) < 0x20) std::abort();
    }
  }
}

}  // namespace kinescope
