#include "raster/base/simd.h"

#include <hwy/highway.h>

#include "raster/base/error.h"

namespace kinescope {
namespace {

std::vector<std::uint32_t> targets_here() {
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::uint32_t> targets;
  const std::uint32_t usable = static_cast<std::uint32_t>(hwy::SupportedTargets() & HWY_TARGETS);
  // A lower bit is a better target.
  for (std::uint32_t bit = 1; bit != 0; bit <<= 1) {
    if (usable & bit) targets.push_back(bit);
  }
  return targets;
}

}  // namespace

std::vector<std::string> simd_targets() {
  const std::string chosen = simd_target();
  std::vector<std::string> names;
  for (const std::uint32_t target : targets_here()) names.emplace_back(hwy::TargetName(target));
  use_simd_target(chosen);
  return names;
}

std::string simd_target() {
  const std::uint32_t usable = static_cast<std::uint32_t>(hwy::SupportedTargets() & HWY_TARGETS);
  return hwy::TargetName(usable & (~usable + 1));
}

void use_simd_target(std::string_view name) {
  std::string known;
  for (const std::uint32_t target : targets_here()) {
    known += std::string(known.empty() ? "" : ", ") + hwy::TargetName(target);
    if (name == hwy::TargetName(target)) {
      hwy::SetSupportedTargetsForTest(target);
      return;
    }
  }
  if (name != "best") {
    throw Error(ErrorKind::kUsage,
                "no instruction set \"" + std::string(name) + "\" here; there are best, " + known);
  }
}

}  // namespace kinescope
