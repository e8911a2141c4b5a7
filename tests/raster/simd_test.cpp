#include "raster/base/simd.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "raster/base/error.h"

namespace kinescope {
namespace {

TEST(Simd, EveryMachineHasThePortableTargetAndTheBestIsInUse) {
  use_simd_target("best");
  const std::vector<std::string> targets = simd_targets();
  ASSERT_FALSE(targets.empty());
  EXPECT_EQ(simd_target(), targets.front());
  // Highway's portable target has two forms; which one works depends on the compiler.
  EXPECT_THAT(targets.back(), ::testing::AnyOf("EMU128", "SCALAR"));
}

TEST(Simd, ForcesEachTargetAndReturnsToTheBest) {
  const std::vector<std::string> targets = simd_targets();
  for (const std::string& target : targets) {
    use_simd_target(target);
    EXPECT_EQ(simd_target(), target);
    EXPECT_EQ(simd_targets(), targets);
    EXPECT_EQ(simd_target(), target) << "listing the targets changed the choice";
  }
  use_simd_target("best");
  EXPECT_EQ(simd_target(), targets.front());
}

TEST(Simd, AnUnknownNameIsAUsageErrorThatNamesTheChoice) {
  try {
    use_simd_target("MMX");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_THAT(error.what(), ::testing::HasSubstr("\"MMX\""));
    for (const std::string& target : simd_targets()) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr(target));
    }
  }
  EXPECT_EQ(simd_target(), simd_targets().front());
}

}  // namespace
}  // namespace kinescope
