// Numbers of a binary format, never read past the end.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include "engine/io/reader.h"

namespace kinescope {

class ByteReader {
 public:
  ByteReader(const ModelFile& file, std::size_t offset, std::endian order = std::endian::little)
      : file_(file), at_(offset), swap_(order != std::endian::native) {}

  /// @throws Error naming the byte where the file ends too early
  template <typename T>
  T read() {
    need(sizeof(T));
    std::array<std::uint8_t, sizeof(T)> raw;
    std::memcpy(raw.data(), file_.bytes.data() + at_, sizeof(T));
    if (swap_) std::reverse(raw.begin(), raw.end());
    at_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }

  void skip(std::uint64_t bytes) {
    need(bytes);
    at_ += bytes;
  }

  std::size_t remaining() const { return file_.bytes.size() - at_; }
  std::string where() const { return "byte " + std::to_string(at_); }
  [[noreturn]] void fail(const std::string& what) const { file_.fail(what, where()); }

 private:
  void need(std::uint64_t bytes) const {
    if (bytes > remaining()) fail("the file ends too early");
  }

  const ModelFile& file_;
  std::size_t at_;
  bool swap_;
};

}  // namespace kinescope
