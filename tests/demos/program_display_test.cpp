// `kinescope display` from outside: what it takes, what comes out, and how it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <cmath>

#include "raster/image/codecs.h"
#include "tests/demos/parse_json.h"
#include "tests/demos/program_run.h"

namespace kinescope::test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Image<Srgb8> painting(int width, int height, int shift = 0) {
  Image<Srgb8> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.at(x, y) = {static_cast<std::uint8_t>((x + shift) * 255 / width),
                          static_cast<std::uint8_t>(y * 255 / height),
                          static_cast<std::uint8_t>(x / 8 % 2 * 200), 255};
    }
  }
  return picture;
}

std::string rgb24(const Image<Srgb8>& picture) {
  std::string bytes;
  for (const Srgb8 p : picture.pixels()) {
    for (const std::uint8_t channel : {p.r, p.g, p.b}) bytes += static_cast<char>(channel);
  }
  return bytes;
}

std::string y4m_header(int width, int height) {
  return "YUV4MPEG2 W" + std::to_string(width) + " H" + std::to_string(height) + " F60:1 Ip C444\n";
}

std::string grey_frame(int width, int height, char code) {
  const std::size_t count = static_cast<std::size_t>(width * height);
  return "FRAME\n" + std::string(count, code) + std::string(2 * count, '\x80');
}

class ProgramDisplay : public ::testing::Test {
 protected:
  RunResult run(std::vector<std::string> arguments, const std::string& input = {}) const {
    arguments.insert(arguments.begin(), "display");
    return run_kinescope(arguments, {.folder = folder_.path(), .input = input});
  }
  void good(std::vector<std::string> arguments, const std::string& input = {}) const {
    const RunResult result = run(std::move(arguments), input);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
  }
  /// The picture of a run on the smallest of tubes.
  Image<Srgb8> picture(std::vector<std::string> arguments, const std::string& input = {}) const {
    arguments.insert(arguments.end(), {"-o", "a.png"});
    good(std::move(arguments), input);
    return read_image_file(folder_ / "a.png");
  }
  json figures(std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const RunResult result = run(std::move(arguments));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return parse_json(result.out);
  }
  TemporaryFolder folder_;
};

// 60 Hz exactly; CVT's steps of 250 kHz come no nearer than 50.
const std::string kTinyMode = "\"tiny\" 1.68 160 168 184 200 120 122 124 140";
const std::vector<std::string> kSmall{"--mode", kTinyMode, "--size", "320x240"};

std::vector<std::string> small(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), kSmall.begin(), kSmall.end());
  return arguments;
}

TEST_F(ProgramDisplay, APictureLooksLikeItself) {
  const Image<Srgb8> original = painting(160, 120);
  write_png(folder_ / "in.png", original);
  const Image<Srgb8> out = picture(small({"in.png"}));
  ASSERT_EQ(out.width(), 320);
  ASSERT_EQ(out.height(), 240);
  // Gamma correction keeps the tones; blocks of 16x16 are compared, scan lines averaged in light.
  for (int by = 16; by < 224; by += 16) {
    for (int bx = 16; bx < 304; bx += 16) {
      double seen = 0, meant = 0;
      for (int i = 0; i < 256; ++i) {
        seen += decode(out.at(bx + i % 16, by + i / 16)).g / 256;
        meant += decode(original.at((bx + i % 16) / 2, (by + i / 16) / 2)).g / 256;
      }
      ASSERT_NEAR(seen, meant, 0.03 + 0.05 * meant) << bx << ' ' << by;
    }
  }
}

TEST_F(ProgramDisplay, EverySettingThatIsGivenCounts) {
  const auto shown = [&](std::vector<std::string> changes) {
    std::vector<std::string> arguments = {"pattern:dots", "--quiet", "--size",
                                          "160x120",      "-o",      "set.png"};
    for (const std::string& change : changes) {
      arguments.insert(arguments.end(), {"--set", change});
    }
    good(arguments);
    const Image<Srgb8> picture = read_image_file(folder_ / "set.png");
    return std::vector<Srgb8>(picture.pixels().begin(), picture.pixels().end());
  };
  const std::string narrow = "deflection.width=50%", low = "deflection.height=50%";
  const auto both = shown({narrow, low});
  EXPECT_EQ(both, shown({low, narrow}));
  EXPECT_NE(both, shown({narrow}));
  EXPECT_NE(both, shown({low}));
}

