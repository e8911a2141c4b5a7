// When pictures of a feed are on the tube, and what the camera sees of them.
#include "demos/display_film.h"

#include <gtest/gtest.h>

#include <cmath>

#include "counting_feed.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

class RefreshFeedTest : public ::testing::Test {
 protected:
  /// The numbers of the pictures in each refresh until the feed is over.
  std::vector<int> shown(int count, Rate input, Rate refresh) {
    CountingFeed feed(count, {4, 4});
    RefreshFeed refreshes(
        feed, input, refresh,
        RasterFit({4, 4}, 1, {4, 4}, 1, Fit::kFill, FieldOrder::kProgressive, workers_));
    std::vector<int> numbers;
    for (int r = 0;; ++r) {
      const int number = refreshes.at(r).at(0, 0).r;
      if (!refreshes.lasts_at(r * refresh.period())) return numbers;
      numbers.push_back(number);
    }
  }
  Workers workers_{1};
};

TEST_F(RefreshFeedTest, FramesStayUntilTheNextIsDue) {
  EXPECT_EQ(shown(3, {60, 1}, {60, 1}), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(shown(2, {30, 1}, {60, 1}), (std::vector<int>{0, 0, 1, 1}));
  // Film on a set: two refreshes of one picture, three of the next.
  EXPECT_EQ(shown(4, {24, 1}, {60, 1}), (std::vector<int>{0, 0, 0, 1, 1, 2, 2, 2, 3, 3}));
  EXPECT_EQ(shown(7, {150, 1}, {60, 1}), (std::vector<int>{0, 2, 5}));
}

TEST_F(RefreshFeedTest, RatesAreExact) {
  // 200 pictures at 60 Hz on a tube of 59.94 Hz: one refresh in a thousand skips a picture.
  const std::vector<int> numbers = shown(200, {60, 1}, {60000, 1001});
  ASSERT_EQ(numbers.size(), 200u);
  for (int r = 0; r < 200; ++r) {
    ASSERT_EQ(numbers[static_cast<std::size_t>(r)], std::floor(r * 1.001)) << r;
  }
  // Refresh r begins at r / 50 s: picture floor(r 59.94 / 50).
  const std::vector<int> fifty = shown(250, {60000, 1001}, {50, 1});
  for (std::size_t r = 0; r < fifty.size(); ++r) {
    ASSERT_EQ(fifty[r], static_cast<int>(r * 60000 / (1001 * 50))) << r;
  }
}

class DisplayFilmTest : public ::testing::Test {
 protected:
  DisplayFilmTest() {
    plan_.shot.tube.mode = {"small", 360000, {64, 8, 12, 16}, {48, 2, 2, 8}, false};  // 60 Hz
    plan_.shot.signal = TubeSignal::kGunDrive;
    plan_.shot.size = {64, 48};
    plan_.shot.aspect = 4.0 / 3;
    plan_.refresh = plan_.rate = plan_.input_rate = {60, 1};
    plan_.shot.shutter = Seconds(1.0 / 60);
    plan_.open_ended = true;
  }
  int frames(PictureFeed& feed) {
    DisplayFilm film(plan_, feed, true, workers_);
    while (film.shoot(nullptr)) {
    }
    return static_cast<int>(film.figures().size());
  }
  DisplayPlan plan_;
  Workers workers_{2};
};

TEST_F(DisplayFilmTest, LastsAsLongAsItsInput) {
  const auto count = [&](Rate input, Rate fps) {
    plan_.input_rate = input;
    plan_.rate = fps;
    plan_.shot.shutter = Seconds(std::min(1.0 / 60, fps.period().count()));
    CountingFeed feed(12, {64, 48});
    return frames(feed);
  };
  EXPECT_EQ(count({60, 1}, {60, 1}), 12);
  EXPECT_EQ(count({30, 1}, {60, 1}), 24);
  EXPECT_EQ(count({30, 1}, {30, 1}), 12);
  EXPECT_EQ(count({24, 1}, {60, 1}), 30);
  EXPECT_EQ(count({60, 1}, {240, 1}), 48);
  EXPECT_EQ(count({60, 1}, {24, 1}), 5);
  // Half a picture's time is left when the tube's last refresh has begun.
  plan_.refresh = {61, 1};
  EXPECT_EQ(count({60, 1}, {60, 1}), 12);
}

TEST_F(DisplayFilmTest, FramesEndItSooner) {
  plan_.open_ended = false;
  plan_.frames = {2, 4};
  CountingFeed feed(12, {64, 48});
  EXPECT_EQ(frames(feed), 3);
}

TEST_F(DisplayFilmTest, AStillGoesOnForEver) {
  plan_.open_ended = false;
  plan_.frames = {0, 99};
  plan_.start = Seconds(1000);
  CountingFeed feed(1, {64, 48}, true);
  EXPECT_EQ(frames(feed), 100);
}

TEST_F(DisplayFilmTest, AStartBeyondTheEndHasNoFrames) {
  plan_.start = Seconds(1);
  CountingFeed feed(12, {64, 48});
  EXPECT_EQ(frames(feed), 0);
}

TEST_F(DisplayFilmTest, AFilmThatStartsLateIsThePartOfTheWhole) {
  const auto hashes = [&](double start_s, FrameRange range) {
    plan_.open_ended = false;
    plan_.frames = range;
    plan_.start = Seconds(start_s);
    CountingFeed feed(200, {64, 48});
    DisplayFilm film(plan_, feed, true, workers_);
    std::vector<std::uint64_t> all;
    while (film.shoot(nullptr)) all.push_back(film.figures().back().picture_hash);
    return all;
  };
  const auto whole = hashes(0, {0, 99});
  ASSERT_EQ(whole.size(), 100u);
  EXPECT_EQ(hashes(0, {90, 92}), (std::vector(whole.begin() + 90, whole.begin() + 93)));
  EXPECT_EQ(hashes(1.5, {0, 2}), (std::vector(whole.begin() + 90, whole.begin() + 93)));
}

TEST(DisplayPlan, RefusesInterlacedVideoOnTheWrongMode) {
  Options options;
  PictureFeed::Facts facts;
  facts.size = {720, 480};
  facts.fields = FieldOrder::kTopFirst;
  EXPECT_THROW(plan_display_film(options, facts), Error);
  options.display.mode = "pal";
  EXPECT_THROW(plan_display_film(options, facts), Error);
  options.display.mode = "ntsc";
  EXPECT_EQ(plan_display_film(options, facts).shot.tube.mode.name, "ntsc");
}

}  // namespace
}  // namespace kinescope
