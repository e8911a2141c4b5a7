// The header of a PLY file: its elements and their properties, in the order of the data.
// Source: Turk, "The PLY Polygon File Format", 1994.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/io/reader.h"

namespace kinescope {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };
std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;  ///< of the value, or of a list's entries
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::string texture_file;     ///< of a comment "TextureFile NAME", as scanners' tools write it
  std::size_t data_offset = 0;  ///< bytes
};

/// @throws Error naming the line; also where an element's count cannot fit into the file
PlyHeader read_ply_header(const ModelFile& file);

}  // namespace kinescope
