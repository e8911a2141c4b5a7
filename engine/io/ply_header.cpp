#include "engine/io/ply_header.h"

#include <array>
#include <string_view>
#include <utility>

#include "engine/io/text.h"

namespace kinescope {
namespace {

PlyType type_named(std::string_view name, const TextReader& text) {
  using Entry = std::pair<std::string_view, PlyType>;
  static constexpr std::array<Entry, 16> kTypes{{{"char", PlyType::kInt8},
                                                 {"int8", PlyType::kInt8},
                                                 {"uchar", PlyType::kUint8},
                                                 {"uint8", PlyType::kUint8},
                                                 {"short", PlyType::kInt16},
                                                 {"int16", PlyType::kInt16},
                                                 {"ushort", PlyType::kUint16},
                                                 {"uint16", PlyType::kUint16},
                                                 {"int", PlyType::kInt32},
                                                 {"int32", PlyType::kInt32},
                                                 {"uint", PlyType::kUint32},
                                                 {"uint32", PlyType::kUint32},
                                                 {"float", PlyType::kFloat32},
                                                 {"float32", PlyType::kFloat32},
                                                 {"double", PlyType::kFloat64},
                                                 {"float64", PlyType::kFloat64}}};
  for (const auto& [known, type] : kTypes) {
    if (known == name) return type;
  }
  text.fail("no PLY type of a property is called \"" + std::string(name.substr(0, 24)) + "\"");
}

PlyEncoding encoding_named(std::string_view name, const TextReader& text) {
  if (name == "ascii") return PlyEncoding::kAscii;
  if (name == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (name == "binary_big_endian") return PlyEncoding::kBigEndian;
  text.fail("no PLY format is called \"" + std::string(name.substr(0, 24)) + "\"");
}

PlyProperty read_property(TextReader& text) {
  PlyProperty property;
  std::string_view type = text.word_on_line();
  property.is_list = type == "list";
  if (property.is_list) {
    property.count_type = type_named(text.word_on_line(), text);
    type = text.word_on_line();
  }
  property.type = type_named(type, text);
  property.name = lower_case(text.word_on_line());
  return property;
}

/// Fewest bytes that one element takes.
std::uint64_t least_size(const PlyElement& element, PlyEncoding encoding) {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    // In text, a digit and the space after it.
    const std::size_t binary = size_of(property.is_list ? property.count_type : property.type);
    bytes += encoding == PlyEncoding::kAscii ? 2 : binary;
  }
  return bytes;
}

void check_counts(PlyHeader& header, const ModelFile& file) {
  const std::uint64_t left = file.bytes.size() - header.data_offset + 1;
  for (PlyElement& element : header.elements) {
    const std::uint64_t least = least_size(element, header.encoding);
    // Without properties, nothing of it stands in the file.
    if (least == 0) element.count = 0;
    if (least != 0 && element.count > left / least) {
      file.fail("the file ends too early: its header promises " + std::to_string(element.count) +
                " of " + element.name);
    }
  }
}

}  // namespace

std::size_t size_of(PlyType type) {
  static constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(const ModelFile& file) {
  PlyHeader header;
  TextReader text(file, 0);
  bool has_format = false;
  while (text.next_line()) {
    const std::string_view key = text.word_on_line();
    if (key == "end_header") {
      if (!has_format) text.fail("the PLY header names no format");
      text.next_line();
      header.data_offset = text.offset();
      check_counts(header, file);
      return header;
    }
    if (key == "format") {
      header.encoding = encoding_named(text.word_on_line(), text);
      has_format = true;
    } else if (key == "element") {
      const std::string name(text.word_on_line());
      for (const PlyElement& other : header.elements) {
        if (other.name == name) text.fail("an element is named twice");
      }
      header.elements.push_back({name, text.count(text.word_on_line(), "a count"), {}});
    } else if (key == "property") {
      if (header.elements.empty()) text.fail("a property comes before any element");
      header.elements.back().properties.push_back(read_property(text));
    } else if (key == "comment" && text.word_on_line() == "TextureFile") {
      header.texture_file = text.rest_of_line();
    }
  }
  text.fail("the PLY header has no end");
}

}  // namespace kinescope
