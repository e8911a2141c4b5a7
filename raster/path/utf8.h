// UTF-8 to code points. Source: Unicode 15, table 3-7.
#pragma once

#include <cstddef>
#include <string_view>

namespace kinescope {

/// Calls sink(code point) for each character; a byte that fits into none gives U+FFFD.
template <typename Sink>
void for_each_code_point(std::string_view text, Sink&& sink) {
  constexpr char32_t kReplacement = 0xfffd;
  std::size_t i = 0;
  while (i < text.size()) {
    const auto first = static_cast<unsigned char>(text[i++]);
    if (first < 0x80) {
      sink(static_cast<char32_t>(first));
      continue;
    }
    const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
    char32_t code = first & (0x3fu >> more);
    std::size_t next = i;
    for (int k = 0; k < more && next < text.size(); ++k, ++next) {
      const auto byte = static_cast<unsigned char>(text[next]);
      if ((byte & 0xc0) != 0x80) break;
      code = code << 6 | (byte & 0x3fu);
    }
    constexpr char32_t kLeast[] = {0x80, 0x800, 0x10000};
    const bool whole = first >= 0xc2 && first < 0xf5 && next == i + static_cast<std::size_t>(more);
    const bool valid =
        whole && code >= kLeast[more - 1] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
    sink(valid ? code : kReplacement);
    if (valid) i = next;
  }
}

}  // namespace kinescope
