// Films in a window, without the window.
#include "demos/film_screen.h"

#include <atomic>
#include <cmath>
#include <thread>
#include <tuple>

#include "counting_feed.h"
#include "demo_testing.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr Rate kSixty{60, 1};

DisplayPlan small_plan(Rate input) {
  DisplayPlan plan;
  plan.shot.tube.mode = {"small", 360000, {64, 8, 12, 16}, {48, 2, 2, 8}, false};  // 60 Hz
  plan.shot.signal = TubeSignal::kGunDrive;
  plan.shot.size = {128, 96};
  plan.shot.aspect = 4.0 / 3;
  plan.refresh = plan.rate = kSixty;
  plan.input_rate = input;
  plan.shot.shutter = plan.shot.every = kSixty.period();
  plan.open_ended = true;
  return plan;
}

class FilmScreenTest : public ::testing::Test {
 protected:
  void open(const DisplayPlan& plan, std::unique_ptr<PictureFeed> feed,
            std::optional<Seconds> shutter = {}, Rate monitor = {60, 1}) {
    screen_.emplace("film", plan, std::move(feed), window_pace(shutter, monitor, kSixty),
                    test_studio());
    press("Tab");  // no line of state over the picture
  }
  void open(int count, Rate input, std::optional<Seconds> shutter = {}, Rate monitor = {60, 1}) {
    open(small_plan(input), std::make_unique<CountingFeed>(count, Size{64, 48}, false, 20), shutter,
         monitor);
  }
  void press(const std::string& key) { screen_->handle(key_down(key)); }
  /// Ticks until the picture is another one; the film is read on a thread of its own.
  void next() {
    const Seconds before = screen_->time();
    for (int i = 0; i < 2000 && screen_->time() == before; ++i) {
      screen_->tick(60);
      if (screen_->time() == before) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  /// The mean light of the picture.
  double light() const {
    double sum = 0;
    for (const Srgb8 c : screen_->frame().pixels()) sum += static_cast<double>(decode(c).g);
    return sum / static_cast<double>(screen_->frame().pixels().size());
  }
  /// The number of the film's picture on the screen.
  int number() const {
    const double drive = 255 * std::pow(light(), 1 / 2.35);
    return static_cast<int>(std::lround(drive / 20));
  }
  std::optional<FilmScreen> screen_;
};

TEST_F(FilmScreenTest, PlaysAtTheFilmsRate) {
  for (const auto& [input, want] : {std::pair{Rate{60, 1}, std::vector{0, 1, 2, 3, 4, 5}},
                                    {Rate{30, 1}, {0, 0, 1, 1, 2, 2}},
                                    {Rate{24, 1}, {0, 0, 0, 1, 1, 2, 2, 2, 3}},
                                    {Rate{120, 1}, {0, 2, 4, 6}}}) {
    open(10, input);
    std::vector<int> numbers;
    for (std::size_t i = 0; i < want.size(); ++i) {
      next();
      numbers.push_back(number());
    }
    EXPECT_EQ(numbers, want) << input.hertz();
    EXPECT_NEAR(screen_->time().count(), static_cast<double>(want.size()) / 60, 1e-9);
  }
}

TEST_F(FilmScreenTest, ItsLastPictureStays) {
  open(3, kSixty);
  for (int i = 0; i < 8; ++i) next();
  EXPECT_EQ(number(), 2);
}

TEST_F(FilmScreenTest, EndsWithTheLastFrameThatWasAskedFor) {
  DisplayPlan plan = small_plan(kSixty);
  plan.cut = true;
  plan.frames = {2, 4};
  open(plan, std::make_unique<CountingFeed>(10, Size{64, 48}, false, 20));
  std::vector<int> numbers;
  for (int i = 0; i < 3; ++i) next(), numbers.push_back(number());
  EXPECT_EQ(numbers, (std::vector{2, 3, 4}));
  const Seconds last = screen_->time();
  for (int i = 0; i < 3; ++i) screen_->tick(60);
  EXPECT_TRUE(screen_->transport().paused());
  press("Space");
  for (int i = 0; i < 3; ++i) screen_->tick(60);
  EXPECT_EQ(screen_->time(), last);
  press(",");
  next();
  EXPECT_LT(screen_->time(), last);
}

TEST_F(FilmScreenTest, PausesAndSteps) {
  open(10, kSixty);
  for (int i = 0; i < 4; ++i) next();
  press("Space");
  const Seconds paused = screen_->time();
  for (int i = 0; i < 5; ++i) screen_->tick(60);
  EXPECT_EQ(screen_->time(), paused);
  EXPECT_EQ(number(), 3);
  press(".");
  next();
  EXPECT_EQ(number(), 4);
  screen_->tick(60);
  EXPECT_EQ(number(), 4);
  press("Space");
  next();
  EXPECT_EQ(number(), 5);
}

TEST_F(FilmScreenTest, StepsBackToTheVeryPicturesAndOnFromThere) {
  open(10, kSixty);
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < 6; ++i) next(), hashes.push_back(hash_picture(screen_->frame()));
  for (int i = 4; i >= 0; --i) {
    press(",");
    screen_->tick(60);
    ASSERT_EQ(hash_picture(screen_->frame()), hashes[static_cast<std::size_t>(i)]) << i;
  }
  press(",");  // there is no older one
  screen_->tick(60);
  press("Space");
  for (int i = 1; i < 6; ++i) {
    screen_->tick(60);
    if (i > 1) continue;  // the remark lies over the picture for a while
    EXPECT_NEAR(screen_->time().count(), 2.0 / 60, 1e-9);
  }
  EXPECT_NEAR(screen_->time().count(), 6.0 / 60, 1e-9);
  next();
  EXPECT_NEAR(screen_->time().count(), 7.0 / 60, 1e-9);
}

TEST_F(FilmScreenTest, SlowMotionMovesThroughARefresh) {
  open(10, kSixty);
  next();
  press("[");  // half speed
  next();
  EXPECT_NEAR(screen_->time().count(), 1.5 / 60, 1e-9);
  press("[");
  press("[");
  press("[");
  next();
  EXPECT_NEAR(screen_->time().count(), 1.55 / 60, 1e-9);
  for (int i = 0; i < 4; ++i) press("]");
  next();  // across the beginning of a refresh
  EXPECT_NEAR(screen_->time().count(), 2.55 / 60, 1e-9);
}

TEST_F(FilmScreenTest, ItsSizeFollowsTheWindow) {
  open(10, kSixty);
  next();
  screen_->handle(mouse_event(InputKind::kResize, 320, 96));
  next();
  EXPECT_EQ(screen_->frame().width(), 320);
  EXPECT_EQ(screen_->frame().height(), 96);
  EXPECT_EQ(screen_->frame().at(10, 48).g, 0);  // beside the tube
  EXPECT_GT(screen_->frame().at(160, 48).g, 5);
}

TEST_F(FilmScreenTest, AStillPictureCostsNothingOnceItIsSteady) {
  DisplayPlan plan = small_plan(kSixty);
  plan.open_ended = false;
  open(plan, std::make_unique<CountingFeed>(1, Size{64, 48}, true, 1, 90));
  for (int i = 0; i < 20; ++i) next();
  int drawn = 0;
  for (int i = 0; i < 20; ++i) drawn += screen_->tick(60);
  EXPECT_EQ(drawn, 0);
}

/// A feed that gives its pictures when it is told to.
class SlowFeed : public CountingFeed {
 public:
  explicit SlowFeed(std::atomic<int>& given)
      : CountingFeed(10, {64, 48}, false, 20), given_(given) {}
  bool next(Image<Srgb8>& picture) override {
    while (shown_ >= given_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ++shown_;
    return CountingFeed::next(picture);
  }

 private:
  std::atomic<int>& given_;
  int shown_ = 0;
};

TEST_F(FilmScreenTest, AStepThatTheFilmIsTooSlowForIsTakenLater) {
  std::atomic<int> given = 3;
  open(small_plan(kSixty), std::make_unique<SlowFeed>(given));
  next();
  press("Space");
  press(".");
  for (int i = 0; i < 5; ++i) screen_->tick(60);
  EXPECT_EQ(number(), 0);
  given = 100;
  next();
  EXPECT_EQ(number(), 1);
  for (int i = 0; i < 5; ++i) screen_->tick(60);
  EXPECT_EQ(number(), 1);
}

/// A feed that fails after some pictures.
class FaultyFeed : public CountingFeed {
 public:
  FaultyFeed() : CountingFeed(100, {64, 48}) {}
  bool next(Image<Srgb8>& picture) override {
    if (left_-- == 0) throw_bad_input("the film ends within a frame", "film.y4m");
    return CountingFeed::next(picture);
  }

