// HP-GL by hand; tests/compare_vectors holds the reader to hp2xx on whole plots.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <string_view>

#include "display/vector/input/beam_strokes.h"
#include "display/vector/input/hpgl_reader.h"

namespace kinescope {
namespace {

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

VectorDrawing read(std::string_view text) { return read_hpgl(bytes_of(text), "plot"); }

/// "x1,y1-x2,y2 ..." rounded to whole units.
std::string lines(std::string_view text) {
  std::string out;
  for (const VectorSegment& s : read(text).segments) {
    char part[99];
    std::snprintf(part, sizeof part, "%s%ld,%ld-%ld,%ld", out.empty() ? "" : " ", std::lround(s.x1),
                  std::lround(s.y1), std::lround(s.x2), std::lround(s.y2));
    out += part;
  }
  return out;
}

TEST(HpglReader, MovesAbsoluteAndRelative) {
  EXPECT_EQ(lines("IN;SP1;PU0,0;PD100,0,100,50;PR;PD10,10;PA5,5"),
            "0,0-100,0 100,0-100,50 100,50-110,60 110,60-5,5");
  EXPECT_EQ(lines("in sp1pu0 0pd+1,7"), "0,0-1,7") << "separators and case do not matter";
  EXPECT_EQ(lines("SP1;PA3,4;PD;PU;"), "3,4-3,4") << "a dot";
  EXPECT_EQ(lines("SP1;PA3,4;PD;PU;SP0;PD9,9"), "3,4-3,4") << "no pen draws nothing";
}

TEST(HpglReader, ScalesAndTurns) {
  EXPECT_EQ(lines("IP100,200,1100,2200;SC0,10,0,20;PA0,0;PD10,20"), "100,200-1100,2200");
  EXPECT_EQ(lines("IP0,0,1000,500;SC0,10,0,10,1;PA0,0;PD10,10"), "250,0-750,500") << "isotropic";
  EXPECT_EQ(lines("SC5,2,0,3,2;PA5,0;PD6,1"), "0,0-2,3") << "by factors";
  EXPECT_EQ(lines("RO90;PA10,20;PD30,40"), "-20,10--40,30");
  EXPECT_EQ(lines("SC0,0,0,0;PA1,2;PD3,4"), "1,2-3,4") << "a scale of nothing is none";
}

TEST(HpglReader, CutsAtTheWindow) {
  EXPECT_EQ(lines("IW0,0,100,100;PA-50,50;PD150,50;PU;PA-5,-5;PD-5,105;IW;"), "0,50-100,50");
  EXPECT_EQ(lines("PS200,100;IW;PA50,50;PD300,50"), "50,50-200,50") << "none given: the page";
}

TEST(HpglReader, ArcsKeepToTheirCircle) {
  for (const char* plot : {"PA100,0;PD;AA0,0,180;", "PA100,0;PD;AR-100,0,180",
                           "PA100,0;PD;AT0,100,-100,0", "PA0,0;CI100", "PA0,0;EW100,0,360"}) {
    const VectorDrawing drawing = read(plot);
    ASSERT_GE(drawing.segments.size(), 36u) << plot;
    for (std::size_t i = 1; i + 1 < drawing.segments.size(); ++i) {
      const VectorSegment& s = drawing.segments[i];
      EXPECT_NEAR(std::hypot(s.x1, s.y1), 100, 0.01) << plot;
    }
  }
  EXPECT_EQ(read("PA0,0;CI100,30").segments.size(), 12u);
  EXPECT_EQ(lines("PA0,0;PD;AT50,50,100,100"), "0,0-100,100") << "no circle: a line";
}

TEST(HpglReader, RectanglesAndPolygons) {
  EXPECT_EQ(lines("PA0,0;EA10,20"), "0,0-0,20 0,20-10,20 10,20-10,0 10,0-0,0");
  EXPECT_EQ(lines("PA5,5;ER10,20"), lines("PA5,5;EA15,25"));
  EXPECT_EQ(lines("PA0,0;PM0;PD10,0,10,10;PM2;EP"), "0,0-10,0 10,0-10,10 10,10-0,0");
  EXPECT_EQ(lines("PA0,0;PM0;PD10,0,10,10;PM2;"), "") << "defined, not drawn";
}

double filled_area(std::string_view text, double spacing) {
  double length = 0;
  for (const VectorSegment& s : read(text).segments) {
    length += std::hypot(double{s.x2} - double{s.x1}, double{s.y2} - double{s.y1});
  }
  return length * spacing;
}

TEST(HpglReader, FillsCoverTheirArea) {
  constexpr double kPi = 3.14159265358979;
  EXPECT_NEAR(filled_area("PA0,0;FT3,5,30;RA1000,500", 5), 500000, 5000);
  EXPECT_NEAR(filled_area("PA0,0;FT4,5,10;RA1000,500", 5), 2 * 500000, 10000);
  EXPECT_NEAR(filled_area("PA0,0;FT3,5,0;WG1000,0,90", 5), 250000 * kPi, 5000);
  EXPECT_NEAR(filled_area("PA0,0;FT3,5,0;PM0;PD1000,0,1000,1000,0,1000;PM1;PU250,250;PD750,250,750,"
                          "750,250,750;PM2;FP",
                          5),
              750000, 5000)
      << "a hole stays empty";
}

TEST(HpglReader, AnAreaBetweenItsLinesIsEmpty) {
  EXPECT_EQ(lines("SP1;PA0,10;FT3,80,0;RA500,70"), "");
  EXPECT_EQ(lines("SP1;PA0,40;FT3,80,0;RA500,40"), "") << "no height";
}

TEST(HpglReader, LabelsStandAtTheirAnchor) {
  const auto text = [](std::string_view plot) { return read(plot).texts.at(0); };
  const DrawnText plain = text("PA1000,2000;SI.3,.5;LBAbc\x03");
  EXPECT_EQ(plain.text, "Abc");
  EXPECT_EQ(plain.place, glm::vec2(1000, 2000));
  EXPECT_EQ(plain.advance, glm::vec2(180, 0));
  EXPECT_EQ(plain.up, glm::vec2(0, 200));
  EXPECT_EQ(text("PA1000,2000;SI.3,.5;LO4;LBAbc\x03").place, glm::vec2(760, 2000));
  EXPECT_EQ(text("PA1000,2000;SI.3,.5;LO7;LBAbc\x03").place, glm::vec2(520, 2000));
  EXPECT_EQ(text("PA0,0;SI.3,.5;DI0,1;LBA\x03").advance, glm::vec2(0, 180));
  EXPECT_EQ(text("PA0,0;SI.3,.5;DI0,1;LBA\x03").up, glm::vec2(-200, 0));
  EXPECT_EQ(text("PA0,0;SI.3,.5;SL.5;LBA\x03").up, glm::vec2(100, 200));
  EXPECT_EQ(text("DT#;PA0,0;LBa;b\x03#PD9,9").text, "a;b") << "ended by another character";
}

TEST(HpglReader, LinesOfLabelsGoDown) {
  const auto texts = read("PA1000,2000;SI.3,.5;LBone\r\ntwo\r\nx\x03;CP;LBy\x03").texts;
  ASSERT_EQ(texts.size(), 4u);
  EXPECT_EQ(texts[1].place, glm::vec2(1000, 1600));
  EXPECT_EQ(texts[2].place, glm::vec2(1000, 1200));
  EXPECT_EQ(texts[3].place, glm::vec2(1000, 800));
}

TEST(HpglReader, PensHaveIntensitiesColoursAndStyles) {
  const VectorDrawing drawing = read("SP1;PA0,0;PD1,0;SP2;LT2;PD1,1;LT;PW.5;PD2,2");
  ASSERT_EQ(drawing.segments.size(), 3u);
  EXPECT_EQ(drawing.segments[0].intensity, 1);
  EXPECT_FLOAT_EQ(drawing.segments[1].intensity, 0.92f);
  EXPECT_EQ(drawing.pens[0].pen.style, LineStyle::kShortDash);
  EXPECT_EQ(drawing.pens.back().pen.width, 20);
  EXPECT_EQ(read("PC1,255,0,0;SP1;PA0,0;PD1,0").pens[0].pen.colour, (Srgb8{255, 0, 0}));
}

TEST(HpglReader, LabelsAreOfThePenThatDrewThem) {
  const VectorDrawing strokes = beam_strokes(
      read("PC1,255,0,0;PC2,0,255,0;SP1;PA0,0;LBI\x03SP2;LBI\x03PD9,9;PU;SP1;LBI\x03SP2"));
  std::vector<Srgb8> colours;
  for_each_run(strokes, [&](const VectorPen& pen, std::size_t, std::size_t) {
    colours.push_back(pen.colour);
  });
  const Srgb8 red{255, 0, 0}, green{0, 255, 0};
  EXPECT_EQ(colours, (std::vector<Srgb8>{red, green, red}));
  EXPECT_FLOAT_EQ(read("SP2;LBa\x03").texts[0].intensity, 0.92f);
}

TEST(HpglReader, WhatNoPlotterReachesIsNotDrawn) {
  const std::string huge = "1" + std::string(60, '4');
  for (const std::string& shape : {"EW" + huge + ",0,90;", "CI" + huge + ";"}) {
    for (const VectorSegment& s : read("PA0,0;PD1,1;" + shape).segments) {
      EXPECT_LT(std::abs(s.x2) + std::abs(s.y2), 1e10f) << shape;
    }
  }
}

TEST(HpglReader, APageBeginsAnew) {
  const auto all = pages(read("IP0,0,100,100;SC0,1,0,1;PA0,0;PD1,1;PG;PA0,0;PD1,1;PG;"));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].segments[0].x2, 100);
  EXPECT_EQ(all[1].segments[0].x2, 1);
}

