#include "display/frame_buffer.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "raster/base/error.h"
#include "raster/colour/pack_words.h"

namespace kinescope {
namespace {

constexpr int kLongestSide = 16384;

std::uint8_t scale_to_8_bits(int value, int highest) {
  return static_cast<std::uint8_t>((value * 255 + highest / 2) / highest);
}

/// The table a buffer starts with: a grey ramp for 1, 2 and 4 bits; for 8 bits a 6x6x6 cube (index
/// 36 r + 6 g + b) and, from 216 on, 40 greys between black and white.
GunDrive default_colour(PixelFormat format, int index) {
  const int bits = bits_per_pixel(format);
  if (bits < 8) {
    const std::uint8_t grey = scale_to_8_bits(index & ((1 << bits) - 1), (1 << bits) - 1);
    return {grey, grey, grey};
  }
  if (index < 216) {
    return {scale_to_8_bits(index / 36, 5), scale_to_8_bits(index / 6 % 6, 5),
            scale_to_8_bits(index % 6, 5)};
  }
  const std::uint8_t grey = scale_to_8_bits(index - 215, 41);
  return {grey, grey, grey};
}

std::uint32_t packed_index(const std::uint8_t* line, int x, int bits) {
  const int bit = x * bits;
  return (static_cast<std::uint32_t>(line[bit >> 3]) >> (8 - bits - (bit & 7))) &
         ((1u << bits) - 1u);
}

GunDrive drive_of_565(std::uint32_t value) {
  return {scale_to_8_bits(static_cast<int>(value >> 11 & 31), 31),
          scale_to_8_bits(static_cast<int>(value >> 5 & 63), 63),
          scale_to_8_bits(static_cast<int>(value & 31), 31)};
}

/// A picture's pixel packed as a true-colour format has it.
std::uint32_t pack(PixelFormat format, Srgb8 p) {
  if (format == PixelFormat::kRgb565) {
    const auto channel = [](int v, int highest) {
      return static_cast<std::uint32_t>((v * highest + 127) / 255);
    };
    return channel(p.r, 31) << 11 | channel(p.g, 63) << 5 | channel(p.b, 31);
  }
  return static_cast<std::uint32_t>(p.r) << 16 | static_cast<std::uint32_t>(p.g) << 8 | p.b;
}

void put_little_endian(std::uint8_t* at, int bytes, std::uint32_t value) {
  for (int i = 0; i < bytes; ++i) at[i] = static_cast<std::uint8_t>(value >> 8 * i);
}

std::uint32_t get_little_endian(const std::uint8_t* at, int bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < bytes; ++i) value |= static_cast<std::uint32_t>(at[i]) << 8 * i;
  return value;
}

}  // namespace

int bits_per_pixel(PixelFormat format) {
  switch (format) {
    case PixelFormat::kIndexed1:
      return 1;
    case PixelFormat::kIndexed2:
      return 2;
    case PixelFormat::kIndexed4:
      return 4;
    case PixelFormat::kIndexed8:
      return 8;
    case PixelFormat::kRgb565:
      return 16;
    case PixelFormat::kRgb888:
      return 24;
    case PixelFormat::kXrgb8888:
      return 32;
  }
  return 0;
}

FrameBuffer::FrameBuffer(int width, int height, PixelFormat format, int pages)
    : width_(width), height_(height), format_(format) {
  if (width < 1 || height < 1 || width > kLongestSide || height > kLongestSide) {
    throw Error(ErrorKind::kUsage, "no frame buffer is " + std::to_string(width) + "x" +
                                       std::to_string(height) + "; sides are 1 to 16384");
  }
  assert(pages >= 1);
  pitch_ = (width * bits_per_pixel(format) + 7) / 8;
  const std::size_t bytes = static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(height);
  pages_.assign(static_cast<std::size_t>(pages), std::vector<std::uint8_t>(bytes));
  for (int i = 0; i < 256; ++i) table_[static_cast<std::size_t>(i)] = default_colour(format, i);
}

