#include "raster/base/fixed.h"

#include <gtest/gtest.h>

#include "raster/base/units.h"

namespace kinescope {
namespace {

TEST(Fixed, RoundsToNearestWithTiesToEven) {
  EXPECT_EQ(Fixed24_8::from_float(1.0f).raw(), 256);
  EXPECT_EQ(Fixed24_8::from_float(0.5f / 256).raw(), 0);
  EXPECT_EQ(Fixed24_8::from_float(1.5f / 256).raw(), 2);
  EXPECT_EQ(Fixed24_8::from_float(2.5f / 256).raw(), 2);
  EXPECT_EQ(Fixed24_8::from_float(-0.5f / 256).raw(), 0);
  EXPECT_EQ(Fixed24_8::from_float(-1.5f / 256).raw(), -2);
  EXPECT_EQ(Fixed24_8::from_float(0.51f / 256).raw(), 1);
}

TEST(Fixed, FloorAndCeilingOfBothSigns) {
  for (int raw = -1025; raw <= 1025; ++raw) {
    const Fixed24_8 f = Fixed24_8::from_raw(raw);
    EXPECT_EQ(f.floor(), static_cast<int>(std::floor(raw / 256.0))) << raw;
    EXPECT_EQ(f.ceil(), static_cast<int>(std::ceil(raw / 256.0))) << raw;
    EXPECT_EQ(f.to_float(), static_cast<float>(raw) / 256) << raw;
    EXPECT_EQ(Fixed24_8::from_float(f.to_float()), f) << raw;
  }
}

TEST(Fixed, AddsAndCompares) {
  const Fixed24_8 a = Fixed24_8::from_int(-3), b = Fixed24_8::from_raw(128);
  EXPECT_EQ((a + b).to_float(), -2.5f);
  EXPECT_EQ((a - b).to_float(), -3.5f);
  EXPECT_EQ((-a).floor(), 3);
  EXPECT_LT(a, b);
  EXPECT_EQ((Fixed<16, std::int64_t>::from_int(40000).raw()), std::int64_t{40000} << 16);
}

TEST(Rate, IsExactAndReduces) {
  const Rate ntsc{60000, 1001};
  EXPECT_DOUBLE_EQ(ntsc.hertz(), 59.94005994005994);
  EXPECT_DOUBLE_EQ(ntsc.period().count(), 1001.0 / 60000);
  const Rate same = Rate{120000, 2002}.reduced();
  EXPECT_EQ(same.numerator, 60000);
  EXPECT_EQ(same.denominator, 1001);
  EXPECT_EQ(Rate({25175000, 800 * 525}).reduced().numerator, 5035);
}

TEST(Units, AreSeconds) {
  EXPECT_DOUBLE_EQ(microseconds(31.5).count(), 31.5e-6);
  EXPECT_DOUBLE_EQ(milliseconds(2).count(), 2e-3);
}

}  // namespace
}  // namespace kinescope
