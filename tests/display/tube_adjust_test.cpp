// Knobs turned while the phosphor glows.
#include "display/raster_tube.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "display/phosphor.h"
#include "raster/base/error.h"
#include "raster/base/simd.h"
#include "tests/display/tube_fixtures.h"

namespace kinescope {
namespace {

std::vector<LinearRgb> values(const Image<LinearRgb>& picture) {
  return {picture.pixels().begin(), picture.pixels().end()};
}

TubeSettings everything_set(const VideoMode& mode) {
  TubeSettings settings{mode, "P22"};
  settings.glass.curvature_mm = 500;
  settings.glass.halation = 0.1;
  settings.mask.kind = MaskKind::kDots;
  settings.mask.pitch_mm = 20;
  return settings;
}

/// Turns knobs that lie behind the raster, one at a time.
const std::vector<void (*)(TubeSettings&)> kFrontKnobs = {
    [](TubeSettings& s) { s.mask.pitch_mm = 30; },
    [](TubeSettings& s) { s.mask.kind = MaskKind::kNone; },
    [](TubeSettings& s) { s.glass.curvature_mm = 0; },
    [](TubeSettings& s) { s.glass.halation = 0.3; },
    [](TubeSettings& s) { s.glass.ambient = 0.1; },
    [](TubeSettings& s) {
      s.glass.tint = {0.5, 1, 1};
    },
    [](TubeSettings& s) { s.glass.diagonal_mm = 200; },
    [](TubeSettings& s) { s.gun.blanking = -0.3; },  // the retrace shows
};

TEST(TubeAdjust, KnobsBehindTheRasterShowTheLightThereIsAsIfTheyHadAlwaysStoodSo) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 5);
  Workers workers(1);
  const Seconds turned_at = at_clock(mode, 305.5), end = at_clock(mode, 410.25);
  for (std::size_t knob = 0; knob < kFrontKnobs.size(); ++knob) {
    TubeSettings settings = everything_set(mode);
    RasterTube turned(settings, 60, 45);
    turned.expose(buffer, turned_at, workers);
    const RasterTube as_it_was = turned;
    kFrontKnobs[knob](settings);
    ASSERT_TRUE(turned.adjust(settings));
    RasterTube always(settings, 60, 45);
    always.expose(buffer, turned_at, workers);
    const Image<LinearRgb> seen = turned.expose(buffer, end, workers);
    EXPECT_EQ(values(seen), values(always.expose(buffer, end, workers))) << knob;
    RasterTube left_alone = as_it_was;  // a copy has its own knobs
    EXPECT_NE(values(seen), values(left_alone.expose(buffer, end, workers))) << knob;
  }
}

TEST(TubeAdjust, WhatGlowsFadesOnWhenTheContrastIsTurnedDown) {
  const VideoMode mode = tiny_mode();
  const Seconds frame = mode.frame_period();
  Workers workers(1);
  FrameBuffer buffer = buffer_for(mode), black = buffer_for(mode);
  fill(buffer, 0, kWhite);
  RasterTube turned = cell_tube(mode, "P1");
  turned.expose(buffer, 4 * frame, workers);
  RasterTube faded = turned;
  TubeSettings dark = sharp(mode, "P1");
  dark.gun.contrast = 0;
  ASSERT_TRUE(turned.adjust(dark));
  const Image<LinearRgb> light = turned.expose(buffer, 5 * frame, workers);
  EXPECT_GT(light.at(3, 3).g, 0.1f);
  EXPECT_EQ(values(light), values(faded.expose(black, 5 * frame, workers)));
}

TEST(TubeAdjust, AnotherModeOrPhosphorIsAnotherTube) {
  const VideoMode mode = tiny_mode();
  FrameBuffer buffer = buffer_for(mode);
  fill(buffer, 0, kWhite);
  Workers workers(1);
  for (const TubeSettings& other : {sharp(tiny_mode(true), "P22"), sharp(mode, "P1")}) {
    RasterTube tube = cell_tube(mode, "P22");
    tube.expose(buffer, 2 * mode.frame_period(), workers);
    EXPECT_FALSE(tube.adjust(other));
    EXPECT_EQ(tube.now(), Seconds(0));
    EXPECT_EQ(tube.settings(), other);
    RasterTube fresh(other, mode.horizontal.active, mode.vertical.active);
    const Seconds end = mode.frame_period();
    EXPECT_EQ(values(tube.expose(buffer, end, workers)),
              values(fresh.expose(buffer, end, workers)));
  }
}

}  // namespace
}  // namespace kinescope