TEST(HpglReader, PassesOverEscapesAndTellsOfTheUnknown) {
  EXPECT_EQ(lines("\x1b.(\x1b.I81;;17:\x1b%-1BIN;PA0,0;PD5,5"), "0,0-5,5");
  Warnings warnings;
  read_hpgl(bytes_of("IN;ZZ5;PA0,0;PD1,1"), "plot", &warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], ::testing::HasSubstr("ZZ"));
  EXPECT_THROW(read("1234 5678"), Error);
  EXPECT_THROW(read(""), Error);
}

TEST(HpglReader, FillsWithoutEndAreRefused) {
  std::string plot = "FT3,1;PA0,0;PM0;PD";
  for (int i = 0; i < 999; ++i) plot += i % 2 ? "0,0," : "9,99999,";
  plot += "0,0;PM2;";
  for (int i = 0; i < 99; ++i) plot += "FP;";
  try {
    read(plot);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("plot: "));
  }
}

TEST(HpglReader, AnyTextIsHarmless) {
  std::mt19937 random(2);
  const std::string_view words[] = {"PA", "PD", "PU", "PR", "SC", "IP", "CI",   "AA", "AT", "EW",
                                    "WG", "RA", "PM", "FP", "EP", "LB", "\x03", "SI", "LO", "CP",
                                    "IW", "RO", "FT", "BZ", "SM", "XT", "DT",   "DV", "PG", "PS"};
  std::size_t most = 0;
  for (int n = 0; n < 400; ++n) {
    std::string plot;
    for (int i = 0; i < 60; ++i) {
      plot += words[random() % std::size(words)];
      for (auto k = random() % 7; k > 0; --k) {
        const int exponent = static_cast<int>(random() % 6);
        plot += std::to_string(static_cast<int>(random() % 2000) - 1000) +
                std::string(exponent == 5 ? 9 : 0, '0') + ",";
      }
    }
    for (const VectorSegment& s : beam_strokes(read("IN;" + plot)).segments) {
      ASSERT_TRUE(std::isfinite(s.x1 + s.y1 + s.x2 + s.y2));
      ++most;
    }
  }
  EXPECT_GT(most, 1000u);
}

}  // namespace
}  // namespace kinescope
