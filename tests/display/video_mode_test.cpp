#include "display/video_mode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "raster/base/error.h"

namespace kinescope {
namespace {

using ::testing::HasSubstr;

void expect_timing(const SyncTiming& t, int active, int front, int sync, int back,
                   const std::string& what) {
  EXPECT_EQ(t.active, active) << what;
  EXPECT_EQ(t.front_porch, front) << what;
  EXPECT_EQ(t.sync, sync) << what;
  EXPECT_EQ(t.back_porch, back) << what;
}

TEST(VideoMode, TableHoldsTheVesaNumbers) {
  struct Row {
    const char* name;
    double clock_MHz;
    int h[4], v[4];
    double line_kHz, refresh_hz;  // as the standard prints them
  };
  // VESA DMT 1.13.
  const Row rows[] = {
      {"640x480@60", 25.175, {640, 16, 96, 48}, {480, 10, 2, 33}, 31.469, 59.940},
      {"800x600@60", 40.000, {800, 40, 128, 88}, {600, 1, 4, 23}, 37.879, 60.317},
      {"1024x768@75", 78.750, {1024, 16, 96, 176}, {768, 1, 3, 28}, 60.023, 75.029},
      {"1280x1024@60", 108.000, {1280, 48, 112, 248}, {1024, 1, 3, 38}, 63.981, 60.020},
      {"1600x1200@60", 162.000, {1600, 64, 192, 304}, {1200, 1, 3, 46}, 75.000, 60.000},
  };
  for (const Row& row : rows) {
    const VideoMode mode = parse_mode(row.name);
    EXPECT_EQ(mode.name, row.name);
    EXPECT_DOUBLE_EQ(mode.pixel_clock_hz, row.clock_MHz * 1e6);
    expect_timing(mode.horizontal, row.h[0], row.h[1], row.h[2], row.h[3], row.name);
    expect_timing(mode.vertical, row.v[0], row.v[1], row.v[2], row.v[3], row.name);
    EXPECT_NEAR(mode.line_rate_hz() / 1e3, row.line_kHz, 0.0006);
    EXPECT_NEAR(mode.frame_rate().hertz(), row.refresh_hz, 0.0006);
    EXPECT_FALSE(mode.interlaced);
  }
}

TEST(VideoMode, TelevisionLinesLastAsTheirStandardsSay) {
  const VideoMode ntsc = parse_mode("ntsc"), pal = parse_mode("pal"), console = parse_mode("240p");
  const auto us = [](const VideoMode& m, int pixels) { return pixels / m.pixel_clock_hz * 1e6; };
  EXPECT_NEAR(ntsc.line_period().count() * 1e6, 63.556, 0.001);
  EXPECT_NEAR(us(ntsc, ntsc.horizontal.active), 52.6, 0.05);
  EXPECT_NEAR(us(ntsc, ntsc.horizontal.front_porch), 1.5, 0.05);
  EXPECT_NEAR(us(ntsc, ntsc.horizontal.sync), 4.7, 0.05);
  EXPECT_NEAR(us(ntsc, ntsc.horizontal.back_porch), 4.7, 0.05);
  EXPECT_EQ(ntsc.vertical.total(), 525);
  EXPECT_TRUE(ntsc.interlaced);
  EXPECT_NEAR(1 / ntsc.field_period().count(), 60e3 / 1001, 1e-9);
  EXPECT_EQ(ntsc.frame_rate().numerator, 30000);
  EXPECT_EQ(ntsc.frame_rate().denominator, 1001);
  EXPECT_NEAR(pal.line_period().count() * 1e6, 64, 1e-9);
  EXPECT_NEAR(us(pal, pal.horizontal.active), 52.0, 0.05);
  EXPECT_NEAR(us(pal, pal.horizontal.back_porch), 5.8, 0.05);
  EXPECT_EQ(pal.vertical.total(), 625);
  EXPECT_EQ(pal.frame_rate().hertz(), 25);
  EXPECT_EQ(console.vertical.total(), 262);
  EXPECT_NEAR(console.line_period().count() * 1e6, 63.556, 0.001);
  EXPECT_NEAR(us(console, console.horizontal.active), 52.6, 0.05);
}

TEST(VideoMode, EveryTableModeIsSoundAndReadsBackFromItsModeline) {
  ASSERT_GE(standard_modes().size(), 10u);
  for (const VideoMode& mode : standard_modes()) {
    mode.check();
    const VideoMode back = parse_mode(mode.modeline());
    EXPECT_EQ(back.name, mode.name);
    EXPECT_NEAR(back.pixel_clock_hz, mode.pixel_clock_hz, mode.pixel_clock_hz * 1e-5);
    EXPECT_EQ(back.modeline(), mode.modeline());
    EXPECT_EQ(back.interlaced, mode.interlaced);
    EXPECT_NEAR(mode.frame_period() / mode.line_period(), mode.vertical.total(), 1e-9);
    EXPECT_NEAR(mode.line_period() / mode.pixel_period(), mode.horizontal.total(), 1e-9);
  }
}

/// What a program prints, or empty if it is not there.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>/dev/null").c_str(), "r"),
                                                   pclose);
  std::string text;
  std::array<char, 512> part{};
  while (pipe && fgets(part.data(), part.size(), pipe.get()) != nullptr) text += part.data();
  return text;
}

