#include "raster/path/font.h"
#include "tests/fuzz/fuzz.h"

// What of a font is ours: its outlines, laid out, scan-converted and drawn.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinescope::fuzz_reader(data, size, [](std::span<const std::uint8_t> bytes) {
    const kinescope::Font font(bytes);
    kinescope::Image<kinescope::Srgb8> picture(64, 24);
    font.draw(picture, 2, 18, "Ag\xC3\xA9 ", 16, {255, 255, 255, 255});
    font.outline(U'B');
    font.line_outline("AV");
    font.line_height_px(16);
  });
  return 0;
}