void FrameBuffer::set_pixel(int page, int x, int y, std::uint32_t value) {
  assert(x >= 0 && y >= 0 && x < width_ && y < height_);
  const int bits = bits_per_pixel(format_);
  std::uint8_t* line = memory(page).data() + static_cast<std::ptrdiff_t>(y) * pitch_;
  if (bits >= 16) {
    put_little_endian(line + x * (bits / 8), bits / 8, value);
    return;
  }
  const int shift = 8 - bits - (x * bits & 7);
  const unsigned mask = ((1u << bits) - 1u) << shift;
  std::uint8_t& byte = line[x * bits >> 3];
  byte = static_cast<std::uint8_t>((byte & ~mask) | (value << shift & mask));
}

std::uint32_t FrameBuffer::pixel(int page, int x, int y) const {
  assert(x >= 0 && y >= 0 && x < width_ && y < height_);
  const int bits = bits_per_pixel(format_);
  const std::uint8_t* line =
      pages_[static_cast<std::size_t>(page)].data() + static_cast<std::ptrdiff_t>(y) * pitch_;
  return bits >= 16 ? get_little_endian(line + x * (bits / 8), bits / 8)
                    : packed_index(line, x, bits);
}

void FrameBuffer::store(int page, const Image<Srgb8>& picture) {
  assert(picture.width() == width_ && picture.height() == height_);
  assert(bits_per_pixel(format_) >= 16);
  const int bytes = bits_per_pixel(format_) / 8;
  for (int y = 0; y < height_; ++y) {
    std::uint8_t* out = memory(page).data() + static_cast<std::ptrdiff_t>(y) * pitch_;
    const Srgb8* in = picture.row(y);
    if (format_ == PixelFormat::kXrgb8888) {
      const auto count = static_cast<std::size_t>(width_);
      pack_words({in, count}, {}, {reinterpret_cast<std::uint32_t*>(out), count});
      continue;
    }
    for (int x = 0; x < width_; ++x, out += bytes) {
      put_little_endian(out, bytes, pack(format_, in[x]));
    }
  }
}

void FrameBuffer::set_colour(int index, GunDrive drive) {
  assert(index >= 0 && index < 256);
  table_[static_cast<std::size_t>(index)] = drive;
}

void FrameBuffer::set_colour_at_line(int line, int index, GunDrive drive) {
  assert(index >= 0 && index < 256);
  const auto after = std::upper_bound(line_changes_.begin(), line_changes_.end(), line,
                                      [](int at, const LineChange& c) { return at < c.line; });
  line_changes_.insert(after, {line, index, drive});
}

void FrameBuffer::clear_line_changes() { line_changes_.clear(); }

void FrameBuffer::flip_at_retrace(int page) {
  assert(page >= 0 && page < pages());
  waiting_page_ = page;
}

void FrameBuffer::flip_now(int page) {
  assert(page >= 0 && page < pages());
  visible_page_ = page;
  waiting_page_.reset();
}

void FrameBuffer::vertical_retrace() {
  if (waiting_page_) visible_page_ = *waiting_page_;
  waiting_page_.reset();
}

void FrameBuffer::read_line(int line, std::span<GunDrive> out) const {
  assert(line >= 0 && line < height_);
  const int bits = bits_per_pixel(format_);
  const int count = std::min(width_, static_cast<int>(out.size()));
  const std::uint8_t* in = pages_[static_cast<std::size_t>(visible_page_)].data() +
                           static_cast<std::ptrdiff_t>(line) * pitch_;
  GunDrive* to = out.data();
  if (bits == 16) {
    for (int x = 0; x < count; ++x) to[x] = drive_of_565(get_little_endian(in + 2 * x, 2));
  } else if (bits > 16) {
    const int step = bits / 8;
    for (int x = 0; x < count; ++x, in += step) to[x] = {in[2], in[1], in[0]};
  } else {
    std::array<GunDrive, 256> table = table_;
    for (const LineChange& change : line_changes_) {
      if (change.line > line) break;
      table[static_cast<std::size_t>(change.index)] = change.drive;
    }
    for (int x = 0; x < count; ++x) to[x] = table[packed_index(in, x, bits)];
  }
  std::fill(out.begin() + count, out.end(), GunDrive{});
}

}  // namespace kinescope
