// kinescope vector as its users start it: streams of real programs, terminals, bad input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "raster/image/codecs.h"
#include "tests/demos/parse_json.h"
#include "tests/demos/program_run.h"

namespace kinescope::test {
namespace {

using namespace std::string_literals;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

int lit_pixels(const std::string& path) {
  int count = 0;
  const Image<Srgb8> picture = read_image_file(path);
  for (const Srgb8 c : picture.pixels()) count += c.g > 100;
  return count;
}

/// The README's line that begins so, without what explains it.
std::string readme_line(const std::string& beginning) {
  std::istringstream text(read_text(KINESCOPE_SOURCE_DIR "/README.md"));
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("    " + beginning)) return line.substr(4);
  }
  return "";
}

TEST(ProgramVector, TheReadmesGnuplotLine) {
  TemporaryFolder folder;
  const std::string line = readme_line("gnuplot ");
  ASSERT_THAT(line, HasSubstr("| kinescope vector - -o plot.png"));
  const RunResult run = run_shell(line, {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_GT(lit_pixels(folder / "plot.png"), 3000);
}

TEST(ProgramVector, TheReadmesGraphLine) {
  TemporaryFolder folder;
  write_text(folder / "data", "0 0\n1 1\n2 4\n3 9\n");
  const std::string line = readme_line("graph ");
  ASSERT_THAT(line, AllOf(HasSubstr("graph -T tek < data | kinescope vector -")));
  const RunResult run = run_shell(line, {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "kinescope: wrote out/vector.png\n") << "there is no window to be had";
  EXPECT_GT(lit_pixels(folder / "out/vector.png"), 3000);
}

TEST(ProgramVector, SegmentsAreFiveNumbersALine) {
  const std::string stream = "\x1d b Ac @\x1d#` @#a @"s;
  const RunResult run = run_kinescope({"vector", "-", "--segments"}, {.input = "\x1d!`!@!a!A"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "128 128 132 132 1\n");
  const RunResult plot =
      run_kinescope({"vector", "-", "--segments"}, {.input = "IN;SP1;PA0,0;PD100.5,7;"});
  EXPECT_EQ(plot.out, "0 0 100.5 7 1\n");
  const RunResult sheet = run_kinescope(
      {"vector", "-", "--segments", "--kind", "svg"},
      {.input = "<svg width='9' height='9'><path stroke='red' opacity='.5' d='M0 0h9'/></svg>"});
  EXPECT_EQ(sheet.out, "0 9 9 9 0.5\n");
}

TEST(ProgramVector, WritesSvgThatItReads) {
  TemporaryFolder folder;
  write_text(folder / "a.hpgl", "IN;SP1;PA0,0;PD4000,0,4000,3000;PU0,100;LBHi\x03");
  const RunResult run =
      run_kinescope({"vector", "a.hpgl", "-o", "a.svg"}, {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const RunResult again =
      run_kinescope({"vector", "a.svg", "-o", "a.png"}, {.folder = folder.path()});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_GT(lit_pixels(folder / "a.png"), 1000);
}

TEST(ProgramVector, PagesAndFigures) {
  const std::string two = "IN;SP1;PA0,0;PD5,0;PG;SP1;PA0,0;PD7,0,7,7;LBx\x03";
  const RunResult figures = run_kinescope({"vector", "-", "--json"}, {.input = two});
  const auto json = parse_json(figures.out);
  EXPECT_EQ(json["segments"], 3);
  EXPECT_EQ(json["texts"], 1);
  EXPECT_EQ(json["pages"], 2);
  TemporaryFolder folder;
  for (const auto& [page, exit_code] : {std::pair("0", 0), std::pair("1", 0), std::pair("2", 2)}) {
    const RunResult run = run_kinescope({"vector", "-", "--page", page, "-o", "a.svg"},
                                        {.folder = folder.path(), .input = two});
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
  }
}

/// What `kinescope vector --pty` makes of a line of shell whose output goes to its terminal.
RunResult draw_on_terminal(const TemporaryFolder& folder, const std::string& line) {
  RunResult run;
  std::filesystem::remove(folder / "name");
  std::thread program([&] {
    run = run_kinescope({"vector", "--pty", "--headless", "--size", "640x480", "-o", "pty.png"},
                        {.folder = folder.path(), .out_path = folder / "name"});
  });
  std::string name;
  for (int i = 0; i < 500 && !name.ends_with('\n'); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (std::filesystem::exists(folder / "name")) name = read_text(folder / "name");
  }
  EXPECT_THAT(name, StartsWith("/dev/pts/"));
  const RunResult drawn = run_shell("{ " + line + "; } > " + name);
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  program.join();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return run;
}

TEST(ProgramVector, ATerminalThatGnuplotDrawsOn) {
  TemporaryFolder folder;
  draw_on_terminal(folder, "gnuplot -e 'set terminal tek40xx; plot sin(x)'");
  EXPECT_GT(lit_pixels(folder / "pty.png"), 1500);
}

TEST(ProgramVector, ATerminalCopiesWhatItShowsWhenAProgramAsks) {
  TemporaryFolder folder;
  // A line, copied, and erased: two bytes each in octal.
  const RunResult run =
      draw_on_terminal(folder, R"(printf '\035!`!@>`>@\033\027\033\014\035!`!@!`!@')");
  EXPECT_EQ(run.err, "kinescope: wrote kinescope-hard-copy-0001.png\n");
  const Image<Srgb8> paper = read_image_file(folder / "kinescope-hard-copy-0001.png");
  int dark = 0;
  for (const Srgb8 c : paper.pixels()) dark += c.g < 128;
  EXPECT_GT(dark, 400);
  EXPECT_LT(lit_pixels(folder / "pty.png"), 100) << "a point";
}

TEST(ProgramVector, ATerminalTellsAPlotterByWhatComes) {
  TemporaryFolder folder;
  draw_on_terminal(folder, "printf 'IN;PC2,255,0,0;SP2;PA0,0;PD4000,0,4000,3000;'");
  int red = 0;
  const Image<Srgb8> picture = read_image_file(folder / "pty.png");
  for (const Srgb8 c : picture.pixels()) red += c.r > 100 && c.g < 60;
  EXPECT_GT(red, 400) << "no storage tube is red";
}

TEST(ProgramVector, BadInputIsOneClearLine) {
  TemporaryFolder folder;
  std::string nonsense;
  for (int i = 0; i < 1000; ++i) nonsense += static_cast<char>(i * 7919 % 251 | 128);
  const std::vector<std::pair<std::string, std::string>> files{
      {"empty", ""},
      {"letter", "Dear friend,\n"},
      {"nothing.tek", "\x1b\x0c"},
      {"random", nonsense},
      {"half.svg", "<svg width='5' height='5'><path d='M0 0"},
      {"none.svg", "<svg/>"},
      {"half.wav", "RIFF1234WAVEfmt "},
      {"packed", "\x1f\x8b\x08"},
  };
  for (const auto& [name, text] : files) {
    write_text(folder / name, text);
    const RunResult run = run_kinescope({"vector", name, "-o", "a.png"}, {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 3) << name << ": " << run.err;
    EXPECT_EQ(run.lines_of_err(), 1) << name << ": " << run.err;
    EXPECT_THAT(run.err, AllOf(StartsWith("kinescope: "), HasSubstr(name)));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
  }
}

TEST(ProgramVector, BadUsage) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> lines{
      {{"vector"}, "nothing to draw"},
      {{"vector", "-", "--kind", "letter"}, "--kind"},
      {{"vector", "a", "--pty"}, "--pty"},
      {{"vector", "-", "-o", "a.gif"}, "a.gif"},
      {{"vector", "-", "--shutter", "1", "-o", "a.png"}, "--shutter"},
      {{"vector", "-", "--machine", "pdp-99"}, "generic"},
      {{"vector", "-", "--hard-copy", "-o", "a.svg"}, "--hard-copy"},
      {{"vector", "-", "--hard-copy", "--frames", "2", "-o", "a_#.png"}, "--hard-copy"},
      {{"vector", "--pty", "--headless", "-o", "a.gif"}, "a.gif"},
      {{"vector", "a", "--assemble", "b"}, "--assemble: "},
      {{"vector", "--assemble", "a", "--disassemble", "b"}, "--disassemble"},
  };
  for (const auto& [arguments, hint] : lines) {
    const RunResult run = run_kinescope(arguments, {.input = "IN;PA0,0;PD1,1"});
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_EQ(run.lines_of_err(), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(hint));
  }
}

constexpr const char* kList =
    "        sync\n        move 100 200\n        draw 2000 200\n        again\n";

TEST(ProgramVector, DisplayFilesThereAndBack) {
  TemporaryFolder folder;
  write_text(folder / "a.txt", kList);
  const RunResult run = run_shell(
      "kinescope vector --assemble a.txt -o a.bin && kinescope vector --disassemble a.bin > b.txt "
      "&& kinescope vector --assemble b.txt -o b.bin && cmp a.bin b.bin && kinescope vector a.bin "
      "--segments && kinescope vector a.txt -o a.png && "
      "kinescope vector a.txt --kind display-file --frames 3 --size 64x48 -o - | head -c 9",
      {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "100 200 2000 200 1\nYUV4MPEG2");
  EXPECT_EQ(read_text(folder / "a.bin").size(), 16u);
  EXPECT_THAT(read_text(folder / "b.txt"), HasSubstr("draw 2000 200"));
  EXPECT_GT(lit_pixels(folder / "a.png"), 400);
}

TEST(ProgramVector, AListMayBeLongerThanItsMachinesMemory) {
  TemporaryFolder folder;
  std::string list = "again: move 100 100\n";
  for (int i = 0; i < 50'000; ++i) list += i % 2 == 0 ? "rdraw 7 5\n" : "rdraw -7 -5\n";
  write_text(folder / "a.txt", list + "jump again\n");
  const RunResult run = run_kinescope({"vector", "a.txt", "--segments"}, {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 50'000);
}

TEST(ProgramVector, ARefreshBeginsWithTheBeamAtItsPlace) {
  TemporaryFolder folder;
  // A line from the corner; the list ends far from it.
  write_text(folder / "a.hpgl", "IN;SP1;PA0,0;PD4000,0;PU4000,3000;PD3999,3000");
  const RunResult run = run_kinescope({"vector", "a.hpgl", "--size", "320x240", "-o", "a.png"},
                                      {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Image<Srgb8> picture = read_image_file(folder / "a.png");
  int along = 0, between = 0;
  for (int x = 0; x < 320; ++x) {
    int most = 0;
    for (int y = 225; y < 240; ++y) most = std::max<int>(most, picture.at(x, y).g);
    along += most > 100;
    for (int y = 20; y < 220; ++y) between += picture.at(x, y).g > 20;
  }
  EXPECT_GT(along, 300);
  EXPECT_EQ(between, 0);
}

/// What is indented in docs/vector.md from one word to another.
std::string list_of_docs(const std::string& beginning, const std::string& end) {
  const std::string text = read_text(KINESCOPE_SOURCE_DIR "/docs/vector.md");
  const std::size_t from = text.find(beginning), to = text.find(end, from);
  return from == std::string::npos ? "" : text.substr(from, to - from);
}

TEST(ProgramVector, TheListOfTheDocsDrawsWhatItSays) {
  TemporaryFolder folder;
  write_text(folder / "list.txt", list_of_docs("    ; list.txt", "    kinescope"));
  const RunResult run =
      run_kinescope({"vector", "list.txt", "--segments"}, {.folder = folder.path()});
  EXPECT_EQ(run.out,
            "1000 1000 1800 1000 1\n1800 1000 1800 1800 1\n1800 1800 1000 1800 1\n"
            "1000 1800 1000 1000 1\n1000 1000 1800 1800 1\n")
      << run.err;
}

TEST(ProgramVector, BadDisplayFilesAreToldByLineOrAddress) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"move 1 2\nfly 3 4\n", "line 2"},
      {"move 1 2\nstart:  jump start\n", "address 1"},
      {"jump 70000\n", "70000"},
      {"a: call a\n", "calls more than 8 deep"},
      {"move 9 9\nchars \"no table\"\n", "address 1: chars before any table of characters"},
      {std::string("\x01\0\0", 3), "3 bytes"},
      {"", "empty"},
  };
  TemporaryFolder folder;
  for (const auto& [text, hint] : files) {
    write_text(folder / "bad", text);
    const RunResult run = run_kinescope({"vector", "bad", "--kind", "display-file", "-o", "a.png"},
                                        {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 3) << text << run.err;
    EXPECT_EQ(run.lines_of_err(), 1) << run.err;
    EXPECT_THAT(run.err, AllOf(HasSubstr("bad"), HasSubstr(hint)));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
  }
}

TEST(ProgramVector, ListsMachines) {
  const RunResult run = run_kinescope({"vector", "--list-machines"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("generic "), HasSubstr("\ndvg "), HasSubstr("\ntype-30 ")));
}

TEST(ProgramVector, TenMillionVectors) {
  TemporaryFolder folder;
  {
    // Each four bytes of a short address: back and forth across the screen.
    std::ofstream file(folder / "many.tek", std::ios::binary);
    file << "\x1b\x0c\x1d";
    std::string lines;
    for (int i = 0; i < 10000; ++i) {
      lines += static_cast<char>(0x20 | i % 24);
      lines += static_cast<char>(0x60 | i % 32);
      lines += static_cast<char>(0x20 | i * 7 % 32);
      lines += static_cast<char>(0x40 | i * 3 % 32);
    }
    for (int i = 0; i < 1000; ++i) file << lines;
  }
  const RunResult run = run_kinescope({"vector", "many.tek", "--json"}, {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(parse_json(run.out)["segments"], 9999999);
}

/// A cube as an OFF file of squares.
constexpr const char* kCube =
    "OFF\n8 6 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n"
    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 2 3 7 6\n4 1 2 6 5\n4 0 4 7 3\n";

TEST(ProgramVector, CopiesAStorageScreenToPaper) {
  TemporaryFolder folder;
  write_text(folder / "a.tek", "\x1b\x0c\x1d!`!@>`>@");
  const RunResult run =
      run_kinescope({"vector", "a.tek", "--hard-copy", "--size", "128x96", "-o", "a.png"},
                    {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Image<Srgb8> paper = read_image_file(folder / "a.png");
  const auto dark = std::count_if(paper.pixels().begin(), paper.pixels().end(),
                                  [](Srgb8 p) { return p.g < 128; });
  EXPECT_GT(dark, 40);
  EXPECT_LT(dark, 400);
  EXPECT_EQ(paper.at(2, 2), (Srgb8{255, 255, 255, 255}));
  const RunResult plot = run_kinescope({"vector", "-", "--hard-copy", "-o", "b.png"},
                                       {.folder = folder.path(), .input = "IN;SP1;PA0,0;PD9,9;"});
  EXPECT_EQ(plot.exit_code, 2);
}

TEST(ProgramVector, ModelsAreWireframes) {
  TemporaryFolder folder;
  write_text(folder / "cube", kCube);  // told by its content
  const auto lines = [&](std::vector<std::string> args) {
    args.insert(args.begin(), {"vector", "cube", "--segments"});
    const RunResult run = run_kinescope(args, {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return std::count(run.out.begin(), run.out.end(), '\n');
  };
  EXPECT_EQ(lines({}), 12);
  EXPECT_EQ(lines({"--hidden"}), 9);
  EXPECT_EQ(lines({"--crease", "0"}), 18);
  EXPECT_EQ(lines({"--hidden", "--azimuth", "0", "--elevation", "0"}), 4);
  const RunResult film = run_shell(
      "kinescope vector cube --hidden --frames 3 --size 96x96 -o spin.y4m --turn 0.5 && "
      "kinescope vector cube --frames 30-31 --size 96x96 -o still_#.png --turn 0 && "
      "kinescope vector --assemble cube --hidden -o cube.bin && "
      "kinescope vector --disassemble cube.bin > cube.txt && "
      "kinescope vector cube.bin --segments",  // told by its words

      {.folder = folder.path()});
  EXPECT_EQ(film.exit_code, 0) << film.err;
  EXPECT_EQ(std::count(film.out.begin(), film.out.end(), '\n'), 9);
  EXPECT_TRUE(read_text(folder / "still_30.png") == read_text(folder / "still_31.png"));
  const RunResult dvg = run_kinescope({"vector", "cube", "--machine", "dvg", "-o", "a.png"},
                                      {.folder = folder.path()});
  EXPECT_EQ(dvg.exit_code, 2);
  EXPECT_THAT(dvg.err, HasSubstr("--machine"));
}

TEST(ProgramVector, OptionsOfModelsAreRefusedForWhatIsNone) {
  TemporaryFolder folder;
  write_text(folder / "plot", "IN;SP1;PA0,0;PD9,9;");
  write_text(folder / "list", "move 1 2\ndraw 3 4\nagain\n");
  const std::vector<std::vector<std::string>> given{
      {"--hidden"}, {"--turn", "3"}, {"--crease", "2"}, {"--azimuth", "10"}, {"--eye", "1,2,3"}};
  for (const char* const input : {"plot", "list"}) {
    for (std::vector<std::string> args : given) {
      const std::string option = args.front();
      args.insert(args.begin(), {"vector", input, "-o", "a.png"});
      const RunResult run = run_kinescope(args, {.folder = folder.path()});
      EXPECT_EQ(run.exit_code, 2) << run.err;
      EXPECT_EQ(run.lines_of_err(), 1) << run.err;
      EXPECT_THAT(run.err, AllOf(HasSubstr(option), HasSubstr("model"), HasSubstr(input)));
      EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
    }
  }
  const RunResult words =
      run_kinescope({"vector", "--assemble", "list", "--hidden"}, {.folder = folder.path()});
  EXPECT_EQ(words.exit_code, 2) << words.err;
}

}  // namespace
}  // namespace kinescope::test
