#include "raster/image/codecs.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinescope::fuzz_reader(data, size, [](auto bytes) { kinescope::read_jpeg(bytes, "fuzz"); });
  return 0;
}
