#include "display/vector/input/xml.h"

#include <expat.h>

#include <memory>

#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr std::size_t kMostDepth = 200;
constexpr std::size_t kMostText = 1 << 16;  ///< kept of one element

std::string_view without_prefix(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

struct Builder {
  XML_Parser parser = nullptr;
  XmlElement root;
  std::vector<XmlElement> open;  ///< from the root to where the parser is
  const char* fault = nullptr;

  void stop(const char* why) {
    if (!fault) fault = why;
    XML_StopParser(parser, XML_FALSE);
  }
};

void XMLCALL start(void* user, const XML_Char* name, const XML_Char** attributes) {
  auto& builder = *static_cast<Builder*>(user);
  if (builder.fault) return;
  if (builder.open.size() >= kMostDepth) return builder.stop("elements are nested too deep");
  XmlElement element;
  element.name = without_prefix(name);
  for (; attributes[0]; attributes += 2) {
    element.attributes.emplace_back(without_prefix(attributes[0]), attributes[1]);
  }
  builder.open.push_back(std::move(element));
}

void XMLCALL end(void* user, const XML_Char*) {
  auto& builder = *static_cast<Builder*>(user);
  if (builder.fault || builder.open.empty()) return;
  XmlElement done = std::move(builder.open.back());
  builder.open.pop_back();
  if (builder.open.empty()) {
    builder.root = std::move(done);
  } else {
    builder.open.back().children.push_back(std::move(done));
  }
}

void XMLCALL characters(void* user, const XML_Char* text, int length) {
  auto& builder = *static_cast<Builder*>(user);
  if (builder.fault || builder.open.empty()) return;
  std::string& to = builder.open.back().text;
  if (to.size() < kMostText) to.append(text, static_cast<std::size_t>(length));
}

[[noreturn]] void fail(const Builder& builder, const std::string& name) {
  const char* why =
      builder.fault ? builder.fault : XML_ErrorString(XML_GetErrorCode(builder.parser));
  throw_bad_input(std::string("is no sound XML: ") + why, name,
                  "line " + std::to_string(XML_GetCurrentLineNumber(builder.parser)));
}

}  // namespace

std::string_view XmlElement::attribute(std::string_view wanted) const {
  for (const auto& [key, value] : attributes) {
    if (key == wanted) return value;
  }
  return {};
}

XmlElement parse_xml(std::span<const std::uint8_t> bytes, const std::string& name) {
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr),
                                                                       XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Builder builder;
  builder.parser = parser.get();
  XML_SetUserData(parser.get(), &builder);
  XML_SetElementHandler(parser.get(), start, end);
  XML_SetCharacterDataHandler(parser.get(), characters);
  constexpr std::size_t kPiece = 1 << 20;
  for (std::size_t at = 0;; at += kPiece) {
    const bool last = bytes.size() - at <= kPiece;
    const std::size_t size = last ? bytes.size() - at : kPiece;
    const auto* text = reinterpret_cast<const char*>(bytes.data() + at);
    if (XML_Parse(parser.get(), text, static_cast<int>(size), last) != XML_STATUS_OK ||
        builder.fault) {
      fail(builder, name);
    }
    if (last) return std::move(builder.root);
  }
}

}  // namespace kinescope
