// A std::vector whose data begins on a cache line, for SIMD loads and stores.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace kinescope {

template <typename T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kAlignment{64};

  CacheLineAllocator() = default;
  template <typename U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), kAlignment));
  }
  void deallocate(T* data, std::size_t) { ::operator delete(data, kAlignment); }
  bool operator==(const CacheLineAllocator&) const { return true; }
};

template <typename T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

/// The least number of elements, at least `count`, that fill whole cache lines.
template <typename T>
constexpr int whole_cache_lines(int count) {
  constexpr int kInLine =
      static_cast<int>(static_cast<std::size_t>(CacheLineAllocator<T>::kAlignment) / sizeof(T));
  return (count + kInLine - 1) / kInLine * kInLine;
}

}  // namespace kinescope

// Compiled once, and optimized, whoever copies one.
extern template class std::vector<float, kinescope::CacheLineAllocator<float>>;
