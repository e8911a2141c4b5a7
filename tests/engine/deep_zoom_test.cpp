#include "engine/fractals/deep_zoom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "raster/base/error.h"
#include "raster/base/workers.h"

namespace kinescope {
namespace {

using Vec = glm::dvec2;

DeepView deep_view(const char* x, const char* y, double step = 1e-100) {
  DeepView view;
  view.centre_x = x;
  view.centre_y = y;
  view.step = step;
  view.width = 21;
  view.height = 15;
  return view;
}

/// Pixels whose times are not those of arbitrary precision, and the times.
std::pair<int, std::vector<std::int32_t>> deep_difference(const DeepView& view) {
  Workers workers(2);
  auto times = deep_escape_times(view, workers);
  int differ = 0;
  for (int j = 0; j < view.height; ++j) {
    for (int i = 0; i < view.width; ++i) {
      const std::int32_t got = times[static_cast<std::size_t>(j * view.width + i)];
      differ += got != exact_escape_time(view, view.offset(i, j));
    }
  }
  return {differ, std::move(times)};
}

// About i and -i, whose neighbourhoods escape after some hundred iterations.
TEST(DeepZoom, AgreesWithArbitraryPrecisionAtTenToTheMinusHundred) {
  for (const char* y : {"1", "-1"}) {
    const auto [differ, times] = deep_difference(deep_view("0", y));
    EXPECT_EQ(differ, 0);
    EXPECT_GT(*std::min_element(times.begin(), times.end()), 100);
  }
}

// The orbit of -2 rests on |z| = 2: left of it all escape at once, by less than doubles can tell.
TEST(DeepZoom, AgreesAtTheTip) {
  for (const double step : {1e-100, 1e-200, 1e-280}) {
    const auto [differ, times] = deep_difference(deep_view("-2", "0", step));
    EXPECT_EQ(differ, 0) << step;
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), 164);
    EXPECT_EQ(times[7 * 21 + 10], 1000);
    EXPECT_GT(times[7 * 21 + 11], 100);
  }
}

// Here the orbit that all others are compared with escapes at once, half the pixels do not. No
// pixel lies on the needle or straight above the tip, where a last bit decides.
TEST(DeepZoom, AgreesWhereTheCentreItselfEscapes) {
  const DeepView tip = deep_view("-2", "0");
  const auto [differ, times] = deep_difference(moved(tip, {-2.3e-100, 3.4e-100}));
  EXPECT_EQ(differ, 0);
  EXPECT_EQ(times[7 * 21 + 10], 1);
  EXPECT_GT(*std::max_element(times.begin(), times.end()), 100);
}

TEST(DeepZoom, MovedLooksAtThePixelItWasMovedTo) {
  const DeepView view = deep_view("0", "1");
  for (const auto& [i, j] : {std::pair(0, 0), std::pair(3, 12), std::pair(20, 7)}) {
    const DeepView other = moved(view, view.offset(i, j));
    EXPECT_EQ(other.step, view.step);
    EXPECT_EQ(exact_escape_time(other, Vec(0)), exact_escape_time(view, view.offset(i, j)));
    // There and back again, to within a thousandth of a pixel.
    const DeepView back = moved(other, -view.offset(i, j));
    EXPECT_EQ(exact_escape_time(back, Vec(1e-103, 0)), exact_escape_time(view, Vec(1e-103, 0)));
  }
  // Digits far below a double's are kept: 7.5e-1 and 1e-100 are 99 places apart.
  const DeepView far = moved(deep_view("-0.75", "0"), {-1e-100, 0});
  EXPECT_EQ(far.centre_x.substr(0, 5), "-7.50");
  EXPECT_EQ(far.centre_x.find_first_of("123456789", 4), far.centre_x.find('.') + 99);
  DeepView bad = view;
  bad.centre_y = "up";
  EXPECT_THROW(moved(bad, Vec(0)), Error);
}

TEST(DeepZoom, BadInputIsRefused) {
  DeepView bad;
  bad.centre_x = "x";
  EXPECT_THROW(reference_orbit(bad), Error);
  bad.step = 0;
  EXPECT_THROW(deep_precision_bits(bad), Error);
}

}  // namespace
}  // namespace kinescope