TEST_F(ProgramDisplay, EveryWayInGivesTheSamePicture) {
  const Image<Srgb8> original = painting(160, 120);
  write_png(folder_ / "in.png", original);
  write_png(folder_ / "shot_007.png", original);
  write_text(folder_ / "in.raw", rgb24(original));
  const Image<Srgb8> expected = picture(small({"in.png"}));
  EXPECT_EQ(picture(small({"-"}), read_text(folder_ / "in.png")), expected);
  EXPECT_EQ(picture(small({"shot_###.png", "--frames", "1"})), expected);
  EXPECT_EQ(picture(small({"in.raw", "--raw", "rgb24:160x120@60", "--frames", "1"})), expected);
  EXPECT_EQ(picture(small({"-", "--raw", "rgb24:160x120@60", "--frames", "1"}), rgb24(original)),
            expected);
}

TEST_F(ProgramDisplay, FilmsComeOutAsTheyAreAskedFor) {
  write_text(folder_ / "in.y4m", y4m_header(16, 12) + grey_frame(16, 12, '\x60') +
                                     grey_frame(16, 12, '\x7f') + grey_frame(16, 12, '\x50'));
  const auto tiny = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "in.y4m");
    arguments.insert(arguments.end(), {"--mode", kTinyMode, "--size", "32x24", "--fps", "60"});
    return arguments;
  };
  good(tiny({"-o", "f_##.png"}));
  EXPECT_THAT(folder_.files(), ElementsAre("f_00.png", "f_01.png", "f_02.png", "in.y4m"));
  const RunResult raw = run(tiny({"-o", "-", "--format", "raw"}));
  EXPECT_EQ(raw.out.size(), 3u * 32 * 24 * 3);
  EXPECT_EQ(raw.out.substr(0, 32 * 24 * 3), rgb24(read_image_file(folder_ / "f_00.png")));
  const RunResult film = run(tiny({"-o", "-"}));
  EXPECT_THAT(film.out, StartsWith("YUV4MPEG2 W32 H24 F60:1 "));
  good(tiny({"-o", "a.y4m"}));
  EXPECT_EQ(read_text(folder_ / "a.y4m"), film.out);
  const RunResult piped =
      run({"-", "-o", "-", "--mode", kTinyMode, "--size", "32x24", "--fps", "60"},
          read_text(folder_ / "in.y4m"));
  EXPECT_EQ(piped.out, film.out);
}

TEST_F(ProgramDisplay, SixteenBitsAndManyThreadsAndSizes) {
  good({"pattern:grey-steps", "--size", "64x48", "--depth", "16", "-o", "deep.png"});
  EXPECT_EQ(read_text(folder_ / "deep.png")[24], 16);  // bits in the header
  const json one = figures({"pattern:zone-plate", "--frames", "3", "--threads", "1"});
  const json three = figures({"pattern:zone-plate", "--frames", "3", "--threads", "3"});
  EXPECT_EQ(one["frames"], three["frames"]);
  EXPECT_EQ(one["width"], 1280);
  EXPECT_EQ(one["height"], 960);
  EXPECT_EQ(one["frames"].size(), 3u);
  const json wide = figures({"pattern:dots", "--mode", "240p", "--aspect", "16:9"});
  EXPECT_EQ(wide["height"], 960);
  EXPECT_EQ(wide["width"], 1707);
}

double mean_light(const Image<Srgb8>& picture) {
  double sum = 0;
  for (const Srgb8 p : picture.pixels()) sum += decode(p).g;
  return sum / static_cast<double>(picture.pixels().size());
}

TEST_F(ProgramDisplay, GainIsByTheShutterOrByTheRefresh) {
  const auto light = [&](std::vector<std::string> more) {
    more.insert(more.begin(), "pattern:grey-steps");
    return mean_light(picture(small(std::move(more))));
  };
  const double whole = light({});
  EXPECT_NEAR(light({"--gain", "1"}), whole, 1e-6);
  EXPECT_NEAR(light({"--gain", "0.5"}), whole / 2, 0.01 * whole);
  // A thousandth of a second is 6% of a refresh.
  EXPECT_LT(light({"--gain", "1", "--shutter", "1/1000"}), 0.12 * whole);
  EXPECT_LT(light({"--gain", "1", "--shutter", "1/1000"}),
            0.5 * light({"--gain", "auto", "--shutter", "1/1000"}));
}

