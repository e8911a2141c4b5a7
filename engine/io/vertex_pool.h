// Gives equal positions one number.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <unordered_map>

namespace kinescope {

class VertexPool {
 public:
  /// The number of a position: as many as there were others before.
  std::uint32_t index_of(glm::vec3 position) {
    position += glm::vec3(0.0f);  // turns -0 into 0
    const auto key = std::bit_cast<Bits>(position);
    return known_.try_emplace(key, static_cast<std::uint32_t>(known_.size())).first->second;
  }
  std::size_t size() const { return known_.size(); }

 private:
  using Bits = std::array<std::uint32_t, 3>;
  struct Hash {
    std::size_t operator()(const Bits& bits) const {
      std::uint64_t hash = 0;
      for (const std::uint32_t word : bits) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
      }
      return static_cast<std::size_t>(hash);
    }
  };
  std::unordered_map<Bits, std::uint32_t, Hash> known_;
};

}  // namespace kinescope