/// The mode in the Modeline that a program prints; skips or fails the test where there is none.
std::string modeline_of(const std::string& command) {
  const std::string text = output_of(command);
  const std::size_t at = text.find("Modeline");
  return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
}

bool absent(const std::string& program) { return output_of("command -v " + program).empty(); }

#define SKIP_WITHOUT(program)                                                               \
  if (absent(program)) {                                                                    \
    if (std::getenv("KINESCOPE_REQUIRE_DATA") != nullptr) FAIL() << program " is required"; \
    GTEST_SKIP() << program " is not installed";                                            \
  }

void expect_same(const VideoMode& ours, const std::string& theirs, double clock_step_hz) {
  ASSERT_FALSE(theirs.empty());
  const VideoMode want = parse_mode(theirs);
  const auto& h = want.horizontal;
  const auto& v = want.vertical;
  EXPECT_NEAR(ours.pixel_clock_hz, want.pixel_clock_hz, clock_step_hz) << theirs;
  expect_timing(ours.horizontal, h.active, h.front_porch, h.sync, h.back_porch, theirs);
  expect_timing(ours.vertical, v.active, v.front_porch, v.sync, v.back_porch, theirs);
  EXPECT_EQ(ours.horizontal.positive_sync, h.positive_sync) << theirs;
  EXPECT_EQ(ours.vertical.positive_sync, v.positive_sync) << theirs;
}

constexpr int kSizes[][2] = {{320, 240},   {640, 480},   {720, 480},   {800, 600},  {1024, 768},
                             {1152, 864},  {1280, 720},  {1280, 1024}, {1366, 768}, {1440, 900},
                             {1600, 1200}, {1920, 1080}, {2560, 1600}, {3840, 2160}};

TEST(Cvt, AgreesWithDebiansCvt) {
  SKIP_WITHOUT("cvt");
  for (const auto& [width, height] : kSizes) {
    const std::string size = std::to_string(width) + " " + std::to_string(height) + " ";
    for (const double rate : {48.0, 50.0, 59.94, 60.0, 75.0, 85.0, 120.0}) {
      expect_same(cvt_mode(width, height, rate), modeline_of("cvt " + size + std::to_string(rate)),
                  1);
    }
    expect_same(cvt_mode(width, height, 60, true), modeline_of("cvt -r " + size + "60"), 1);
    expect_same(cvt_mode(width, height, 120, true), modeline_of("cvt -r " + size + "120"), 1);
  }
}

TEST(Gtf, AgreesWithXorgsGtf) {
  SKIP_WITHOUT("gtf");
  for (const auto& [width, height] : kSizes) {
    if (width < 640) continue;  // there the formula's sync is longer than its blanking
    for (const double rate : {50.0, 60.0, 72.0, 85.0, 100.0}) {
      const std::string command = "gtf " + std::to_string(width) + " " + std::to_string(height) +
                                  " " + std::to_string(rate);
      expect_same(gtf_mode(width, height, rate), modeline_of(command), 5001);  // printed in 10 kHz
    }
  }
}

TEST(Cvt, InterlacedFramesHaveAnOddNumberOfLines) {
  for (const VideoMode& mode :
       {cvt_mode(1024, 768, 43.5, false, true), gtf_mode(1024, 768, 43.5, true)}) {
    EXPECT_TRUE(mode.interlaced);
    EXPECT_EQ(mode.vertical.total() % 2, 1);
    EXPECT_EQ(mode.vertical.active, 768);
    EXPECT_NEAR(1 / mode.field_period().count(), 87, 0.4) << mode.modeline();
  }
}

TEST(ParseMode, TakesEveryWayOfSayingIt) {
  EXPECT_EQ(parse_mode("640x480@60").pixel_clock_hz, 25.175e6);
  EXPECT_EQ(parse_mode("640x480@59.94").pixel_clock_hz, 25.175e6);
  EXPECT_EQ(parse_mode("640x480@59.94i").vertical.total(), 525);
  EXPECT_EQ(parse_mode("720x576@50i").vertical.total() % 2, 1);
  EXPECT_EQ(parse_mode("1400x1050@60").modeline(), [] {
    VideoMode mode = cvt_mode(1400, 1050, 60);
    return mode.modeline();
  }());
  EXPECT_EQ(parse_mode("gtf:640x480@60").horizontal.total(), 800);
  EXPECT_EQ(parse_mode("cvtrb:1920x1080@60").horizontal.total(), 2080);
  const VideoMode line =
      parse_mode("ModeLine \"mine\" 25.2 640 656 752 800 480 490 492 525 -HSync");
  EXPECT_EQ(line.name, "mine");
  EXPECT_EQ(line.vertical.back_porch, 33);
}