TEST_F(ProgramDisplay, QuartersOfARefreshAddUpToIt) {
  // The mode's refresh is 25175000/420000 Hz.
  const std::vector<std::string> tube{"pattern:smpte-bars", "--size", "160x120", "--gain", "1"};
  auto whole = tube, slices = tube;
  whole.insert(whole.end(), {"-o", "whole.png"});
  slices.insert(slices.end(), {"--fps", "25175000/105000", "--shutter", "105000/25175000",
                               "--frames", "4", "-o", "slice_#.png"});
  good(whole);
  good(slices);
  const Image<Srgb8> sum = read_image_file(folder_ / "whole.png");
  std::vector<Image<Srgb8>> parts;
  for (int i = 0; i < 4; ++i) {
    parts.push_back(read_image_file(folder_ / ("slice_" + std::to_string(i) + ".png")));
  }
  int dark = 0;
  for (std::size_t i = 0; i < sum.pixels().size(); ++i) {
    double light = 0;
    for (const auto& part : parts) light += decode(part.pixels()[i]).r;
    ASSERT_NEAR(light, decode(sum.pixels()[i]).r, 0.012) << i;  // of rounding to codes
    dark += decode(parts[0].pixels()[i]).r < 0.3f * decode(sum.pixels()[i]).r;
  }
  EXPECT_GT(dark, 160 * 120 / 4) << "a slice shows what the beam passed, not all";
}

TEST_F(ProgramDisplay, AFourThousandthOfASecondCatchesFourLines) {
  write_png(folder_ / "white.png", Image<Srgb8>(320, 240, {255, 255, 255, 255}));
  const Image<Srgb8> p = picture({"white.png", "--mode", "240p", "--shutter", "1/4000", "--start",
                                  "0.005", "--size", "320x240", "--gain", "1"});
  // 1/4000 s of 63.556 us a line is 3.93 lines. Blue fades fastest.
  float brightest = 0;
  for (int y = 0; y < 240; ++y) brightest = std::max(brightest, decode(p.at(160, y)).b);
  int lit = 0;
  for (int y = 0; y < 240; ++y) lit += decode(p.at(160, y)).b > 0.5f * brightest;
  EXPECT_GE(lit, 3);
  EXPECT_LE(lit, 5);
}

TEST_F(ProgramDisplay, ListsItsPresets) {
  const RunResult table = run({"--list-presets"});
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_THAT(table.out, testing::ContainsRegex("vga-colour +640x480@60"));
  for (const json& preset : parse_json(run({"--list-presets", "--json"}).out)) {
    EXPECT_THAT(table.out, HasSubstr(preset["name"].get<std::string>()));
  }
}

