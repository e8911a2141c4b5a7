// Numbers out of glTF's buffers, every bound checked.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/io/reader.h"

namespace kinescope {

/// An accessor's numbers, element after element.
struct GltfNumbers {
  int components = 0;  ///< of an element
  std::size_t count = 0;
  std::vector<float> values;
};

class GltfAccessors {
 public:
  GltfAccessors(const tinygltf::Model& model, const ModelFile& file);

  /// Floats, or integers that become floats (of 0 to 1 or -1 to 1 where the accessor is
  /// normalized). Kept, since primitives share accessors.
  /// @throws Error naming the accessor
  const GltfNumbers& floats(int accessor);

  /// Unsigned integers.
  std::vector<std::uint32_t> indices(int accessor) const;

  /// The bytes of a buffer view; none where it leaves its buffer.
  std::span<const std::uint8_t> bytes_of_view(int view) const;

  /// Bytes of the file and of all its buffers: what a claimed number is measured by.
  std::uint64_t total_bytes() const { return total_bytes_; }

 private:
  const tinygltf::Accessor& checked(int accessor) const;
  template <typename Sink>
  void visit(int accessor, const Sink& sink) const;
  template <typename Sink>
  void visit_sparse(const tinygltf::Accessor& accessor, const std::string& where,
                    const Sink& sink) const;

  const tinygltf::Model& model_;
  const ModelFile& file_;
  std::uint64_t total_bytes_;
  std::uint64_t decoded_ = 0;  ///< numbers
  std::map<int, GltfNumbers> floats_;
};

}  // namespace kinescope
