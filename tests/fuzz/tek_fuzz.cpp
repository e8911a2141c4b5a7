#include "display/vector/input/tek_reader.h"
#include "tests/fuzz/drawing_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinescope::fuzz_reader(data, size,
                         [](auto bytes) { kinescope::check_drawing(kinescope::read_tek(bytes)); });
  return 0;
}
