#include "raster/characters/stroke_font.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinescope::fuzz_reader(data, size, [](std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto font = kinescope::StrokeFont::parse_jhf(text, "fuzz");
    font.draw(" !A", {0, 0}, 1, [](auto, auto) {});
  });
  return 0;
}
