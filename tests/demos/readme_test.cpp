// The README's ffmpeg examples, run as they stand on a tiny film.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/demos/program_run.h"

namespace kinescope::test {
namespace {

using ::testing::HasSubstr;

/// The indented lines of a section.
std::vector<std::string> commands_of(const std::string& heading) {
  std::istringstream text(read_text(KINESCOPE_SOURCE_DIR "/README.md"));
  std::vector<std::string> commands;
  bool within = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("## ")) within = line == "## " + heading;
    if (within && line.starts_with("    ")) commands.push_back(line.substr(4));
  }
  return commands;
}

class ReadmeFfmpeg : public ::testing::Test {
 protected:
  void shell(const std::string& line) const {
    RunOptions options{.folder = folder_.path()};
    write_text(folder_ / "line.sh", "set -o pipefail\n" + line + "\n");
    const RunResult run = run_shell("bash line.sh", options);
    EXPECT_EQ(run.exit_code, 0) << line << "\n" << run.err;
    EXPECT_EQ(run.err, "") << line;
  }
  /// "WIDTHxHEIGHT,FRAMES" of a film.
  std::string facts(const std::string& film) const {
    const RunResult run = run_shell(
        "ffprobe -v error -count_frames -select_streams v -of csv=p=0:s=x -show_entries "
        "stream=width,height,nb_read_frames " +
            film,
        {.folder = folder_.path()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out.substr(0, run.out.find('\n'));
  }
  TemporaryFolder folder_;
};

TEST_F(ReadmeFfmpeg, ExamplesRunAsTheyStand) {
  // A fifth of a second.
  shell(
      "ffmpeg -v error -f lavfi -i testsrc=size=160x120:rate=25:duration=0.2 -pix_fmt yuv420p "
      "film.mp4");
  const std::vector<std::string> commands = commands_of("In ffmpeg pipelines");
  ASSERT_EQ(commands.size(), 5u);
  for (const std::string& command : commands) {
    EXPECT_THAT(command, HasSubstr("kinescope display "));
    shell(command + "");
  }
  EXPECT_EQ(facts("tube.y4m"), "1280x960x12");  // 0.2 s at 59.94 Hz begin twelve refreshes
  EXPECT_EQ(facts("green.mp4"), "1280x960x12");
  EXPECT_EQ(facts("slices.mkv"), "640x480x49");
  EXPECT_EQ(facts("arcade.mkv"), "960x720x12");
  EXPECT_EQ(facts("plate.mkv"), "1280x960x3");
}

}  // namespace
}  // namespace kinescope::test
