#include "display/vector/storage_tube.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr Seconds kFrame{1.0 / 60};

/// A tube whose picture has two pixels a millimetre.
struct Bench {
  explicit Bench(const StorageTubeType& type = find_storage_tube("613"))
      : tube(type, 400, 300), drawing() {
    drawing.size = {200, 152.34f};  // millimetres
  }
  void line(float x0, float y0, float x1, float y1, float intensity = 1) {
    drawing.line({x0, y0}, {x1, y1}, intensity);
  }
  const Image<LinearRgb>& at(double seconds) {
    while (tube.now() + kFrame < Seconds(seconds)) tube.expose(tube.now() + kFrame, workers);
    tube.expose(Seconds(seconds), workers);
    return tube.expose(Seconds(seconds) + kFrame, workers);
  }
  Workers workers{2};
  StorageTube tube;
  VectorDrawing drawing;
};

double sum_of(const Image<LinearRgb>& picture) {
  double sum = 0;
  for (const LinearRgb& p : picture.pixels()) sum += static_cast<double>(p.g);
  return sum;
}

TEST(StorageTube, KeepsWhatItWroteOnce) {
  Bench bench;
  bench.line(20, 75.92f, 180, 75.92f);
  bench.tube.draw(bench.drawing);
  const LinearRgb soon = bench.at(1).at(200, 150), later = bench.at(10).at(200, 150);
  EXPECT_NEAR(soon.g, 0.9f, 0.1f);
  EXPECT_NEAR(later.g, soon.g, 0.02f * soon.g);
  EXPECT_NEAR(bench.at(20).at(200, 100).g, 0.04f, 1e-3f);
  const float corner = bench.at(21).at(200, 2).g;
  EXPECT_EQ(bench.at(22).at(200, 60).g, corner);
}

TEST(StorageTube, AStillPictureIsNotDrawnAgain) {
  Bench bench;
  bench.line(20, 75.92f, 180, 75.92f);
  bench.tube.draw(bench.drawing);
  bench.at(3);
  EXPECT_TRUE(bench.tube.still());
  int drawn = 0;
  for (int i = 0; i < 600; ++i) {
    bench.tube.expose(bench.tube.now() + kFrame, bench.workers);
    drawn += bench.tube.changed();
  }
  // Ten seconds: contrast fades by a 256th in 5 s.
  EXPECT_LE(drawn, 3);
  EXPECT_GE(drawn, 1);
  bench.tube.draw(bench.drawing);
  bench.tube.expose(bench.tube.now() + kFrame, bench.workers);
  EXPECT_TRUE(bench.tube.changed());
  EXPECT_FALSE(bench.tube.still());
}

TEST(StorageTube, ErasesInNineTenthsOfASecondWithAFlash) {
  Bench bench;
  bench.line(20, 75.92f, 180, 75.92f);
  bench.tube.draw(bench.drawing);
  bench.at(2);
  bench.tube.erase();
  const Seconds from = bench.tube.now();
  EXPECT_NEAR((bench.tube.busy_until() - from).count(), 0.9, 1e-9);
  const double flash = sum_of(bench.at(from.count() + 0.05));
  EXPECT_NEAR(flash / (400 * 300), 1, 0.02);
  EXPECT_TRUE(bench.tube.erasing());
  const Image<LinearRgb>& dark = bench.at(from.count() + 0.25);
  EXPECT_LT(dark.at(200, 150).g, 0.01f);
  EXPECT_LT(dark.at(20, 20).g, 0.01f);
  bench.at(from.count() + 0.95);
  EXPECT_FALSE(bench.tube.erasing());
  const Image<LinearRgb>& clean = bench.at(from.count() + 1);
  EXPECT_NEAR(clean.at(200, 150).g, 0.04f, 1e-3f);
}

TEST(StorageTube, DrawsOnceTheErasureIsOver) {
  Bench bench;
  bench.line(20, 75.92f, 180, 75.92f);
  bench.drawing.event(DrawingEvent::Kind::kErase);
  bench.line(20, 50.92f, 180, 50.92f);
  bench.tube.draw(bench.drawing);
  // 180 mm and 205 mm at 100 mm a ms, dark ways in between.
  EXPECT_NEAR(bench.tube.busy_until().count(), 0.9 + 0.0032, 0.001);
  const Image<LinearRgb>& after = bench.at(2);
  EXPECT_LT(after.at(200, 150).g, 0.05f);
  EXPECT_GT(after.at(200, 200).g, 0.6f);
}

TEST(StorageTube, WriteThroughIsSeenAndNotKept) {
  Bench bench;
  bench.drawing.use(VectorPen{.write_through = true});
  bench.line(20, 75.92f, 180, 75.92f);
  bench.at(1);
  bench.tube.draw(bench.drawing);
  const float lit = bench.tube.expose(bench.tube.now() + kFrame, bench.workers).at(200, 150).g;
  EXPECT_GT(lit, 0.15f);
  EXPECT_LT(bench.at(3).at(200, 150).g, 0.041f);
  EXPECT_EQ(bench.tube.hard_copy().at(200, 150).g, 255);
}

