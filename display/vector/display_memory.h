// The words that a display processor reads. A program may change them while they are displayed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace kinescope {

using Address = std::uint32_t;
using Word = std::uint32_t;

class DisplayMemory {
 public:
  explicit DisplayMemory(std::size_t words) : words_(words, 0) {}

  std::size_t size() const { return words_.size(); }
  /// More memory behind what there is; never less.
  void grow(std::size_t words) { words_.resize(std::max(words_.size(), words), 0); }
  std::span<Word> words() { return words_; }
  std::span<const Word> words() const { return words_; }
  /// Nothing where there is no memory.
  std::optional<Word> read(Address address) const {
    if (address >= words_.size()) return std::nullopt;
    return words_[address];
  }
  /// @throws Error (bad input) naming the address where there is no memory
  void write(Address address, Word word);
  void load(Address address, std::span<const Word> words);

 private:
  std::vector<Word> words_;
};

}  // namespace kinescope
