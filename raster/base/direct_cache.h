// A small cache of values that are dear to find again: a key has one place, whoever comes last
// has it. It never grows, and allocates nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kinescope {

template <typename Value, std::size_t kPlaces>
class DirectCache {
  static_assert((kPlaces & (kPlaces - 1)) == 0 && kPlaces >= 2);

 public:
  /// The value of a key, made by make() unless it is at hand; good until the next call.
  /// @param key less than 2^64 - 1
  template <typename Make>
  Value& get(std::uint64_t key, Make&& make) {
    Entry& entry = entries_[place(key)];
    if (entry.key != key) [[unlikely]]
      fill(entry, key, make);
    return entry.value;
  }

 private:
  static constexpr std::uint64_t kNone = ~std::uint64_t{0};
  struct Entry {
    std::uint64_t key = kNone;
    Value value{};
  };
  /// Apart, so that what is at hand needs few registers.
  template <typename Make>
  [[gnu::noinline]] static void fill(Entry& entry, std::uint64_t key, Make& make) {
    entry.value = make();
    entry.key = key;
  }
  /// Fibonacci hashing. Source: D. E. Knuth, "The Art of Computer Programming", vol. 3, 6.4.
  static std::size_t place(std::uint64_t key) {
    return static_cast<std::size_t>(key * 0x9e3779b97f4a7c15u >> 40) & (kPlaces - 1);
  }
  std::array<Entry, kPlaces> entries_;
};

}  // namespace kinescope
