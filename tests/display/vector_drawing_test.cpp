// What becomes of decoded drawings: pages, strokes, pictures, SVG.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "display/vector/input/beam_strokes.h"
#include "display/vector/input/read_vectors.h"
#include "display/vector/input/stroke_font.h"
#include "display/vector/input/svg_reader.h"
#include "display/vector/input/write_svg.h"
#include "tests/raster/scratch.h"

namespace kinescope {
namespace {

TEST(VectorDrawing, PagesKeepTheirPensAndTexts) {
  VectorDrawing drawing;
  const VectorPen red{.colour = {255, 0, 0}}, dashed{.style = LineStyle::kLongDash};
  drawing.use(red);
  drawing.line({0, 0}, {1, 1});
  drawing.event(DrawingEvent::Kind::kErase);
  drawing.event(DrawingEvent::Kind::kErase);  // holds nothing
  drawing.line({2, 2}, {3, 3});
  drawing.use(dashed);
  drawing.line({3, 3}, {4, 4});
  drawing.texts.push_back({.text = "a", .segments = 3});
  const auto all = pages(drawing);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].segments.size(), 2u);
  ASSERT_EQ(all[1].pens.size(), 2u);
  EXPECT_EQ(all[1].pens[0].pen, red);
  EXPECT_EQ(all[1].pens[1].segments, 1u);
  EXPECT_EQ(all[1].texts[0].segments, 2u);
}

TEST(BeamStrokes, BrokenLinesGoOnRoundCorners) {
  for (const LineStyle style :
       {LineStyle::kDotted, LineStyle::kDotDash, LineStyle::kShortDash, LineStyle::kLongDash}) {
    // The same length in one piece and in a hundred.
    double lengths[2] = {};
    for (const int pieces : {1, 100}) {
      VectorDrawing drawing;
      drawing.use({.style = style});
      for (int i = 0; i < pieces; ++i) {
        const float step = 4000.0f / static_cast<float>(pieces), x = step * static_cast<float>(i);
        drawing.line({x, 0}, {x + step, 0});
      }
      for (const VectorSegment& s : beam_strokes(drawing).segments) {
        lengths[pieces == 1 ? 0 : 1] += static_cast<double>(s.x2 - s.x1);
      }
    }
    EXPECT_NEAR(lengths[0], lengths[1], 4);
    EXPECT_LT(lengths[0], 3600);
    EXPECT_GT(lengths[0], 400);
  }
}

TEST(BeamStrokes, TextsKeepTheirPen) {
  const VectorPen passing{.write_through = true};
  VectorDrawing drawing;
  drawing.texts.push_back({.text = "I", .advance = {50, 0}, .up = {0, 50}});
  drawing.use(passing);
  drawing.line({0, 0}, {9, 9});
  drawing.texts.push_back({.text = "I", .advance = {50, 0}, .up = {0, 50}, .segments = 1});
  drawing.use({});
  std::vector<bool> through;
  for_each_run(beam_strokes(drawing), [&](const VectorPen& pen, std::size_t, std::size_t) {
    through.push_back(pen.write_through);
  });
  EXPECT_EQ(through, (std::vector<bool>{false, true, false}));
}

TEST(StrokeFont, LettersStandOnTheirLine) {
  for (const char c : std::string_view("AEHZ0")) {
    float least = 9, most = -9;
    for (const GlyphPoint& p : stroke_glyph(static_cast<unsigned char>(c)).points) {
      least = std::min(least, p.at.y);
      most = std::max(most, p.at.y);
    }
    EXPECT_EQ(least, 0) << c;
    EXPECT_EQ(most, 1) << c;
  }
  EXPECT_TRUE(stroke_glyph(' ').points.empty());
  EXPECT_TRUE(stroke_glyph(200).points.empty());
  for (int c = '!'; c <= '~'; ++c) {
    EXPECT_FALSE(stroke_glyph(static_cast<unsigned char>(c)).points.empty()) << c;
  }
}

TEST(StrokeFont, WideLettersStayInTheirCell) {
  const DrawnText text{.text = "MW@m", .place = {100, 0}, .advance = {50, 0}, .up = {0, 90}};
  for_each_text_stroke(text, [](glm::vec2 from, glm::vec2 to) {
    for (const float x : {from.x, to.x}) {
      EXPECT_GE(x, 100);
      EXPECT_LE(x, 300);
    }
  });
}

TEST(WriteSvg, ReadsBackTheSameStrokes) {
  VectorDrawing drawing;
  drawing.line({1.5f, 2.25f}, {4000, 3000});
  drawing.line({4000, 3000}, {10, 20}, 0.5f);
  drawing.use({.colour = {255, 0, 0}, .width = 7});
  drawing.line({5, 5}, {5, 5});
  const testing::Scratch folder;
  write_svg(folder.path("a.svg"), drawing);
  const std::string text = testing::Scratch::text(folder.path("a.svg"));
  VectorDrawing back =
      read_svg({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "a.svg");
  // The background's rectangle comes first.
  ASSERT_EQ(back.segments.size(), 4 + drawing.segments.size());
  back.segments.erase(back.segments.begin(), back.segments.begin() + 4);
  for (std::size_t i = 0; i < drawing.segments.size(); ++i) {
    EXPECT_NEAR(back.segments[i].x2, drawing.segments[i].x2, 1e-3);
    EXPECT_NEAR(back.segments[i].y1, drawing.segments[i].y1, 1e-3);
    EXPECT_EQ(back.segments[i].intensity, drawing.segments[i].intensity);
  }
  EXPECT_EQ(back.pens.back().pen.colour, (Srgb8{255, 0, 0}));
}

TEST(RecogniseVectors, ByContent) {
  const auto kind = [](std::string_view text) {
    return recognise_vectors({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(kind("\x1b\x0c\x1d abc"), VectorKind::kTek);
  EXPECT_EQ(kind("\x1b[?38h\x1b\x0c"), VectorKind::kTek);
  EXPECT_EQ(kind("\x1d!r\"[!r#F"), VectorKind::kTek);
  EXPECT_EQ(kind("IN;SP1;"), VectorKind::kHpgl);
  EXPECT_EQ(kind("\n  pu0,0;pd1,1"), VectorKind::kHpgl);
  EXPECT_EQ(kind("\x1b%-1BBPIN"), VectorKind::kHpgl);
  EXPECT_EQ(kind("\x1b.(;IN"), VectorKind::kHpgl);
  EXPECT_EQ(kind("<?xml version='1.0'?><svg/>"), VectorKind::kSvg);
  EXPECT_EQ(kind("\xef\xbb\xbf<svg/>"), VectorKind::kSvg);
  EXPECT_EQ(kind("RIFF....WAVE"), VectorKind::kWav);
  EXPECT_EQ(kind("a letter"), std::nullopt);
  EXPECT_EQ(kind(""), std::nullopt);
}

}  // namespace
}  // namespace kinescope
