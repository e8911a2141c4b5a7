#include <cstddef>
#include <cstdint>
#include <string_view>

#include "raster/path/exact_area.h"
#include "raster/path/svg_path.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const kinescope::Path path = kinescope::parse_svg_path(text);
  kinescope::ExactArea area(32, 32);
  const kinescope::PixelsFromPath unchanged(1, 0, 0, 1, 0, 0);
  kinescope::path_edges(path, unchanged, 0.1f,
                        [&](auto from, auto to) { area.add_edge(from, to); });
  area.rows(kinescope::FillRule::kNonZero, [](int, auto) {});
  return 0;
}
