#include "demos/input_script.h"

#include <gmock/gmock.h>

#include "demo_testing.h"
#include "demos/session.h"
#include "raster/base/error.h"
#include "tests/sanitized.h"

namespace kinescope {
namespace {

using ::testing::HasSubstr;

InputScript script(std::string_view text) { return InputScript::parse(text, "demo.script"); }

std::string complaint(std::string_view text) {
  try {
    script(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    return error.what();
  }
  return "no complaint";
}

TEST(InputScript, ReadsEveryVerb) {
  const InputScript read = script(
      "# a demo\n"
      "\n"
      "0 key a   # press it\n"
      "1 move 3 -4\r\n"
      "1 click 5 6 right\n"
      "2 wheel 7 8 -1.5\n"
      "3 text  two words \n"
      "4 resize 320 240");
  const auto first = read.events_at(0);
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0], key_down("a"));
  EXPECT_EQ(first[1].kind, InputKind::kKeyUp);
  const auto second = read.events_at(1);
  ASSERT_EQ(second.size(), 3u);
  EXPECT_EQ(second[0], mouse_event(InputKind::kMouseMove, 3, -4));
  EXPECT_EQ(second[1], mouse_event(InputKind::kMouseDown, 5, 6, MouseButton::kRight));
  EXPECT_EQ(second[2], mouse_event(InputKind::kMouseUp, 5, 6, MouseButton::kRight));
  EXPECT_EQ(read.events_at(2)[0], mouse_event(InputKind::kWheel, 7, 8, MouseButton::kNone, -1.5f));
  EXPECT_EQ(read.events_at(3)[0].key, "two words");
  EXPECT_EQ(read.events_at(4)[0], mouse_event(InputKind::kResize, 320, 240));
  EXPECT_EQ(read.last_frame(), 4);
  EXPECT_TRUE(read.events_at(5).empty());
}

TEST(InputScript, SpellsKeysThatAReaderWouldSwallow) {
  EXPECT_EQ(script("0 key comma").events_at(0)[0].key, ",");
  EXPECT_EQ(script("0 key period").events_at(0)[0].key, ".");
  EXPECT_EQ(script("0 key hash").events_at(0)[0].key, "#");
  EXPECT_EQ(script("0 key [").events_at(0)[0].key, "[");
}

TEST(InputScript, DragMovesEvenlyAndEndsWhereItShould) {
  const InputScript read = script("10 drag 0 100 40 60 4 middle");
  EXPECT_EQ(read.events_at(10),
            std::vector{mouse_event(InputKind::kMouseDown, 0, 100, MouseButton::kMiddle)});
  for (int i = 1; i < 4; ++i) {
    EXPECT_EQ(read.events_at(10 + i),
              std::vector{mouse_event(InputKind::kMouseMove, 10 * i, 100 - 10 * i)});
  }
  const auto last = read.events_at(14);
  ASSERT_EQ(last.size(), 2u);
  EXPECT_EQ(last[0], mouse_event(InputKind::kMouseMove, 40, 60));
  EXPECT_EQ(last[1], mouse_event(InputKind::kMouseUp, 40, 60, MouseButton::kMiddle));
}

TEST(InputScript, LinesMayStandInAnyOrder) {
  const InputScript read = script("7 key b\n3 key a\n7 key c\n");
  EXPECT_EQ(read.events_at(3)[0].key, "a");
  EXPECT_EQ(read.events_at(7)[0].key, "b");
  EXPECT_EQ(read.events_at(7)[2].key, "c");
  EXPECT_EQ(InputScript().last_frame(), -1);
}

TEST(InputScript, ComplaintsNameFileLineAndWord) {
  const std::string where = complaint("0 key a\n\n5 press b\n");
  EXPECT_THAT(where, HasSubstr("demo.script"));
  EXPECT_THAT(where, HasSubstr("line 3"));
  EXPECT_THAT(where, HasSubstr("\"press\""));
  EXPECT_THAT(complaint("key a"), HasSubstr("the frame must be a number, not \"key\""));
  EXPECT_THAT(complaint("-1 key a"), HasSubstr("between 0 and"));
  EXPECT_THAT(complaint("99999999999 key a"), HasSubstr("line 1"));
  EXPECT_THAT(complaint("0"), HasSubstr("what happens is missing"));
  EXPECT_THAT(complaint("0 key"), HasSubstr("key's name is missing"));
  EXPECT_THAT(complaint("0 key a b"), HasSubstr("\"b\" is one word too many"));
  EXPECT_THAT(complaint("0 move 1"), HasSubstr("y is missing"));
  EXPECT_THAT(complaint("0 move 1 99999"), HasSubstr("between"));
  EXPECT_THAT(complaint("0 click 1 1 upper"), HasSubstr("unknown button \"upper\""));
  EXPECT_THAT(complaint("0 drag 1 1 2 2 0"), HasSubstr("number of frames"));
  EXPECT_THAT(complaint("0 wheel 1 1 nan"), HasSubstr("notches"));
  EXPECT_THAT(complaint("0 resize 0 5"), HasSubstr("width"));
  EXPECT_THAT(complaint("0 text   # nothing"), HasSubstr("text is missing"));
}

TEST(InputScript, AMissingFileIsBadInput) {
  try {
    InputScript::read("/nonexistent/demo.script");
    FAIL() << "it was read";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nonexistent/demo.script"));
  }
}

std::vector<std::uint64_t> film(const DemoInfo& info, const DemoFilm& what, int threads = 2) {
  DemoOptions options;
  options.width = 160;
  options.height = 120;
  options.threads = threads;
  std::vector<std::uint64_t> hashes;
  render_demo(info, options, what, [&](std::int64_t frame, const Image<Srgb8>& picture) {
    EXPECT_EQ(frame, what.first_frame + static_cast<std::int64_t>(hashes.size()));
    hashes.push_back(hash_picture(picture));
    return true;
  });
  return hashes;
}

class EveryScript : public EveryDemo {};

TEST_P(EveryScript, RunsFromAScriptTheSameOnAnyNumberOfThreads) {
  DemoFilm what;
  what.last_frame = 9;
  what.script = script("1 drag 40 40 90 70 5\n3 key -\n5 wheel 40 40 1\n7 key Up\n8 key [\n");
  const auto hashes = film(info(), what, 3);
  ASSERT_EQ(hashes.size(), 10u);
  if (kSanitized) return;  // the rest runs nothing new
  EXPECT_EQ(hashes, film(info(), what, 1));
  DemoFilm quiet = what;
  quiet.script = {};
  EXPECT_NE(hashes, film(info(), quiet)) << "the script did nothing";
}

TEST_P(EveryScript, FilmsFromTheMiddleAreTheSameFrames) {
  DemoFilm whole, part;
  whole.last_frame = part.last_frame = kSanitized ? 1 : 6;
  part.first_frame = whole.last_frame - whole.last_frame / 3;
  const auto all = film(info(), whole);
  EXPECT_EQ(film(info(), part), std::vector(all.begin() + part.first_frame, all.end()));
}

INSTANTIATE_TEST_SUITE_P(Script, EveryScript, ::testing::ValuesIn(demo_names()), test_name);

TEST(RenderDemo, StepsBackAndPausesAsTheWindowDoes) {
  DemoFilm what;
  what.last_frame = 6;
  what.script = script("3 key comma\n4 key comma\n");
  const auto hashes = film(find_demo("teapot"), what);
  EXPECT_EQ(hashes[3], hashes[1]);  // frames 0, 1, 2, then back to 1
  EXPECT_EQ(hashes[4], hashes[0]);
  EXPECT_EQ(hashes[5], hashes[4]) << "paused";
}

TEST(RenderDemo, StopsWhenItIsToldTo) {
  DemoFilm what;
  what.last_frame = 1'000'000;
  int frames = 0;
  render_demo(find_demo("pipeline"), {64, 48, 1, 1}, what,
              [&](std::int64_t, const Image<Srgb8>&) { return ++frames < 3; });
  EXPECT_EQ(frames, 3);
}

TEST(RenderDemo, ACameraHasItsOwnRateAndShutter) {
  DemoFilm what;
  what.last_frame = 2;
  what.fps = Rate{24, 1};
  const auto slow = film(find_demo("teapot"), what);
  what.shutter = Seconds(1.0 / 4000);
  EXPECT_NE(slow, film(find_demo("teapot"), what));
  EXPECT_EQ(film_rate(find_demo("teapot"), {}, what).numerator, 24);
  const Rate own = film_rate(find_demo("teapot"), {64, 48, 1, 1}, {});
  EXPECT_NEAR(own.hertz(), 59.94, 0.005);
}

TEST(RenderDemo, RefusesAShutterLongerThanAFrameOrShut) {
  DemoFilm what;
  what.fps = Rate{240, 1};
  EXPECT_THROW(film(find_demo("teapot"), what), Error);
  what.shutter = Seconds(1.0 / 240);
  EXPECT_NO_THROW(film(find_demo("teapot"), what));
  what.shutter = Seconds(0);
  EXPECT_THROW(film(find_demo("teapot"), what), Error);
}

TEST(Registry, NamesAreUniqueAndAnUnknownOneIsToldTheKnown) {
  auto names = demo_names();
  EXPECT_EQ(names.front(), "teapot");
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  for (const DemoInfo& info : all_demos()) {
    EXPECT_FALSE(info.chapter.empty());
    EXPECT_GT(info.summary.size(), 20u);
    EXPECT_FALSE(info.summary.ends_with('.'));
  }
  try {
    find_demo("tepot");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_THAT(error.what(), HasSubstr("teapot, retrace"));
  }
}

}  // namespace
}  // namespace kinescope
