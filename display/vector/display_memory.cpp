#include "display/vector/display_memory.h"

#include <fmt/format.h>

#include <algorithm>

#include "raster/base/error.h"

namespace kinescope {

void DisplayMemory::write(Address address, Word word) { load(address, std::span(&word, 1)); }

void DisplayMemory::load(Address address, std::span<const Word> words) {
  if (address > words_.size() || words.size() > words_.size() - address) {
    throw_bad_input(fmt::format("{} words from address {} do not fit a memory of {}", words.size(),
                                address, words_.size()));
  }
  std::copy(words.begin(), words.end(), words_.begin() + address);
}

}  // namespace kinescope
