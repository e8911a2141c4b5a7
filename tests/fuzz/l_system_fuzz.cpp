// What is read may grow without end: its strings stop at the limit that they are given.
#include "engine/fractals/turtle.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinescope::fuzz_reader(data, size, [](std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    constexpr std::size_t kLongest = 20'000;
    draw_l_system(
        kinescope::read_l_system(text, "fuzz"), 8, [](auto, auto) {}, kLongest);
  });
  return 0;
}
