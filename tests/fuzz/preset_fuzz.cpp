#include <algorithm>
#include <cstdlib>

#include "display/tube/preset.h"
#include "tests/fuzz/fuzz.h"

namespace {

/// Every number of a preset that was taken lies where it may.
void check(kinescope::TubePreset preset) {
  for (const kinescope::TubeNumber& number : kinescope::tube_numbers()) {
    const double value = number.of(preset.settings);
    // One that the text left out has its default, which need not lie in the range.
    const double usual = [&] {
      kinescope::TubeSettings none;
      return number.of(none);
    }();
    if (value != usual && !(value >= number.least && value <= number.most)) std::abort();
  }
  const auto& tint = preset.settings.glass.tint;
  if (std::any_of(tint.begin(), tint.end(), [](double t) { return !(t >= 0 && t <= 1); })) {
    std::abort();
  }
  preset.settings.mode.check();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinescope::fuzz_reader(data, size, [](auto bytes) {
    const std::string text(bytes.begin(), bytes.end());
    check(kinescope::parse_tube_preset(text, "fuzz", "fuzz"));
  });
  return 0;
}
