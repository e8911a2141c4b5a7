// XML into a tree. The only file behind which expat stands is xml.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kinescope {

/// An element: prefixes of names are dropped. Text stands with the element that holds it.
struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text;
  std::vector<XmlElement> children;

  /// Empty if there is none.
  std::string_view attribute(std::string_view wanted) const;
};

/// The root element. Nothing outside the bytes is read; entities that multiply are refused (expat
/// does, past 8 MiB and a hundredfold), and so is nesting deeper than 200.
/// @throws Error (bad input) with the line
XmlElement parse_xml(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace kinescope