std::string refusal(const std::string& text) {
  try {
    parse_mode(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage) << text;
    return error.what();
  }
  return "accepted";
}

TEST(ParseMode, RefusesWhatNoMonitorHas) {
  EXPECT_THAT(refusal("0x480@60"), HasSubstr("1 to 16384"));
  EXPECT_THAT(refusal("-640x480@60"), HasSubstr("1 to 16384"));
  EXPECT_THAT(refusal("1000000000x480@60"), HasSubstr("1 to 16384"));
  EXPECT_THAT(refusal("99999999999999999999x480@60"), HasSubstr("WIDTHxHEIGHT@HERTZ"));
  EXPECT_THAT(refusal("640x480@1"), HasSubstr("10 to 1000"));
  EXPECT_THAT(refusal("640x480@0"), HasSubstr("10 to 1000"));
  EXPECT_THAT(refusal("640x480@-60"), HasSubstr("10 to 1000"));
  EXPECT_THAT(refusal("640x480@nan"), HasSubstr("10 to 1000"));
  EXPECT_THAT(refusal("640x480@1e9"), HasSubstr("10 to 1000"));
  EXPECT_THAT(refusal("1x1@60"), HasSubstr("horizontal sync"));
  EXPECT_THAT(refusal("gtf:640x1@60i"), HasSubstr("has the mode"));
  EXPECT_THAT(refusal("cvt:16384x16384@1000"), HasSubstr("vertical back porch"));
  EXPECT_THAT(refusal("cvt:640x480@2000i"), HasSubstr("leaves no time"));
  EXPECT_THAT(refusal("gtf:640x480@2000i"), HasSubstr("leaves no time"));
  EXPECT_THAT(refusal("gtf:320x240@50"), HasSubstr("horizontal front porch is -16"));
  for (const char* text : {"", "640", "640x", "640x480", "640x480@", "640x480@60Hz", "vga",
                           "cvt:", "640x480@60ii", "640 480 60"}) {
    EXPECT_THAT(refusal(text), HasSubstr("WIDTHxHEIGHT@HERTZ")) << text;
  }
}

TEST(ParseMode, RefusesBrokenModelines) {
  const std::string good = "Modeline \"m\" 25.175 640 656 752 800 480 490 492 525";
  EXPECT_EQ(refusal(good), "accepted");
  EXPECT_THAT(refusal(good + " sideways"), HasSubstr("sideways"));
  EXPECT_THAT(refusal("\"m 25 1 2 3 4 1 2 3 4"), HasSubstr("quotes"));
  EXPECT_THAT(refusal("\"m\" 25 1 2 3"), HasSubstr("eight numbers"));
  EXPECT_THAT(refusal("\"m\" 25.175 640 656 752 800 480 490 x 525"), HasSubstr("\"x\""));
  EXPECT_THAT(refusal("\"m\" 25.175 640 656 752 1e9 480 490 492 525"), HasSubstr("1e+09"));
  EXPECT_THAT(refusal("\"m\" 25.175 640 600 752 800 480 490 492 525"),
              HasSubstr("horizontal front porch is -40"));
  EXPECT_THAT(refusal("\"m\" 25.175 640 656 656 800 480 490 492 525"),
              HasSubstr("horizontal sync"));
  EXPECT_THAT(refusal("\"m\" 25.175 640 656 752 800 480 490 490 525"), HasSubstr("vertical sync"));
  EXPECT_THAT(refusal("\"m\" 0 640 656 752 800 480 490 492 525"), HasSubstr("pixel clock"));
  EXPECT_THAT(refusal("\"m\" -25 640 656 752 800 480 490 492 525"), HasSubstr("pixel clock"));
  EXPECT_THAT(refusal("\"m\" 0.4 640 656 752 800 480 490 492 525"), HasSubstr("sweeps a second"));
  EXPECT_THAT(refusal("\"m\" 13.5 640 656 752 800 480 490 492 524 interlace"), HasSubstr("odd"));
}

TEST(VideoMode, HasTwoNamesForBroadcastsModes) {
  for (const auto& [name, other] : {std::pair{"480i", "ntsc"}, std::pair{"576i", "pal"}}) {
    VideoMode mode = parse_mode(name);
    EXPECT_EQ(mode.name, name);
    mode.name = other;
    EXPECT_EQ(mode, parse_mode(other));
  }
}

}  // namespace
}  // namespace kinescope
