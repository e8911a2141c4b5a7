#include "raster/characters/bitmap_font.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinescope::fuzz_reader(data, size, [](std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto font = kinescope::BitmapFont::parse_bdf(text, "fuzz");
    font.draw("Aa?", {0, 0}, [](int, int) {});
  });
  return 0;
}
