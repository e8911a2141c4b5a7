// Films that `kinescope render` makes: their frames, their turns and their rate.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <set>

#include "tests/demos/program_render.h"

namespace kinescope::test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(ProgramRender, FilmOfNumberedPictures) {
  run({"--display", "none", "--size", "32x24", "--frames", "8-10", "-o", "f_###.png"});
  EXPECT_THAT(folder_.files(), ElementsAre("f_008.png", "f_009.png", "f_010.png", "model.obj"));
}

TEST_F(ProgramRender, RangeOfABareFilmIsPartOfTheWhole) {
  const std::vector<std::string> common{"--display", "none", "--size", "64x48", "--frames"};
  auto whole = common, part = common;
  whole.push_back("6");
  part.push_back("4-5");
  const json all = figures(whole)["frames"], some = figures(part)["frames"];
  ASSERT_EQ(all.size(), 6u);
  ASSERT_EQ(some.size(), 2u);
  EXPECT_EQ(all[4], some[0]);
  EXPECT_EQ(all[5], some[1]);
  EXPECT_NE(all[4]["colour_hash"], all[5]["colour_hash"]);
}

TEST_F(ProgramRender, TurntableIsOneTurn) {
  // A wedge looks different from every side.
  write_text(folder_ / "model.obj",
             "v 0 0 0\nv 3 0 0\nv 0 0 2\nv 0 1 0\nv 3 2 0\n"
             "f 1 2 3\nf 1 3 4\nf 2 5 3\nf 3 5 4\nf 1 4 5 2\n");
  const std::vector<std::string> common{"--display", "none", "--size", "96x72", "--frames"};
  auto turntable = common;
  turntable.insert(turntable.end(), {"8", "--turntable", "-o", "t#.png"});
  run(turntable);
  const auto frame = [&](int k) {
    return read_image_file(folder_ / ("t" + std::to_string(k) + ".png"));
  };
  for (int quarter = 0; quarter < 4; ++quarter) {
    // Two frames, so that the camera keeps the distance that a turn needs; the first is not turned.
    auto still = common;
    still.insert(still.end(),
                 {"2", "--azimuth", std::to_string(34 + 90 * quarter), "-o", "s#.png"});
    run(still);
    const Image<Srgb8> want = read_image_file(folder_ / "s0.png");
    for (int k = 0; k < 8; ++k) {
      const double apart = difference(frame(k), want);
      EXPECT_EQ(apart < 0.5, k == 2 * quarter) << apart << " at frame " << k << ", " << quarter;
    }
  }
}

TEST_F(ProgramRender, AnyFilmTurnsOnceInSixSeconds) {
  run({"--display", "none", "--size", "64x48", "--fps", "1", "--frames", "7", "-o", "f#.png"});
  const auto frame = [&](const char* name) { return read_image_file(folder_ / name); };
  EXPECT_LT(difference(frame("f0.png"), frame("f6.png")), 0.1);
  EXPECT_GT(difference(frame("f0.png"), frame("f1.png")), 1);
}

TEST_F(ProgramRender, FilmOnTheTubeHasItsRefreshRate) {
  const RunResult film = run({"--size", "64x48", "--frames", "2", "-o", "-"});
  EXPECT_THAT(film.out, StartsWith("YUV4MPEG2 W64 H48 F5035:84 ")) << film.out.substr(0, 60);
}

TEST_F(ProgramRender, FfprobeReadsTheFilm) {
  if (run_shell("command -v ffprobe").exit_code != 0) {
    if (std::getenv("KINESCOPE_REQUIRE_DATA")) FAIL() << "ffprobe is required";
    GTEST_SKIP() << "ffprobe is not here (scripts/setup installs it)";
  }
  const RunResult probe = run_shell(
      "kinescope render model.obj --size 64x48 --frames 3 --fps 30 --display none -o - | ffprobe "
      "-v error -count_frames -show_entries "
      "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 -",
      {.folder = folder_.path()});
  EXPECT_EQ(probe.exit_code, 0) << probe.err;
  EXPECT_EQ(probe.out, "64,48,30/1,3\n");
}

TEST_F(ProgramRender, RawIsThreeBytesAPixel) {
  const RunResult raw =
      run({"--display", "none", "--size", "20x10", "--frames", "2", "--format", "raw", "-o", "-"});
  EXPECT_EQ(raw.out.size(), 20u * 10 * 3 * 2);
}

}  // namespace
}  // namespace kinescope::test