TEST_F(ProgramDisplay, WithoutAnOutputItWritesToOut) {
  const RunResult result = run({"pattern:dots", "--size", "32x24"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "kinescope: wrote out/pattern-dots.png\n");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/pattern-dots.png"));
}

TEST_F(ProgramDisplay, InterlacedVideoWantsAnInterlacedMode) {
  const std::string film = "YUV4MPEG2 W72 H480 F30000:1001 It C444\n" + grey_frame(1, 1, 'a');
  const RunResult refused = run({"-", "-o", "a.y4m"}, film);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--mode: the video is interlaced with 480 lines"));
  EXPECT_EQ(refused.lines_of_err(), 1);
  write_text(folder_ / "in.y4m", "YUV4MPEG2 W16 H480 F30000:1001 Ib C444\n" +
                                     grey_frame(16, 480, '\x60') + grey_frame(16, 480, '\x60'));
  good({"in.y4m", "--mode", "ntsc", "--size", "64x48", "-o", "a.y4m"});
}

struct Refused {
  std::vector<std::string> arguments;
  std::string input;
  int exit_code;
  std::string line;
};

TEST_F(ProgramDisplay, RefusesInOneLine) {
  write_png(folder_ / "a.png", Image<Srgb8>(8, 8));
  write_png(folder_ / "s_1.png", Image<Srgb8>(8, 8));
  write_png(folder_ / "s_2.png", Image<Srgb8>(9, 8));
  write_text(folder_ / "text.txt", "a letter\n");
  const std::string film = y4m_header(8, 8) + grey_frame(8, 8, 'a');
  for (const Refused& r : std::vector<Refused>{
           {{}, "", 2, "nothing to show"},
           {{"-"}, "", 3, "standard input: empty"},
           {{"-", "--raw", "rgb24:8x8@60"}, "", 3, "standard input: an empty file"},
           {{"-", "--raw", "rgb24:8x8@60"}, std::string(200, 'a'), 3, "in the middle of a frame"},
           {{"-", "--raw", "nv12:8x8@60"}, "", 2, "\"nv12\" is not a format of raw video"},
           {{"-", "--raw", "rgb24:8x8"}, "", 2, "is not raw video such as"},
           {{"-", "--raw", "rgb24:0x8@60"}, "", 2, "\"0x8\" is not a size"},
           {{"-", "--raw", "rgb24:8x8@0"}, "", 2, "\"0\" is not a rate"},
           {{"-", "--raw", "rgb24:32768x32768@1"}, "", 2, "pixels"},
           {{"-"}, film.substr(0, 150), 3, "frame 0: the film ends in the middle of a frame"},
           {{"-"}, film + y4m_header(4, 8), 3, "changes its size from 8x8 to 4x8"},
           {{"-"}, y4m_header(8, 8), 3, "a film without frames"},
           {{"-"}, y4m_header(31623, 31623), 3, "31623x31623 pixels is too large"},
           {{"-"}, y4m_header(16000, 16000), 3, "standard input"},
           {{"missing.png"}, "", 3, "missing.png: cannot be read"},
           {{"."}, "", 3, "cannot be read"},
           {{"text.txt"}, "", 3, "text.txt: neither a PNG nor a JPEG"},
           {{"none_##.png"}, "", 3, "there are no pictures with such names"},
           {{"s_#.png"}, "", 3, "s_2.png: the sequence changes its size from 8x8 to 9x8"},
           {{"pattern:nothing"}, "", 2, "there are smpte-bars, ebu-bars"},
           {{"a.png", "--shutter", "0"}, "", 2, "--shutter: \"0\""},
           {{"a.png", "--shutter", "-1/60"}, "", 2, "--shutter: \"-1/60\""},
           {{"a.png", "--frames", "2", "--fps", "1000"}, "", 2, "--fps: the shutter stays open"},
           {{"a.png", "--gain", "0"}, "", 2, "--gain"},
           {{"a.png", "--gain", "-1"}, "", 2, "--gain"},
           {{"a.png", "--start", "-1"}, "", 2, "--start"},
           {{"a.png", "--fit", "wide"}, "", 2, "--fit"},
           {{"a.png", "--display", "none"}, "", 2, "no display is called \"none\""},
           {{"a.png", "--mode", "640x480"}, "", 2, "640x480"},
           {{"a.png", "--mode", "640x0@60"}, "", 2, "640x0@60"},
           {{"a.png", "--mode", "\"z\" 25 640 640 640 640 480 481 482 483"}, "", 2, "sync is 0"},
           {{"a.png", "--mode", "\"z\" 25 640 656 600 800 480 490 492 525"}, "", 2, "sync is -56"},
           {{"a.png", "--mode", "\"z\" 0 640 656 752 800 480 490 492 525"}, "", 2, "pixel clock"},
           {{"a.png", "--depth", "16", "--frames", "2"}, "", 2, "only PNG takes 16 bits"},
           {{"-", "--start", "9"}, film, 2, "--start: the input is over"},
       }) {
    auto arguments = r.arguments;
    arguments.insert(arguments.end(), {"-o", "out.y4m"});
    const RunResult result = run(arguments, r.input);
    const std::string what = ::testing::PrintToString(r.arguments) + result.err;
    EXPECT_EQ(result.exit_code, r.exit_code) << what;
    EXPECT_EQ(result.lines_of_err(), 1) << what;
    EXPECT_THAT(result.err, StartsWith("kinescope: ")) << what;
    EXPECT_THAT(result.err, HasSubstr(r.line)) << what;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.y4m")) << what;
  }
}

TEST_F(ProgramDisplay, FramesWrittenBeforeTheFaultStayWhole) {
  const std::string film = y4m_header(8, 8) + grey_frame(8, 8, 'a') + grey_frame(8, 8, 'b');
  const RunResult result =
      run({"-", "--mode", kTinyMode, "--fps", "60", "--size", "32x24", "-o", "f_#.png"},
          film + grey_frame(8, 8, 'c').substr(0, 100));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(folder_.files(), ElementsAre("f_0.png", "f_1.png"));
  for (const char* name : {"f_0.png", "f_1.png"}) {
    EXPECT_EQ(read_image_file(folder_ / name).width(), 32);
  }
}

TEST_F(ProgramDisplay, AClosedPipeIsOneLine) {
  for (const char* format : {"png", "y4m", "raw"}) {
    const RunResult result =
        run_kinescope({"display", "pattern:dots", "-o", "-", "--format", format},
                      {.folder = folder_.path(), .close_out = true});
    EXPECT_EQ(result.exit_code, 4) << format << result.err;
    EXPECT_EQ(result.lines_of_err(), 1) << result.err;
  }
}

TEST_F(ProgramDisplay, StoppedItLeavesNothingUnfinished) {
  write_text(folder_ / "film.y4m", "precious");
  RunOptions options{.folder = folder_.path()};
  options.stop_signal = SIGINT;
  options.stop_after_ms = 700;
  const RunResult result =
      run_kinescope({"display", "pattern:dots", "--frames", "100000", "-o", "film.y4m"}, options);
  EXPECT_EQ(result.exit_code, 128 + SIGINT);
  EXPECT_THAT(folder_.files(), ElementsAre("film.y4m"));
  EXPECT_EQ(read_text(folder_ / "film.y4m"), "precious");
}

}  // namespace
}  // namespace kinescope::test