TEST(StorageTube, FaintStrokesAreLost) {
  Bench bench;
  bench.line(20, 75.92f, 180, 75.92f, 0.2f);
  bench.tube.draw(bench.drawing);
  EXPECT_LT(bench.at(2).at(200, 150).g, 0.15f);
  // Written over and over, charge gathers until it is.
  for (int i = 0; i < 9; ++i) bench.tube.draw(bench.drawing);
  EXPECT_GT(bench.at(4).at(200, 150).g, 0.8f);
}

TEST(StorageTube, FadesOverMinutes) {
  Bench bench;
  bench.line(20, 75.92f, 180, 75.92f);
  bench.tube.draw(bench.drawing);
  const float soon = bench.at(2).at(200, 150).g - 0.04f;
  bench.tube.expose(Seconds(902), bench.workers);
  const float later =
      bench.tube.expose(Seconds(902) + kFrame, bench.workers).at(200, 150).g - 0.04f;
  EXPECT_NEAR(later / soon, 0.5f, 0.005f);
}

/// Michelson's contrast of stored lines so many millimetres apart.
double contrast_of(const StorageTubeType& type, double pitch_mm) {
  const int pixels_mm = 10;
  Workers workers(1);
  // Of a drawing as flat as the picture.
  VectorDrawing drawing;
  drawing.size = {static_cast<float>(type.screen_mm), 5};
  StorageTubeType flat = type;
  flat.height = static_cast<int>(6 / type.screen_mm * type.width);
  StorageTube strip(flat, static_cast<int>(type.screen_mm) * pixels_mm, 60);
  for (double x = 5; x < 60; x += pitch_mm) {
    drawing.line({static_cast<float>(x), -5}, {static_cast<float>(x), 11});
  }
  strip.draw(drawing);
  strip.expose(Seconds(2), workers);
  const Image<LinearRgb>& picture = strip.expose(Seconds(2) + kFrame, workers);
  float least = 10, most = 0;
  for (int x = 200; x < 400; ++x) {
    least = std::min(least, picture.at(x, 30).g - 0.04f);
    most = std::max(most, picture.at(x, 30).g - 0.04f);
  }
  return static_cast<double>((most - least) / (most + least));
}

TEST(StorageTube, Resolves266LinePairsAndHardlyMore) {
  for (const StorageTubeType& type : storage_tube_types()) {
    const double pitch = type.screen_mm / 266;
    EXPECT_NEAR(contrast_of(type, pitch), 0.33, 0.08) << type.name;
    EXPECT_GT(contrast_of(type, 1.5 * pitch), 0.9) << type.name;
    EXPECT_LT(contrast_of(type, 0.8 * pitch), 0.1) << type.name;
  }
}

TEST(StorageTube, LightAddsUpHoweverItIsSliced) {
  const auto sliced = [](int slices) {
    Bench bench;
    for (int i = 0; i < 40; ++i) bench.line(20, 10 + 3.0f * static_cast<float>(i), 180, 20);
    bench.drawing.event(DrawingEvent::Kind::kErase);
    bench.line(20, 75.92f, 180, 75.92f);
    bench.tube.draw(bench.drawing);
    Image<LinearRgb> sum(400, 300);
    for (int i = 1; i <= slices; ++i) {
      const Image<LinearRgb>& slice = bench.tube.expose(Seconds(1.2 * i / slices), bench.workers);
      for (std::size_t p = 0; p < sum.pixels().size(); ++p)
        sum.pixels()[p].g += slice.pixels()[p].g;
    }
    return sum;
  };
  const Image<LinearRgb> whole = sliced(1), parts = sliced(97);
  for (std::size_t p = 0; p < whole.pixels().size(); ++p) {
    // Unchanged pictures fade in steps of a five-hundredth.
    ASSERT_NEAR(parts.pixels()[p].g, whole.pixels()[p].g, 0.004f * whole.pixels()[p].g + 0.02f);
  }
}

TEST(StorageTube, IsTheSameForAnyNumberOfThreads) {
  const auto picture = [](int threads) {
    Workers workers(threads);
    StorageTube tube(find_storage_tube("4014"), 200, 150);
    VectorDrawing drawing;
    for (int i = 0; i < 50; ++i) {
      drawing.line({30.0f * static_cast<float>(i), 0}, {4000, 60.0f * static_cast<float>(i)});
    }
    tube.draw(drawing);
    return tube.expose(kFrame, workers);
  };
  const auto one = picture(1), three = picture(3);
  EXPECT_EQ(std::memcmp(one.row(0), three.row(0), sizeof(LinearRgb) * one.pixels().size()), 0);
}

TEST(StorageTube, RefusesBadData) {
  const auto fault = [](const std::string& text) {
    try {
      parse_storage_tubes(text, "tubes.txt");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THROW(find_storage_tube("999"), Error);
  EXPECT_NE(fault("erase_s 1").find("tube NAME must come first"), std::string::npos);
  EXPECT_NE(fault("tube a\nsize 10").find("line 2"), std::string::npos);
  EXPECT_NE(fault("tube a\nbackground 2").find("background"), std::string::npos);
  EXPECT_NE(fault("tube a\ncolour red").find("not known"), std::string::npos);
  EXPECT_NE(fault("tube a\nerase_s 0.1").find("outlasts"), std::string::npos);
}

}  // namespace
}  // namespace kinescope
