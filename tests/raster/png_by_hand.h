// PNG files written from the specification alone, without libpng or zlib: an oracle for the reader.
// Source: PNG (Third Edition), W3C; RFC 1950 and 1951 (stored blocks).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace kinescope::testing {

using Bytes = std::vector<std::uint8_t>;

struct PngSpec {
  int width, height, bits;
  int colour_type;  // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
  bool interlaced = false;
  Bytes palette;            // PLTE
  Bytes transparency;       // tRNS
  std::uint32_t gamma = 0;  // gAMA, 0 for none

  int channels() const {
    return std::array<int, 7>{1, 0, 3, 1, 2, 0, 4}[static_cast<std::size_t>(colour_type)];
  }
};

/// The value of a channel of a pixel, in `bits` bits.
using Sample = std::function<unsigned(int x, int y, int channel)>;

inline void put32(Bytes& out, std::uint32_t v) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(v >> shift));
}

inline std::uint32_t crc(const std::uint8_t* data, std::size_t size) {
  std::uint32_t c = 0xffffffffu;
  for (std::size_t i = 0; i < size; ++i) {
    c ^= data[i];
    for (int k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320u ^ (c >> 1) : c >> 1;
  }
  return ~c;
}

inline void put_chunk(Bytes& out, const std::string& type, const Bytes& data) {
  put32(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = out.size();
  out.insert(out.end(), type.begin(), type.end());
  out.insert(out.end(), data.begin(), data.end());
  put32(out, crc(out.data() + start, out.size() - start));
}

inline Bytes zlib_stored(const Bytes& data) {
  Bytes out{0x78, 0x01};
  std::uint32_t a = 1, b = 0;
  for (std::size_t i = 0; i < data.size() || i == 0; i += 65535) {
    const std::size_t n = std::min<std::size_t>(65535, data.size() - i);
    out.push_back(i + n == data.size());
    for (const std::size_t v : {n, ~n}) {
      out.push_back(static_cast<std::uint8_t>(v));
      out.push_back(static_cast<std::uint8_t>(v >> 8));
    }
    out.insert(out.end(), data.begin() + static_cast<std::ptrdiff_t>(i),
               data.begin() + static_cast<std::ptrdiff_t>(i + n));
  }
  for (const std::uint8_t byte : data) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  put32(out, b << 16 | a);
  return out;
}

/// The scanlines of the pixels at x0 + i dx, y0 + j dy, each with filter 0.
inline void put_pass(Bytes& out, const PngSpec& spec, const Sample& sample, int x0, int y0, int dx,
                     int dy) {
  if (x0 >= spec.width) return;
  for (int y = y0; y < spec.height; y += dy) {
    out.push_back(0);
    unsigned held = 0;
    int bits = 0;
    for (int x = x0; x < spec.width; x += dx) {
      for (int c = 0; c < spec.channels(); ++c) {
        held = held << spec.bits | sample(x, y, c);
        for (bits += spec.bits; bits >= 8; bits -= 8) {
          out.push_back(static_cast<std::uint8_t>(held >> (bits - 8)));
        }
      }
    }
    if (bits) out.push_back(static_cast<std::uint8_t>(held << (8 - bits)));
  }
}

inline Bytes png_by_hand(const PngSpec& spec, const Sample& sample) {
  Bytes lines;
  if (spec.interlaced) {
    constexpr int kAdam7[7][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                  {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
    for (const auto& pass : kAdam7)
      put_pass(lines, spec, sample, pass[0], pass[1], pass[2], pass[3]);
  } else {
    put_pass(lines, spec, sample, 0, 0, 1, 1);
  }
  Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  Bytes header;
  put32(header, static_cast<std::uint32_t>(spec.width));
  put32(header, static_cast<std::uint32_t>(spec.height));
  for (const int v : {spec.bits, spec.colour_type, 0, 0, static_cast<int>(spec.interlaced)}) {
    header.push_back(static_cast<std::uint8_t>(v));
  }
  put_chunk(out, "IHDR", header);
  if (spec.gamma) {
    Bytes gamma;
    put32(gamma, spec.gamma);
    put_chunk(out, "gAMA", gamma);
  }
  if (!spec.palette.empty()) put_chunk(out, "PLTE", spec.palette);
  if (!spec.transparency.empty()) put_chunk(out, "tRNS", spec.transparency);
  put_chunk(out, "IDAT", zlib_stored(lines));
  put_chunk(out, "IEND", {});
  return out;
}

}  // namespace kinescope::testing
