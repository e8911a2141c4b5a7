// fuzz_seeds FOLDER: writes small PNG and JPEG pictures of each kind into FOLDER.
#include <cstdio>
#include <cstdlib>  // jpeglib.h needs them first

#include <jpeglib.h>

#include <string>
#include <vector>

#include "raster/base/output_file.h"
#include "raster/image/codecs.h"

namespace {

using namespace kinescope;

constexpr int kSide = 19;  // several blocks of a JPEG picture, and parts of some

std::uint8_t ramp(int x, int y, int channel) {
  return static_cast<std::uint8_t>(13 * x + 7 * y * channel);
}

void write_pngs(const std::string& folder) {
  Image<Srgb8> opaque(kSide, kSide), clear(kSide, kSide);
  Image<Srgb16> deep(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      opaque.at(x, y) = {ramp(x, y, 1), ramp(x, y, 2), ramp(x, y, 3), 255};
      clear.at(x, y) = {ramp(x, y, 1), ramp(x, y, 2), ramp(x, y, 3), ramp(x, y, 4)};
      deep.at(x, y) = {static_cast<std::uint16_t>(997 * x), static_cast<std::uint16_t>(1009 * y),
                       0};
    }
  }
  write_png(folder + "/rgb8.png", opaque);
  write_png(folder + "/rgba8.png", clear);
  write_png(folder + "/rgb16.png", deep);
}

struct Kind {
  const char* name;
  J_COLOR_SPACE colours;
  int components;
  bool progressive, arithmetic;
};

void write_jpeg(const std::string& path, const Kind& kind) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);  // ends the program, as a generator may
  jpeg_create_compress(&info);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &bytes, &size);
  info.image_width = info.image_height = kSide;
  info.input_components = kind.components;
  info.in_color_space = kind.colours;
  jpeg_set_defaults(&info);
  if (kind.progressive) jpeg_simple_progression(&info);
  info.arith_code = kind.arithmetic;
  info.restart_interval = kind.arithmetic ? 2 : 0;
  jpeg_start_compress(&info, TRUE);
  for (int y = 0; y < kSide; ++y) {
    std::vector<JSAMPLE> row;
    for (int x = 0; x < kSide; ++x) {
      for (int c = 0; c < kind.components; ++c) row.push_back(ramp(x, y, c + 1));
    }
    JSAMPROW rows = row.data();
    jpeg_write_scanlines(&info, &rows, 1);
  }
  jpeg_finish_compress(&info);
  OutputFile file(path);
  file.write({bytes, size});
  file.commit();
  jpeg_destroy_compress(&info);
  std::free(bytes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  write_pngs(folder);
  for (const Kind& kind :
       {Kind{"grey", JCS_GRAYSCALE, 1, false, false}, Kind{"rgb", JCS_RGB, 3, false, false},
        Kind{"progressive", JCS_RGB, 3, true, false}, Kind{"arithmetic", JCS_RGB, 3, false, true},
        Kind{"cmyk", JCS_CMYK, 4, true, false}}) {
    write_jpeg(folder + "/" + kind.name + ".jpeg", kind);
  }
  return 0;
}
