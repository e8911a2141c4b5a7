#include "raster/base/simd.h"

#include <hwy/highway.h>

#include "raster/base/error.h"

namespace kinescope {
namespace {

std::vector<std::int64_t> targets_here() {
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::int64_t> targets;
  // A lower bit is a better target; the portable one is the highest.
  for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
    targets.push_back(left & -left);
  }
  return targets;
}

}  // namespace

std::vector<std::string> simd_targets() {
  const std::string chosen = simd_target();
  std::vector<std::string> names;
  for (const std::int64_t target : targets_here()) names.emplace_back(hwy::TargetName(target));
  use_simd_target(chosen);
  return names;
}

std::string simd_target() {
  const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
  return hwy::TargetName(usable & -usable);
}

void use_simd_target(std::string_view name) {
  std::string known;
  for (const std::int64_t target : targets_here()) {
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
