// Bad input, outputs that cannot be written, and being told to stop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/demos/parse_json.h"
#include "tests/demos/program_run.h"

namespace kinescope::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::vector<std::string> kSmall{"--display", "none", "--size", "64x48"};

std::vector<std::string> render(const std::string& model, std::vector<std::string> more) {
  std::vector<std::string> arguments{"render", model};
  arguments.insert(arguments.end(), more.begin(), more.end());
  arguments.insert(arguments.end(), kSmall.begin(), kSmall.end());
  return arguments;
}

TEST(ProgramBadInput, EachIsOneLineThatNamesTheFile) {
  TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> files{
      {"empty.obj", ""},
      {"empty.glb", ""},
      {"truncated.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0"},
      {"truncated.glb", std::string("glTF\2\0\0\0\377\0\0\0", 12)},
      {"truncated.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"},
      {"wrong.gltf", "this is a letter, not a model\n"},
      {"wrong.ply", "PNG, honestly\n"},
      {"no_triangles.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
      {"no_triangles.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"},
      {"out_of_range.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"},
      {"unknown.xyz", "0 0 0\n"},
  };
  for (const auto& [name, text] : files) {
    write_text(folder / name, text);
    const RunResult run = run_kinescope(render(name, {"-o", "a.png"}), {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 3) << name << ": " << run.err;
    EXPECT_EQ(run.lines_of_err(), 1) << name << ": " << run.err;
    EXPECT_THAT(run.err, StartsWith("kinescope: ")) << name;
    EXPECT_THAT(run.err, HasSubstr(name));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png")) << name;
  }
}

TEST(ProgramBadInput, MissingFileAndFolder) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder.obj");
  for (const char* name : {"missing.obj", "folder.obj", "."}) {
    const RunResult run = run_kinescope(render(name, {"-o", "a.png"}), {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 3) << name;
    EXPECT_EQ(run.lines_of_err(), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(name));
  }
  EXPECT_THAT(folder.files(), ElementsAre("folder.obj"));
}

TEST(ProgramBadInput, MissingScriptAndBadScript) {
  TemporaryFolder folder;
  write_text(folder / "bad.txt", "0 key Space\nnever press anything\n");
  for (const auto& [name, place] :
       {std::pair("missing.txt", "missing.txt"), std::pair("bad.txt", "line 2")}) {
    const RunResult run = run_kinescope({"demo", "teapot", "--script", name, "-o", "a.png"},
                                        {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 3) << run.err;
    EXPECT_EQ(run.lines_of_err(), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(name));
    EXPECT_THAT(run.err, HasSubstr(place));
  }
}

TEST(ProgramBadInput, WhatCanBeDrawnIsDrawnWithAWarning) {
  TemporaryFolder folder;
  write_text(folder / "nan.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\nnan inf 0\n3 0 1 2\n3 1 2 3\n");
  write_text(folder / "untextured.mtl", "newmtl m\nKd 1 0 0\nmap_Kd nowhere.png\n");
  write_text(folder / "notpicture.mtl", "newmtl m\nKd 1 0 0\nmap_Kd notpicture.mtl\n");
  for (const char* stem : {"untextured", "notpicture"}) {
    write_text(folder / (std::string(stem) + ".obj"),
               std::string("mtllib ") + stem + ".mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" +
                   "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  }
  for (const char* name : {"nan.off", "untextured.obj", "notpicture.obj"}) {
    const auto arguments = render(name, {"-o", "a.png"});
    const RunResult run = run_kinescope(arguments, {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 0) << name << run.err;
    EXPECT_THAT(run.err, StartsWith("kinescope: warning: ")) << name;
    EXPECT_TRUE(std::filesystem::exists(folder / "a.png"));
    auto quiet = arguments;
    quiet.push_back("--quiet");
    quiet.push_back("--json");
    const RunResult silent = run_kinescope(quiet, {.folder = folder.path()});
    EXPECT_EQ(silent.err, "") << name;
    EXPECT_GE(parse_json(silent.out)["warnings"].size(), 1u) << name;
  }
}

TEST(ProgramBadOutput, FolderMissingOrInTheWayOrReadOnly) {
  TemporaryFolder folder;
  write_text(folder / "m.obj", cube_obj());
  std::filesystem::create_directory(folder / "taken.png");
  for (const char* output : {"missing/a.png", "taken.png", "missing/a.y4m"}) {
    const RunResult run = run_kinescope(render("m.obj", {"-o", output}), {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 4) << run.err;
    EXPECT_EQ(run.lines_of_err(), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(output));
  }
  EXPECT_THAT(folder.files(), ElementsAre("m.obj", "taken.png"));
}

TEST(ProgramBadOutput, OutIsNoFolder) {
  TemporaryFolder folder;
  write_text(folder / "m.obj", cube_obj());
  write_text(folder / "out", "precious");
  const std::vector<std::vector<std::string>> commands{
      render("m.obj", {}), render("m.obj", {"--frames", "2"}), {"demo", "teapot"}, {}};
  for (const auto& arguments : commands) {
    const RunResult run = run_kinescope(arguments, {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 4) << run.err;
    EXPECT_EQ(run.err, "kinescope: out: cannot make the folder: Not a directory\n");
  }
  EXPECT_EQ(read_text(folder / "out"), "precious");
  EXPECT_THAT(folder.files(), ElementsAre("m.obj", "out"));
}

TEST(ProgramBadOutput, FullDisk) {
  TemporaryFolder folder;
  write_text(folder / "m.obj", cube_obj());
  for (const char* format : {"png", "y4m", "raw"}) {
    const RunResult run = run_kinescope(render("m.obj", {"-o", "/dev/full", "--format", format}),
                                        {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 4) << format << run.err;
    EXPECT_EQ(run.lines_of_err(), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr("/dev/full: "));
  }
  for (const std::vector<std::string>& printing :
       {std::vector<std::string>{"--help"}, {"list"}, {"timing", "640x480@60"}, {"--version"}}) {
    const RunResult run = run_kinescope(printing, {.out_path = "/dev/full"});
    EXPECT_EQ(run.exit_code, 4) << printing.front();
    EXPECT_EQ(run.lines_of_err(), 1) << run.err;
  }
}

TEST(ProgramBadOutput, ClosedPipe) {
  TemporaryFolder folder;
  write_text(folder / "m.obj", cube_obj());
  for (const char* format : {"png", "y4m", "raw"}) {
    const RunResult run = run_kinescope(render("m.obj", {"-o", "-", "--format", format}),
                                        {.folder = folder.path(), .close_out = true});
    EXPECT_EQ(run.exit_code, 4) << format << run.err;
    EXPECT_EQ(run.lines_of_err(), 1) << run.err;
  }
}

TEST(ProgramBadOutput, FailureLeavesAnOlderOutputUnharmed) {
  TemporaryFolder folder;
  write_text(folder / "a.png", "precious");
  write_text(folder / "bad.obj", "");
  run_kinescope(render("bad.obj", {"-o", "a.png"}), {.folder = folder.path()});
  EXPECT_EQ(read_text(folder / "a.png"), "precious");
  EXPECT_THAT(folder.files(), ElementsAre("a.png", "bad.obj"));
}

class Stopped : public ::testing::TestWithParam<int> {};

TEST_P(Stopped, ALongFilmLeavesNothingAndHarmsNothing) {
  TemporaryFolder folder;
  write_text(folder / "m.obj", cube_obj());
  write_text(folder / "film.y4m", "precious");
  RunOptions options{.folder = folder.path()};
  options.stop_signal = GetParam();
  options.stop_after_ms = 700;
  const RunResult run =
      run_kinescope(render("m.obj", {"-o", "film.y4m", "--frames", "1000000"}), options);
  EXPECT_EQ(run.exit_code, 128 + GetParam()) << run.err;
  EXPECT_EQ(read_text(folder / "film.y4m"), "precious");
  EXPECT_THAT(folder.files(), ElementsAre("film.y4m", "m.obj"));
}

INSTANTIATE_TEST_SUITE_P(Signals, Stopped, ::testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace kinescope::test