 private:
  int left_ = 3;
};

TEST_F(FilmScreenTest, AFaultComesWhenItsPictureIsDue) {
  open(small_plan(kSixty), std::make_unique<FaultyFeed>());
  int shown = 0;
  try {
    for (; shown < 10; ++shown) next();
    FAIL() << "no fault";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "film.y4m: the film ends within a frame");
    EXPECT_EQ(shown, 3);
  }
}

/// A feed that waits for ever, until it is told not to.
class StalledFeed : public CountingFeed {
 public:
  StalledFeed() : CountingFeed(2, {64, 48}) {}
  bool next(Image<Srgb8>& picture) override {
    if (CountingFeed::next(picture)) return true;
    while (!interrupted_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return false;
  }
  void interrupt() override { interrupted_ = true; }

 private:
  std::atomic<bool> interrupted_ = false;
};

TEST_F(FilmScreenTest, TimeWaitsForAFilmThatDoesNotCome) {
  open(small_plan({20, 1}), std::make_unique<StalledFeed>());
  for (int i = 0; i < 40; ++i) {
    screen_->tick(60);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  // Pictures of a refresh and of what begins in it are at hand for so long.
  EXPECT_LE(screen_->time().count(), 0.1);
  screen_.reset();  // and nobody waits
}

/// A grey picture, dim enough that no slice of it is cut to white.
class Slices : public FilmScreenTest {
 protected:
  void show(std::optional<Seconds> shutter, Rate monitor, std::optional<double> gain) {
    DisplayPlan plan = small_plan(kSixty);
    plan.open_ended = false;
    plan.shot.gain = gain;
    open(plan, std::make_unique<CountingFeed>(1, Size{64, 48}, true, 1, kGrey), shutter, monitor);
    for (int i = 0; i < 100 && screen_->time() == Seconds(0); ++i) {
      screen_->tick(60);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  static constexpr int kGrey = 100;
  const double steady_ = std::pow(kGrey / 255.0, 2.35);
};

TEST_F(Slices, OfAFastMonitorAddUpToTheRefresh) {
  show(Seconds(1.0 / 240), {240, 1}, 1);
  EXPECT_NEAR(screen_->tick_length().count(), 1.0 / 240, 1e-12);
  double sum = light();
  for (int i = 0; i < 3; ++i) screen_->tick(60), sum += light();
  EXPECT_NEAR(sum, steady_, 0.04 * steady_);
}

TEST_F(Slices, RollDownTheScreen) {
  show(Seconds(1.0 / 240), {240, 1}, {});
  for (int slice = 0; slice < 3; ++slice) {
    if (slice > 0) screen_->tick(60);
    // 62 lines a refresh: a slice lights 15.5 of the 48 in the picture, two rows each.
    const auto row_light = [&](int y) {
      return static_cast<double>(decode(screen_->frame().at(64, y)).g);
    };
    EXPECT_GT(row_light(31 * slice + 15), 0.7 * 4 * steady_) << slice;
    EXPECT_LT(row_light((31 * slice + 50) % 96), 0.5 * steady_) << slice;
  }
}

TEST_F(Slices, AutomaticGainShowsALitLineAsBrightAsItsLight) {
  show(Seconds(1.0 / 240), {240, 1}, {});
  double sum = light();
  for (int i = 0; i < 3; ++i) screen_->tick(60), sum += light();
  EXPECT_NEAR(sum / 4, steady_, 0.04 * steady_);
}

TEST_F(Slices, ABlackFrameFollowsWhereTheMonitorHasTwo) {
  show(Seconds(1.0 / 60), {120, 1}, {});
  EXPECT_NEAR(screen_->tick_length().count(), 1.0 / 120, 1e-12);
  for (int i = 0; i < 6; ++i) {
    const bool black = light() == 0;
    EXPECT_TRUE(black || std::abs(light() - steady_) < 0.04 * steady_);
    screen_->tick(60);
    EXPECT_NE(light() == 0, black) << i;
  }
  press("Space");  // what is paused is not black
  screen_->tick(60);
  EXPECT_NEAR(light(), steady_, 0.04 * steady_);
}

TEST(WindowPace, FitsSlicesToTheMonitor) {
  const auto pace = [](std::optional<double> shutter, Rate monitor) {
    return window_pace(shutter ? std::optional(Seconds(*shutter)) : std::nullopt, monitor, kSixty);
  };
  EXPECT_EQ(pace({}, {240, 1}).ticks, 1);
  EXPECT_EQ(pace({}, {240, 1}).exposure, kSixty.period());
  for (const auto& [shutter, hz, ticks] : {std::tuple{1.0 / 240, 240, 1},
                                           {1.0 / 120, 240, 2},
                                           {1.0 / 60, 240, 4},
                                           {1.0 / 60, 60, 1},
                                           {1001.0 / 60000, 60, 1},
                                           {1.0 / 144, 143, 1},
                                           {1.0 / 72, 144, 2}}) {
    const WindowPace p = pace(shutter, {hz, 1});
    EXPECT_EQ(p.remark, "") << shutter;
    EXPECT_EQ(p.ticks, ticks) << shutter;
    EXPECT_DOUBLE_EQ(p.exposure.count(), shutter);
    EXPECT_DOUBLE_EQ(p.tick.count() * ticks, shutter);
  }
  for (const auto& [shutter, hz] :
       {std::pair{1.0 / 240, 60}, {1.0 / 4000, 240}, {1.0 / 100, 144}, {1.0 / 60, 75}}) {
    const WindowPace p = pace(shutter, {hz, 1});
    EXPECT_EQ(p.exposure, kSixty.period()) << shutter;
    EXPECT_EQ(p.ticks, 1);
    EXPECT_NE(p.remark.find("whole refreshes of the tube are shown"), std::string::npos);
  }
}

}  // namespace
}  // namespace kinescope
