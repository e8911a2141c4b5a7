// `kinescope list` and `kinescope timing`, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/demos/parse_json.h"
#include "tests/demos/program_run.h"

namespace kinescope::test {
namespace {

using nlohmann::json;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

TEST(ProgramList, TeapotComesFirstAndEachHasALine) {
  const RunResult list = run_kinescope({"list"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_EQ(list.err, "");
  EXPECT_TRUE(list.out.starts_with("teapot "));
  for (const char* name : {"retrace", "frame-buffer", "pipeline", "test-patterns"}) {
    EXPECT_THAT(list.out, HasSubstr(std::string("\n") + name + " "));
  }
}

TEST(ProgramList, JsonSaysTheSame) {
  const json list = parse_json(run_kinescope({"list", "--json"}).out);
  ASSERT_GE(list.size(), 4u);
  EXPECT_EQ(list[0]["name"], "teapot");
  for (const json& demo : list) {
    EXPECT_NE(demo["chapter"], "");
    EXPECT_NE(demo["summary"], "");
  }
}

// VESA's 640x480 at 60 Hz: 25.175 MHz, 640+16+96+48 pixels, 480+10+2+33 lines.
TEST(ProgramTiming, VgaIntervalsInJson) {
  const json mode = parse_json(run_kinescope({"timing", "640x480@60", "--json"}).out);
  EXPECT_EQ(mode["pixel_clock_hz"], 25175000.0);
  EXPECT_EQ(mode["horizontal"]["sync"]["pixels"], 96.0);
  EXPECT_NEAR(mode["horizontal"]["sync"]["us"].get<double>(), 96 / 25.175, 1e-9);
  EXPECT_NEAR(mode["horizontal"]["total"]["us"].get<double>(), 800 / 25.175, 1e-9);
  EXPECT_EQ(mode["vertical"]["back_porch"]["lines"], 33.0);
  EXPECT_EQ(mode["vertical"]["back_porch"]["pixels"], 33.0 * 800);
  EXPECT_NEAR(mode["vertical"]["total"]["us"].get<double>(), 525 * 800 / 25.175, 1e-6);
  EXPECT_EQ(mode["interlaced"], false);
  const double ratio = mode["frame_rate"]["numerator"].get<double>() /
                       mode["frame_rate"]["denominator"].get<double>();
  EXPECT_NEAR(ratio, 25175000.0 / (800 * 525), 1e-12);
  EXPECT_THAT(mode["modeline"].get<std::string>(), HasSubstr("640 656 752 800 480 490 492 525"));
}

TEST(ProgramTiming, TableHoldsTheThreeUnits) {
  const RunResult run = run_kinescope({"timing", "640x480@60"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, HasSubstr("pixels       lines            us"));
  EXPECT_THAT(run.out, ContainsRegex("front porch +16 +0\\.0200 +0\\.636\n"));
  EXPECT_THAT(run.out, ContainsRegex("whole frame +420000 +525 +16683\\.217\n"));
}

TEST(ProgramTiming, ModesNoMonitorHasAreRefused) {
  for (const char* mode : {"0x0@60", "640x480@0", "cvt:640x480@nan", "gtf:99999999x2@60",
                           "Modeline x 25 640 600 500 400 1 1 1 1", ""}) {
    const RunResult run = run_kinescope({"timing", mode});
    EXPECT_EQ(run.exit_code, 2) << mode << run.out;
    EXPECT_EQ(run.lines_of_err(), 1) << mode << run.err;
  }
}

}  // namespace
}  // namespace kinescope::test
