#include "display/raster_scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

namespace kinescope {
namespace {

Seconds pixels(const VideoMode& mode, double count) { return Seconds(count / mode.pixel_clock_hz); }

/// How many pixel clocks of one frame pass in each phase across, and lines in each phase down.
struct Counts {
  std::map<ScanPhase, int> across, down;
  int lit = 0;
};

Counts count_frame(const RasterScan& scan, std::int64_t frame) {
  const VideoMode& mode = scan.mode();
  const int total = mode.horizontal.total();
  Counts counts;
  for (int line = 0; line < mode.vertical.total(); ++line) {
    for (int x = 0; x < total; ++x) {
      const double at =
          (static_cast<double>(frame) * mode.vertical.total() + line) * total + x + 0.5;
      const BeamPosition beam = scan.at(pixels(mode, at));
      ++counts.across[beam.horizontal];
      ++counts.down[beam.vertical];
      counts.lit += beam.blanked ? 0 : 1;
    }
  }
  return counts;
}

TEST(RasterScan, EveryIntervalLastsAsTheModeSays) {
  for (const char* name : {"640x480@60", "240p", "ntsc", "pal"}) {
    const VideoMode mode = parse_mode(name);
    const SyncTiming &h = mode.horizontal, &v = mode.vertical;
    Counts c = count_frame(RasterScan(mode), 3);
    EXPECT_EQ(c.across[ScanPhase::kActive], h.active * v.total()) << name;
    EXPECT_EQ(c.across[ScanPhase::kFrontPorch], h.front_porch * v.total()) << name;
    EXPECT_EQ(c.across[ScanPhase::kSync], h.sync * v.total()) << name;
    EXPECT_EQ(c.across[ScanPhase::kBackPorch], h.back_porch * v.total()) << name;
    EXPECT_EQ(c.lit, h.active * v.active) << name;
    EXPECT_EQ(c.down[ScanPhase::kActive], v.active * h.total()) << name;
    EXPECT_EQ(c.down[ScanPhase::kSync], v.sync * h.total()) << name;
    // Of an interlaced frame, half a line goes from the second field's front porch to before its
    // first line.
    const int moved = mode.interlaced ? h.total() / 2 : 0;
    EXPECT_NEAR(c.down[ScanPhase::kFrontPorch], v.front_porch * h.total() - moved, 1) << name;
    EXPECT_NEAR(c.down[ScanPhase::kBackPorch], v.back_porch * h.total() + moved, 1) << name;
  }
}

TEST(RasterScan, LinesBeginWhereTheBeamSaysTheyDo) {
  for (const VideoMode& mode : standard_modes()) {
    const RasterScan scan(mode);
    for (const std::int64_t frame : {0, 1, 59, 600, 216000}) {
      for (int line = 0; line < mode.vertical.active; line += 7) {
        const BeamPosition beam = scan.at(scan.line_start(frame, line));
        ASSERT_EQ(beam.frame, frame) << mode.name << " line " << line;
        ASSERT_EQ(beam.line, line) << mode.name << " frame " << frame;
        ASSERT_EQ(beam.pixel, 0) << mode.name << " line " << line;
        ASSERT_FALSE(beam.blanked);
        ASSERT_EQ(beam.x, 0);
      }
    }
  }
}

TEST(RasterScan, SecondFieldBeginsHalfALineLater) {
  const VideoMode mode = parse_mode("ntsc");
  const RasterScan scan(mode);
  const BeamPosition start = scan.at(mode.field_period());
  EXPECT_EQ(start.field, 1);
  EXPECT_EQ(start.field_line, 0);
  EXPECT_EQ(start.pixel, mode.horizontal.total() / 2);
  EXPECT_EQ(start.vertical, ScanPhase::kBackPorch);
  EXPECT_NEAR((scan.line_start(0, 1) - mode.field_period()) / mode.line_period(), 0.5, 1e-9);
  // Lines lie at even distances on the screen whichever field draws them.
  for (int line = 0; line < mode.vertical.active; ++line) {
    const BeamPosition beam = scan.at(scan.line_start(2, line) + mode.line_period() / 2);
    ASSERT_NEAR(beam.y * mode.vertical.active, line + 0.5, 1e-6);
    ASSERT_EQ(beam.line, line);
  }
}

TEST(RasterScan, LinesOfProgressiveModesLieEvenly) {
  const VideoMode mode = parse_mode("640x480@60");
  const RasterScan scan(mode);
  for (int line = 0; line < 480; ++line) {
    const BeamPosition beam = scan.at(scan.line_start(1, line) + mode.line_period() / 2);
    ASSERT_NEAR(beam.y * 480, line + 0.5, 1e-6);
  }
}

TEST(RasterScan, RetraceBeginsAfterTheLastLine) {
  for (const char* name : {"640x480@60", "ntsc", "pal"}) {
    const VideoMode mode = parse_mode(name);
    const RasterScan scan(mode);
    for (int field = 0; field < scan.fields(); ++field) {
      const int last = mode.vertical.active - scan.fields() + field;
      const Seconds retrace = scan.retrace_start(5, field);
      EXPECT_NEAR((retrace - scan.line_start(5, last)) / mode.line_period(), 1, 1e-6) << name;
      EXPECT_NE(scan.at(retrace).vertical, ScanPhase::kActive) << name;
      EXPECT_EQ(scan.at(retrace - pixels(mode, 0.25)).vertical, ScanPhase::kActive) << name;
    }
  }
}

TEST(RasterScan, DeflectionIsContinuous) {
  for (const char* name : {"640x480@60", "240p", "ntsc"}) {
    const VideoMode mode = parse_mode(name);
    const RasterScan scan(mode);
    const int clocks = mode.horizontal.total() * mode.vertical.total();
    BeamPosition before = scan.at(Seconds(0));
    // The fastest flight is half a cosine: pi / 2 times its mean speed.
    const double across = 1.0 * (mode.horizontal.active + mode.horizontal.front_porch) /
                          mode.horizontal.active /
                          (mode.horizontal.sync + mode.horizontal.back_porch);
    const double fastest = std::max(1.0 / mode.horizontal.active, across * 1.5708) * 1.001;
    for (int i = 1; i <= clocks; ++i) {
      const BeamPosition beam = scan.at(pixels(mode, i));
      ASSERT_LE(std::abs(beam.x - before.x), fastest) << name << " clock " << i;
      ASSERT_LE(std::abs(beam.y - before.y), 0.001) << name << " clock " << i;
      before = beam;
    }
  }
}

TEST(RasterScan, FliesBackDuringSync) {
  const VideoMode mode = parse_mode("640x480@60");
  const RasterScan scan(mode);
  const SyncTiming &h = mode.horizontal, &v = mode.vertical;
  const double reach = static_cast<double>(h.active + h.front_porch) / h.active;
  EXPECT_NEAR(scan.at(pixels(mode, h.active + h.front_porch)).x, reach, 1e-9);
  const double middle = h.active + h.front_porch + (h.sync + h.back_porch) / 2.0;
  EXPECT_NEAR(scan.at(pixels(mode, middle)).x, reach / 2, 1e-9);
  EXPECT_NEAR(scan.at(pixels(mode, h.total() - 0.01)).x, 0, 1e-6);
  const double middle_line = v.active + v.front_porch + (v.sync + v.back_porch) / 2.0;
  const double low = static_cast<double>(v.active + v.front_porch) / v.active;
  EXPECT_NEAR(scan.at(pixels(mode, middle_line * h.total())).y, low / 2, 1e-9);
}

TEST(RasterScan, DoesNotDriftInTenSeconds) {
  std::mt19937_64 random(11);
  for (const char* name : {"640x480@60", "1600x1200@60", "ntsc"}) {
    const VideoMode mode = parse_mode(name);
    const RasterScan scan(mode);
    const std::int64_t line_clocks = mode.horizontal.total();
    const std::int64_t frame_clocks = line_clocks * mode.vertical.total();
    for (int i = 0; i < 2000; ++i) {
      const auto clock = static_cast<std::int64_t>(
          random() % static_cast<std::uint64_t>(10 * mode.pixel_clock_hz));
      const BeamPosition beam = scan.at(pixels(mode, static_cast<double>(clock)));
      ASSERT_EQ(beam.frame, clock / frame_clocks) << name;
      ASSERT_EQ(beam.pixel, static_cast<double>(clock % line_clocks)) << name << " " << clock;
    }
  }
}

TEST(RasterScan, TimeBeforeZeroIsAFrameBefore) {
  const VideoMode mode = parse_mode("640x480@60");
  const RasterScan scan(mode);
  const BeamPosition beam = scan.at(scan.line_start(-1, 100));
  EXPECT_EQ(beam.frame, -1);
  EXPECT_EQ(beam.line, 100);
}

}  // namespace
}  // namespace kinescope
