// Memory: what pictures take, and what is said when there is less.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/demos/parse_json.h"
#include "tests/demos/program_run.h"

// A sanitizer needs address space, and keeps memory, of its own.
#ifndef KINESCOPE_SANITIZED

namespace kinescope::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(ProgramMemory, TheTeapotOnItsTubeTakesLessThan150MiB) {
  TemporaryFolder folder;
  const RunResult run = run_kinescope(
      {"demo", "teapot", "--size", "1280x960", "--headless", "--json", "-o", "teapot.png"},
      {.folder = folder.path()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_LT(parse_json(run.out)["peak_memory_mib"].get<double>(), 150);
}

TEST(ProgramMemory, EveryCommandThatDrawsSaysThatASizeIsTooLarge) {
  TemporaryFolder folder;
  write_text(folder / "m.obj", cube_obj());
  const std::string limit = "ulimit -v 1000000; kinescope ";  // KiB
  for (const std::string command :
       {"render m.obj --json", "render m.obj -o a.png", "render m.obj",
        "render m.obj --display none --depth 16 -o a.png", "demo teapot -o a.png", "demo pipeline",
        "demo retrace --frames 3 -o a.y4m", ""}) {
    const RunResult run =
        run_shell(limit + command + " --size 16384x16384", {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 2) << command << run.err;
    EXPECT_EQ(run.lines_of_err(), 1) << command << run.err;
    EXPECT_THAT(run.err, StartsWith("kinescope: --size: 16384x16384 takes about ")) << command;
    EXPECT_THAT(run.err, HasSubstr(" GiB are free")) << command;
  }
  EXPECT_THAT(folder.files(), ElementsAre("m.obj"));
}

TEST(ProgramMemory, WhatAFilmClaimsTakesNone) {
  TemporaryFolder folder;
  // 16000x16000 pixels in 4:4:4 would be 732 MiB.
  write_text(folder / "a.y4m", "YUV4MPEG2 W16000 H16000 F60:1 C444\nFRAME\nabc");
  const RunResult run = run_shell("ulimit -v 700000; kinescope display a.y4m -o b.y4m --threads 1",
                                  {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 3) << run.err;
  EXPECT_EQ(run.lines_of_err(), 1) << run.err;
  EXPECT_THAT(folder.files(), ElementsAre("a.y4m"));
}

TEST(ProgramMemory, TheSameLimitSufficesForTheUsualSize) {
  TemporaryFolder folder;
  const RunResult run = run_shell("ulimit -v 1000000; kinescope demo frame-buffer -o a.png",
                                  {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(folder.files(), ElementsAre("a.png"));
}

}  // namespace
}  // namespace kinescope::test

#endif
