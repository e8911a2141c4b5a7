#include <array>
#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it first

#include <jerror.h>
#include <jpeglib.h>

#include "raster/base/error.h"
#include "raster/image/codecs.h"
#include "raster/image/limits.h"

namespace kinescope {
namespace {

// Every block of 64 samples costs a bit or more in some scan; sampling factors can spread it over
// twice as many pixels, and arithmetic coding takes less than a bit: four times is generous.
constexpr std::int64_t kPixelsPerByte = 8 * 64 * 4;
// A progressive file needs about ten; each more is a pass over the whole picture.
constexpr int kMaxScans = 100;

/// One decoding. Everything that outlives libjpeg's longjmp is kept here.
struct Decoder {
  jpeg_decompress_struct info;
  jpeg_error_mgr errors;
  jpeg_progress_mgr progress;
  std::jmp_buf failed;
  std::array<char, JMSG_LENGTH_MAX> message;
};

Decoder& decoder_of(j_common_ptr info) { return *static_cast<Decoder*>(info->client_data); }

[[noreturn]] void leave(j_common_ptr info) {
  Decoder& decoder = decoder_of(info);
  info->err->format_message(info, decoder.message.data());
  std::longjmp(decoder.failed, 1);
}

// libjpeg paints what a cut off file lacks in grey and only warns; here that is an error.
void on_message(j_common_ptr info, int level) {
  if (level < 0 && info->err->msg_code == JWRN_JPEG_EOF) leave(info);
}

void on_progress(j_common_ptr info) {
  if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number > kMaxScans) {
    ERREXIT(info, JERR_BAD_PROGRESSION);
  }
}

void ignore_output(j_common_ptr) {}

bool read_header(Decoder& decoder, std::span<const std::uint8_t> bytes) {
  decoder.info.err = jpeg_std_error(&decoder.errors);
  decoder.errors.error_exit = leave;
  decoder.errors.emit_message = on_message;
  decoder.errors.output_message = ignore_output;
  decoder.info.client_data = &decoder;
  if (setjmp(decoder.failed)) return false;
  jpeg_create_decompress(&decoder.info);
  decoder.info.client_data = &decoder;
  decoder.progress.progress_monitor = on_progress;
  decoder.info.progress = &decoder.progress;
  jpeg_mem_src(&decoder.info, bytes.data(), bytes.size());
  jpeg_read_header(&decoder.info, TRUE);
  const bool inks =
      decoder.info.jpeg_color_space == JCS_CMYK || decoder.info.jpeg_color_space == JCS_YCCK;
  decoder.info.out_color_space = inks ? JCS_CMYK : JCS_EXT_RGBA;
  return true;
}

/// Decodes into `pixels`, four bytes each.
bool read_rows(Decoder& decoder, std::uint8_t* pixels, std::size_t row_bytes) {
  if (setjmp(decoder.failed)) return false;
  jpeg_start_decompress(&decoder.info);
  while (decoder.info.output_scanline < decoder.info.output_height) {
    JSAMPROW row = pixels + decoder.info.output_scanline * row_bytes;
    jpeg_read_scanlines(&decoder.info, &row, 1);
  }
  jpeg_finish_decompress(&decoder.info);
  return true;
}

/// Inks as if they were ideal filters: each lets through what the black leaves.
Srgb8 rgb_of_inks(Srgb8 cmyk, bool stored_inverted) {
  const int flip = stored_inverted ? 0 : 255;
  const auto light = [flip](int ink, int black) {
    return static_cast<std::uint8_t>(((ink ^ flip) * (black ^ flip) + 127) / 255);
  };
  return {light(cmyk.r, cmyk.a), light(cmyk.g, cmyk.a), light(cmyk.b, cmyk.a), 255};
}

}  // namespace

Image<Srgb8> read_jpeg(std::span<const std::uint8_t> bytes, const std::string& name) {
  struct Owned : Decoder {
    Owned() : Decoder{} {}
    ~Owned() { jpeg_destroy_decompress(&info); }
  } decoder;
  const auto fail = [&] {
    throw_bad_input(
        std::string("a damaged or cut off JPEG picture (") + decoder.message.data() + ")", name);
  };
  if (!read_header(decoder, bytes)) fail();
  check_image_size(decoder.info.image_width, decoder.info.image_height,
                   kPixelsPerByte * static_cast<std::int64_t>(bytes.size()), name);
  Image<Srgb8> picture(static_cast<int>(decoder.info.image_width),
                       static_cast<int>(decoder.info.image_height));
  const std::size_t row_bytes = static_cast<std::size_t>(picture.width()) * sizeof(Srgb8);
  if (!read_rows(decoder, &picture.row(0)->r, row_bytes)) fail();
  if (decoder.info.out_color_space == JCS_CMYK) {
    const bool inverted = decoder.info.saw_Adobe_marker;
    for (Srgb8& pixel : picture.pixels()) pixel = rgb_of_inks(pixel, inverted);
  }
  return picture;
}

}  // namespace kinescope
