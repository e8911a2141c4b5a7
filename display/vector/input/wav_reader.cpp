#include "display/vector/input/wav_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>

#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr float kFullScale = 32768;

std::uint32_t little_endian(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) value |= std::uint32_t{bytes[i]} << 8 * i;
  return value;
}

struct Format {
  unsigned kind = 0;  ///< 1 whole numbers, 3 floats
  unsigned channels = 0, frame_bytes = 0, bits = 0;
};

/// One channel of a frame, -32768 to 32767.
float sample(std::span<const std::uint8_t> bytes, const Format& format) {
  const std::uint32_t value = little_endian(bytes);
  // Floats may go over full scale; no beam follows them far.
  if (format.kind == 3) return std::clamp(std::bit_cast<float>(value), -16.0f, 16.0f) * kFullScale;
  if (format.bits == 8) return (static_cast<float>(value) - 128) * 256;
  const auto high = static_cast<std::int32_t>(value << (32 - format.bits));
  return static_cast<float>(high) / 65536;
}

Format read_format(std::span<const std::uint8_t> chunk, const std::string& name) {
  if (chunk.size() < 16) throw_bad_input("its fmt chunk is too short", name);
  Format format{little_endian(chunk.subspan(0, 2)), little_endian(chunk.subspan(2, 2)),
                little_endian(chunk.subspan(12, 2)), little_endian(chunk.subspan(14, 2))};
  // The extensible format keeps the kind further on.
  if (format.kind == 0xfffe && chunk.size() >= 26) {
    format.kind = little_endian(chunk.subspan(24, 2));
  }
  const bool whole = format.kind == 1 && (format.bits == 8 || format.bits == 16 ||
                                          format.bits == 24 || format.bits == 32);
  if (!whole && !(format.kind == 3 && format.bits == 32)) {
    throw_bad_input("its samples are neither whole numbers of 8 to 32 bits nor 32-bit floats",
                    name);
  }
  if (format.channels < 2) throw_bad_input("has one channel; XY takes two", name);
  if (format.frame_bytes < format.channels * (format.bits / 8)) {
    throw_bad_input("its fmt chunk contradicts itself", name);
  }
  return format;
}

void draw(std::span<const std::uint8_t> data, const Format& format, VectorDrawing& drawing) {
  const std::size_t frames = data.size() / format.frame_bytes, width = format.bits / 8;
  constexpr float kBright = 2 * kFullScale / 512;
  drawing.segments.reserve(frames);
  glm::vec2 last{0};
  for (std::size_t i = 0; i < frames; ++i) {
    const auto frame = data.subspan(i * format.frame_bytes);
    const glm::vec2 at{sample(frame.first(width), format),
                       sample(frame.subspan(width, width), format)};
    if (!std::isfinite(at.x + at.y)) continue;
    if (i > 0) drawing.line(last, at, kBright / std::max(kBright, glm::length(at - last)));
    last = at;
  }
}

}  // namespace

VectorDrawing read_wav(std::span<const std::uint8_t> bytes, const std::string& name) {
  const auto tag = [&](std::size_t at) {
    return std::string_view(reinterpret_cast<const char*>(bytes.data() + at), 4);
  };
  if (bytes.size() < 12 || tag(0) != "RIFF" || tag(8) != "WAVE") {
    throw_bad_input("is no RIFF WAVE file", name);
  }
  VectorDrawing drawing;
  drawing.origin = glm::vec2(-kFullScale);
  drawing.size = glm::vec2(2 * kFullScale);
  Format format;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::size_t claimed = little_endian(bytes.subspan(at + 4, 4));
    const auto chunk = bytes.subspan(at + 8, std::min(claimed, bytes.size() - at - 8));
    if (tag(at) == "fmt ") format = read_format(chunk, name);
    if (tag(at) == "data") {
      if (format.channels == 0) throw_bad_input("has no fmt chunk before its data", name);
      draw(chunk, format, drawing);
      return drawing;
    }
    at += 8 + chunk.size() + (chunk.size() & 1);
  }
  throw_bad_input("has no data chunk", name);
}

}  // namespace kinescope
