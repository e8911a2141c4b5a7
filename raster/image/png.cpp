#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <exception>
#include <new>

#include "raster/base/error.h"
#include "raster/base/output_file.h"
#include "raster/image/codecs.h"
#include "raster/image/limits.h"

namespace kinescope {
namespace {

// Deflate cannot shrink by more than this, and the smallest pixel is one bit.
constexpr std::int64_t kDeflateRatio = 1032;

/// Everything that outlives libpng's longjmp is kept here, outside the frame that it leaves.
struct PngSink {
  OutputFile& file;
  std::exception_ptr failure;
  std::string message;
};

void write_bytes(png_structp png, png_bytep data, std::size_t size) {
  PngSink& sink = *static_cast<PngSink*>(png_get_io_ptr(png));
  try {
    sink.file.write({data, size});
    return;
  } catch (...) {
    sink.failure = std::current_exception();
  }
  png_error(png, "cannot be written");
}

void flush_bytes(png_structp) {}

[[noreturn]] void keep_message(png_structp png, png_const_charp message) {
  static_cast<PngSink*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

struct Layout {
  int width;
  int height;
  int bits;
  bool opaque;
};

/// libpng's part of writing. No object with a destructor may live in this frame.
bool encode_rows(png_structp png, png_infop info, const Layout& layout,
                 const png_byte* const* rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_user_limits(png, kMaxImageSide, kMaxImageSide);
  png_set_IHDR(png, info, static_cast<png_uint_32>(layout.width),
               static_cast<png_uint_32>(layout.height), layout.bits,
               layout.opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_compression_level(png, 3);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP);
  png_write_info(png, info);
  if (layout.opaque) png_set_filler(png, 0, PNG_FILLER_AFTER);
  if (layout.bits == 16) png_set_swap(png);
  for (int y = 0; y < layout.height; ++y) png_write_row(png, rows[y]);
  png_write_end(png, info);
  return true;
}

template <typename Pixel>
void write_any(const std::string& path, const Image<Pixel>& picture) {
  assert(!picture.empty());
  OutputFile file(path);
  PngSink sink{file, nullptr, {}};
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, keep_message, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info) {
    png_destroy_write_struct(&png, nullptr);
    throw Error(ErrorKind::kCannotWrite, "not enough memory to write a PNG picture", path);
  }
  png_set_write_fn(png, &sink, write_bytes, flush_bytes);
  const auto pixels = picture.pixels();
  const Pixel opaque_pixel{};
  const bool opaque = std::all_of(pixels.begin(), pixels.end(),
                                  [&](const Pixel& p) { return p.a == opaque_pixel.a; });
  std::vector<const png_byte*> rows;
  for (int y = 0; y < picture.height(); ++y) {
    rows.push_back(reinterpret_cast<const png_byte*>(picture.row(y)));
  }
  const Layout layout{picture.width(), picture.height(), 8 * static_cast<int>(sizeof(pixels[0].r)),
                      opaque};
  const bool done = encode_rows(png, info, layout, rows.data());
  png_destroy_write_struct(&png, &info);
  if (sink.failure) std::rethrow_exception(sink.failure);
  if (!done) throw Error(ErrorKind::kCannotWrite, "not written as PNG: " + sink.message, path);
  file.commit();
}

struct PngSource {
  std::span<const std::uint8_t> rest;
  std::string message;
};

void read_bytes(png_structp png, png_bytep to, std::size_t size) {
  PngSource& source = *static_cast<PngSource*>(png_get_io_ptr(png));
  if (size > source.rest.size()) png_error(png, "no more data");
  std::copy_n(source.rest.begin(), size, to);
  source.rest = source.rest.subspan(size);
}

[[noreturn]] void keep_read_error(png_structp png, png_const_charp message) {
  static_cast<PngSource*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

/// Everything before the pixels. No object with a destructor may live in this frame.
bool read_header(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png))) return false;
  // A picture that gives its gamma is brought to sRGB's; one that does not is taken for sRGB.
  png_set_alpha_mode(png, PNG_ALPHA_PNG, PNG_DEFAULT_sRGB);
  png_read_info(png, info);
  return true;
}

/// The pixels, as 8-bit RGBA whatever the file holds.
bool read_rows(png_structp png, png_infop info, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != 4 * std::size_t{png_get_image_width(png, info)}) {
    png_error(png, "an unexpected pixel format");
  }
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

/// Every chunk up to the last must lie within the file. libpng takes memory for what a chunk claims
/// before it looks, and this says where a file is cut off.
void check_chunks(std::span<const std::uint8_t> bytes, const std::string& name) {
  constexpr std::size_t kSignature = 8, kFrame = 12;  // length, type and checksum
  std::size_t at = kSignature;
  for (;;) {
    if (bytes.size() < at + kFrame) {
      throw_bad_input("a PNG picture that is cut off", name,
                      "byte " + std::to_string(bytes.size()));
    }
    const std::uint8_t* head = bytes.data() + at;
    const std::size_t length = png_get_uint_32(head);
    if (length > bytes.size() - at - kFrame) {
      throw_bad_input("a PNG picture with a chunk longer than the file: cut off or damaged", name,
                      "byte " + std::to_string(at));
    }
    if (std::equal(head + 4, head + 8, "IEND")) return;
    at += kFrame + length;
  }
}

}  // namespace

Image<Srgb8> read_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  check_chunks(bytes, name);
  PngSource source{bytes, {}};
  struct Reader {
    explicit Reader(PngSource& from)
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &from, keep_read_error,
                                     ignore_warning)),
          info(png ? png_create_info_struct(png) : nullptr) {}
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    png_structp png;
    png_infop info;
  } reader(source);
  if (!reader.info) throw std::bad_alloc();
  const auto fail = [&] {
    throw_bad_input("a damaged or cut off PNG picture (" + source.message + ")", name);
  };
  png_set_read_fn(reader.png, &source, read_bytes);
  if (!read_header(reader.png, reader.info)) fail();
  const png_uint_32 width = png_get_image_width(reader.png, reader.info);
  const png_uint_32 height = png_get_image_height(reader.png, reader.info);
  check_image_size(width, height, 8 * kDeflateRatio * static_cast<std::int64_t>(bytes.size()),
                   name);
  Image<Srgb8> picture(static_cast<int>(width), static_cast<int>(height));
  std::vector<png_bytep> rows;
  for (int y = 0; y < picture.height(); ++y) rows.push_back(&picture.row(y)->r);
  if (!read_rows(reader.png, reader.info, rows.data())) fail();
  return picture;
}

void write_png(const std::string& path, const Image<Srgb8>& picture) { write_any(path, picture); }

void write_png(const std::string& path, const Image<Srgb16>& picture) { write_any(path, picture); }

}  // namespace kinescope
