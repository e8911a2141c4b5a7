// The command line from outside: help, its examples, and what bad usage is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/demos/program_run.h"

namespace kinescope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> examples_in(const std::string& help) {
  std::vector<std::string> examples;
  std::istringstream lines(help.substr(help.find("Examples:")));
  for (std::string line; std::getline(lines, line);) {
    // What follows two spaces is a remark.
    if (line.starts_with("  kinescope")) {
      examples.push_back(line.substr(2, line.find("  ", 2) - 2));
    }
  }
  return examples;
}

struct BadUsage {
  std::vector<std::string> arguments;
  std::string named;  ///< what the line must name
};

class Help : public ::testing::TestWithParam<std::string> {};

TEST_P(Help, EveryExampleRuns) {
  const std::vector<std::string> arguments = GetParam().empty()
                                                 ? std::vector<std::string>{"--help"}
                                                 : std::vector<std::string>{GetParam(), "--help"};
  const RunResult help = run_kinescope(arguments);
  ASSERT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  const auto examples = examples_in(help.out);
  ASSERT_GE(examples.size(), 2u) << help.out;
  TemporaryFolder folder;
  write_text(folder / "model.obj", cube_obj());
  for (const std::string& example : examples) {
    const RunResult run = run_shell(example, {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 0) << example << "\n" << run.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Commands, Help, ::testing::Values("", "list", "demo", "render", "timing"),
                         [](const auto& command) {
                           return command.param.empty() ? std::string("gallery") : command.param;
                         });

TEST(ProgramUsage, HelpNamesEveryCommand) {
  const RunResult help = run_kinescope({"--help"});
  for (const char* command : {"list", "demo", "render", "display", "vector", "timing"}) {
    EXPECT_THAT(help.out, HasSubstr(std::string("\n  ") + command + " "));
  }
}

TEST(ProgramUsage, HelpNamesEveryRenderOption) {
  const RunResult help = run_kinescope({"render", "--help"});
  for (const char* option :
       {"-o",          "--size",      "--format",  "--frames",    "--fps",     "--shutter",
        "--threads",   "--simd",      "--seed",    "--display",   "--json",    "--quiet",
        "--headless",  "--help",      "--shading", "--wireframe", "--samples", "--aa",
        "--azimuth",   "--elevation", "--eye",     "--look",      "--up",      "--fov",
        "--turntable", "--depth"}) {
    EXPECT_THAT(help.out, HasSubstr(option));
  }
}

TEST(ProgramUsage, VersionIsOneLine) {
  const RunResult version = run_kinescope({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, ::testing::MatchesRegex("kinescope [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(ProgramUsage, BadUsageIsOneLineThatNamesTheOptionAndHelp) {
  const std::vector<BadUsage> cases{
      {{"no-such-command"}, "no-such-command"},
      {{"render"}, "MODEL"},
      {{"demo"}, "NAME"},
      {{"timing"}, "MODE"},
      {{"render", "m.obj", "--no-such-option"}, "--no-such-option"},
      {{"render", "m.obj", "--size", "12"}, "--size"},
      {{"render", "m.obj", "--size", "0x5"}, "--size"},
      {{"render", "m.obj", "--size", "99999x5"}, "--size"},
      {{"render", "m.obj", "--size", "-3x5"}, "--size"},
      {{"render", "m.obj", "--size"}, "--size"},
      {{"render", "m.obj", "--frames", "9-3"}, "--frames"},
      {{"render", "m.obj", "--frames", "0"}, "--frames"},
      {{"render", "m.obj", "--fps", "0"}, "--fps"},
      {{"render", "m.obj", "--fps", "1/0"}, "--fps"},
      {{"render", "m.obj", "--shutter", "soon"}, "--shutter"},
      {{"render", "m.obj", "--shutter", "-1"}, "--shutter"},
      {{"render", "m.obj", "--threads", "0"}, "--threads"},
      {{"render", "m.obj", "--threads", "two"}, "--threads"},
      {{"render", "m.obj", "--simd", "MMX"}, "MMX"},
      {{"render", "m.obj", "--seed", "x"}, "--seed"},
      {{"render", "m.obj", "--display", "plasma"}, "--display"},
      {{"render", "m.obj", "--shading", "toon"}, "--shading"},
      {{"render", "m.obj", "--samples", "3"}, "--samples"},
      {{"render", "m.obj", "--aa", "2"}, "--aa"},
      {{"render", "m.obj", "--eye", "1,2"}, "--eye"},
      {{"render", "m.obj", "--fov", "200"}, "--fov"},
      {{"render", "m.obj", "--azimuth", "nan"}, "--azimuth"},
      {{"render", "m.obj", "--depth", "12"}, "--depth"},
      {{"render", "m.obj", "--format", "gif"}, "--format"},
      {{"render", "m.obj", "-o", "film.mp4"}, "-o"},
      {{"render", "m.obj", "-o", ""}, "-o"},
      {{"render", "m.obj", "-o", "a.png", "--frames", "5"}, "####"},
      {{"render", "m.obj", "-o", "-", "--json"}, "--json"},
      {{"render", "m.obj", "-o", "a.y4m", "--depth", "16"}, "--depth"},
      {{"render", "m.obj", "-o", "a.png", "--display", "none", "--shutter", "0.1"}, "--shutter"},
      {{"render", "m.obj", "-o", "a.y4m", "--frames", "3", "--fps", "24", "--shutter", "1/10"},
       "--shutter"},
      {{"render", "m.obj", "-o", "a.y4m", "--frames", "3", "--fps", "1000"}, "--fps"},
      {{"demo", "no-such-demo"}, "no-such-demo"},
      {{"demo", "teapot", "--display", "none"}, "--display"},
      {{"timing", "640x"}, "640x"},
      {{"list", "extra"}, "extra"},
  };
  TemporaryFolder folder;
  write_text(folder / "m.obj", cube_obj());
  for (const BadUsage& bad : cases) {
    const RunResult run = run_kinescope(bad.arguments, {.folder = folder.path()});
    std::string line;
    for (const std::string& a : bad.arguments) line += a + " ";
    EXPECT_EQ(run.exit_code, 2) << line << run.err;
    EXPECT_EQ(run.lines_of_err(), 1) << line << run.err;
    EXPECT_EQ(run.out, "") << line;
    EXPECT_THAT(run.err, StartsWith("kinescope: ")) << line;
    EXPECT_THAT(run.err, HasSubstr(bad.named)) << line;
    EXPECT_THAT(run.err, HasSubstr("--help")) << line;
  }
  EXPECT_EQ(folder.files(), std::vector<std::string>{"m.obj"});
}

}  // namespace
}  // namespace kinescope::test
