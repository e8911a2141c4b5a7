#include "raster/image/video.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static kinescope::Workers workers(1);
  kinescope::fuzz_reader(data, size, [](auto bytes) {
    kinescope::InputFile file(bytes, "fuzz");
    const auto reader = kinescope::read_y4m(file, workers);
    kinescope::Image<kinescope::Srgb8> frame;
    while (reader->read(frame)) {
    }
  });
  return 0;
}
