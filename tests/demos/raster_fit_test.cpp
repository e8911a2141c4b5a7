#include "demos/raster_fit.h"

#include <gtest/gtest.h>

namespace kinescope {
namespace {

constexpr double kFace = 4.0 / 3;

Image<Srgb8> ramp(int width, int height) {
  Image<Srgb8> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.at(x, y) = {static_cast<std::uint8_t>(5 * x + 1),
                          static_cast<std::uint8_t>(7 * y + 1), 200, 255};
    }
  }
  return picture;
}

class RasterFitTest : public ::testing::Test {
 protected:
  Image<Srgb8> fitted(const Image<Srgb8>& picture, Size raster, Fit fit,
                      FieldOrder fields = FieldOrder::kProgressive) {
    const Size size{picture.width(), picture.height()};
    const double aspect = static_cast<double>(size.width) / size.height;
    return RasterFit(size, aspect, raster, kFace, fit, fields, workers_)(picture);
  }
  Workers workers_{2};
};

TEST_F(RasterFitTest, TheRastersOwnSizeIsExact) {
  const Image<Srgb8> picture = ramp(40, 24);  // whatever its shape
  for (const Fit fit : {Fit::kInside, Fit::kFill, Fit::kNative}) {
    EXPECT_EQ(fitted(picture, {40, 24}, fit), picture);
  }
}

TEST_F(RasterFitTest, WholeMultiplesRepeatPixels) {
  const Image<Srgb8> picture = ramp(16, 12);
  const Image<Srgb8> out = fitted(picture, {48, 24}, Fit::kFill);
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 48; ++x) ASSERT_EQ(out.at(x, y), picture.at(x / 3, y / 2));
  }
  EXPECT_EQ(fitted(picture, {32, 24}, Fit::kInside), fitted(picture, {32, 24}, Fit::kFill));
}

TEST_F(RasterFitTest, InsideKeepsTheShape) {
  const Image<Srgb8> wide(32, 18, {255, 255, 255, 255});
  const Image<Srgb8> out = fitted(wide, {64, 48}, Fit::kInside);
  for (int y = 0; y < 48; ++y) EXPECT_EQ(out.at(30, y).g, y >= 6 && y < 42 ? 255 : 0) << y;
  const Image<Srgb8> tall(18, 32, {255, 255, 255, 255});
  const Image<Srgb8> column = fitted(tall, {64, 48}, Fit::kInside);
  EXPECT_EQ(column.at(17, 20).g, 0);
  EXPECT_EQ(column.at(19, 20).g, 255);
  EXPECT_EQ(column.at(32, 0).g, 255);
  const Image<Srgb8> filled = fitted(wide, {64, 48}, Fit::kFill);
  for (const Srgb8 p : filled.pixels()) ASSERT_EQ(p.g, 255);
}

TEST_F(RasterFitTest, PixelsThatAreNotSquareFillTheFace) {
  // 720x480 of pixels 8:9 is 4:3.
  EXPECT_EQ(fitted_box({720, 480}, 720.0 / 480 * 8 / 9, {710, 480}, kFace, Fit::kInside),
            (Size{710, 480}));
  // Borders of under 2% are not drawn.
  EXPECT_EQ(fitted_box({640, 485}, 640.0 / 485, {640, 480}, kFace, Fit::kInside), (Size{640, 480}));
  EXPECT_EQ(fitted_box({1000, 1}, 1000, {64, 48}, kFace, Fit::kInside), (Size{64, 1}));
}

TEST_F(RasterFitTest, NativeIsCentredAndCutOff) {
  const Image<Srgb8> picture = ramp(10, 6);
  const Image<Srgb8> out = fitted(picture, {16, 12}, Fit::kNative);
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 16; ++x) {
      const bool within = picture.contains(x - 3, y - 3);
      ASSERT_EQ(out.at(x, y), within ? picture.at(x - 3, y - 3) : Srgb8{}) << x << ' ' << y;
    }
  }
  const Image<Srgb8> cut = fitted(picture, {4, 20}, Fit::kNative);
  EXPECT_EQ(cut.at(0, 7), picture.at(3, 0));
  EXPECT_EQ(cut.at(3, 12), picture.at(6, 5));
  EXPECT_EQ(cut.at(0, 6), Srgb8{});
}

TEST_F(RasterFitTest, TheTransparentIsBlack) {
  const Image<Srgb8> glass(8, 8, {255, 255, 255, 0});
  EXPECT_EQ(fitted(glass, {8, 8}, Fit::kFill), Image<Srgb8>(8, 8));
}

TEST_F(RasterFitTest, FieldsAreNotMixedAndTheLowerFirstMovesDown) {
  Image<Srgb8> fields(10, 8);
  for (int y = 0; y < 8; y += 2) std::fill_n(fields.row(y), 10, Srgb8{255, 255, 255, 255});
  const Image<Srgb8> top = fitted(fields, {16, 8}, Fit::kInside, FieldOrder::kTopFirst);
  const Image<Srgb8> bottom = fitted(fields, {16, 8}, Fit::kInside, FieldOrder::kBottomFirst);
  for (int y = 0; y < 8; ++y) {
    EXPECT_EQ(top.at(8, y).g, y % 2 ? 0 : 255) << y;
    EXPECT_EQ(bottom.at(8, y).g, y % 2 ? 255 : 0) << y;
  }
}

}  // namespace
}  // namespace kinescope
