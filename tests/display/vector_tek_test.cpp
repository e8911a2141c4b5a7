// Tektronix streams by hand; tests/compare_vectors holds the reader to tek2plot on whole plots.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>

#include "display/vector/input/beam_strokes.h"
#include "display/vector/input/tek_reader.h"

namespace kinescope {
namespace {

using namespace std::string_literals;

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

VectorDrawing read(std::string_view text) { return read_tek(bytes_of(text)); }

/// An address in all five bytes.
std::string at(int x, int y) {
  return {static_cast<char>(0x20 | y >> 7), static_cast<char>(0x60 | (y & 3) << 2 | (x & 3)),
          static_cast<char>(0x60 | (y >> 2 & 31)), static_cast<char>(0x20 | x >> 7),
          static_cast<char>(0x40 | (x >> 2 & 31))};
}

std::vector<VectorSegment> strokes(std::string_view text) { return read(text).segments; }

TEST(TekReader, DrawsInTwelveBits) {
  const std::vector<VectorSegment> expected{{1, 2, 4095, 3119, 1}, {4095, 3119, 700, 0, 1}};
  EXPECT_EQ(strokes("\x1d" + at(1, 2) + at(4095, 3119) + at(700, 0)), expected);
}

TEST(TekReader, TenBitAddressesAreMultiplesOfFour) {
  // High and low y, high and low x, then what has changed alone.
  const std::vector<VectorSegment> expected{
      {4, 8, 4, 12, 1}, {4, 12, 32, 12, 1}, {32, 12, 32, 140, 1}};
  EXPECT_EQ(strokes("\x1d b Ac AcH!cH"s.substr(0, 5) + "cAHcH"s.substr(0, 2) + "H" + "!cH"s),
            expected);
}

TEST(TekReader, TheExtraByteLastsUntilALowYComesWithoutIt) {
  const auto s = strokes("\x1d" + at(5, 6) + "A" + "`A");
  ASSERT_EQ(s.size(), 2u);
  EXPECT_EQ(s[0], (VectorSegment{5, 6, 5, 6, 1}));
  EXPECT_EQ(s[1], (VectorSegment{5, 6, 4, 0, 1}));
}

TEST(TekReader, BellAfterGsLightsTheFirstVector) {
  EXPECT_EQ(strokes("\x1d\a" + at(8, 8)), (std::vector<VectorSegment>{{0, 2992, 8, 8, 1}}));
  EXPECT_EQ(read("\a").events.size(), 1u);
}

TEST(TekReader, PointsAndSpecialPoints) {
  EXPECT_EQ(strokes("\x1c" + at(1, 2) + at(3, 4)),
            (std::vector<VectorSegment>{{1, 2, 1, 2, 1}, {3, 4, 3, 4, 1}}));
  const auto special = strokes("\x1b\x1c\x3f" + at(1, 2) + "\x27" + at(3, 4));
  ASSERT_EQ(special.size(), 2u);
  EXPECT_EQ(special[0].intensity, 1);
  EXPECT_EQ(special[1].intensity, 0.25f);
}

TEST(TekReader, IncrementsGoEightWays) {
  const std::vector<VectorSegment> around{{100, 100, 101, 100, 1}, {101, 100, 102, 101, 1},
                                          {102, 101, 102, 102, 1}, {102, 102, 101, 103, 1},
                                          {101, 103, 100, 103, 1}, {100, 103, 99, 102, 1},
                                          {99, 102, 99, 101, 1},   {99, 101, 100, 100, 1}};
  EXPECT_EQ(strokes("\x1d" + at(100, 100) + "\x1ePAEDFBJHI"), around);
  EXPECT_EQ(strokes("\x1d" + at(100, 100) + "\x1e AAAPA"),
            (std::vector<VectorSegment>{{103, 100, 104, 100, 1}}));
}

TEST(TekReader, LineTypes) {
  const VectorDrawing drawing = read("\x1d" + at(0, 0) + at(8, 0) + "\x1b\x62" + at(8, 8) +
                                     "\x1bs" + at(0, 8) + "\x1b`" + at(0, 0));
  ASSERT_EQ(drawing.pens.size(), 3u);
  EXPECT_EQ(drawing.pens[0].segments, 1u);
  EXPECT_EQ(drawing.pens[0].pen.style, LineStyle::kDotDash);
  EXPECT_EQ(drawing.pens[1].pen.style, LineStyle::kShortDash);
  EXPECT_TRUE(drawing.pens[1].pen.write_through);
  EXPECT_EQ(drawing.pens[2].pen, VectorPen{});
}

TEST(TekReader, FourSizesOfCharacters) {
  constexpr int kWidths[] = {56, 51, 34, 31};
  constexpr int kHomes[] = {2992, 3034, 3021, 3024};
  for (int size = 0; size < 4; ++size) {
    const auto texts =
        read("\x1b"s + static_cast<char>('8' + size) + "\x1b\x0c" + "ab\tc\rd").texts;
    ASSERT_EQ(texts.size(), 3u);
    EXPECT_EQ(texts[0].text, "ab");
    EXPECT_EQ(texts[0].place, glm::vec2(0, kHomes[size]));
    EXPECT_EQ(texts[0].advance.x, kWidths[size]);
    EXPECT_EQ(texts[1].place.x, 3.0f * kWidths[size]);
    EXPECT_EQ(texts[2].place.x, 0);
  }
}

TEST(TekReader, TextWrapsAndTurnsToTheSecondMargin) {
  const auto wrapped = read(std::string(75, 'x')).texts;
  ASSERT_EQ(wrapped.size(), 2u);
  EXPECT_EQ(wrapped[0].text.size(), 74u);
  EXPECT_EQ(wrapped[1].place, glm::vec2(0, 2992 - 88));
  const auto second = read(std::string(35, '\n') + "\rhere").texts;
  ASSERT_EQ(second.size(), 1u);
  EXPECT_EQ(second[0].place, glm::vec2(2048, 2992));
}

TEST(TekReader, TextBeginsWhereTheBeamIs) {
  const auto texts = read("\x1d" + at(100, 200) + "\x1f  label").texts;
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts[0].place, glm::vec2(212, 200));
  EXPECT_EQ(texts[0].text, "label");
}

TEST(TekReader, PagesAreToldApart) {
  const VectorDrawing drawing = read("\x1b\x0c\x1d" + at(0, 0) + at(4, 4) + "\x1b\x62" + at(8, 4) +
                                     "\x1b\x0c\x1d" + at(8, 8) + at(9, 9) + "\x1b\x17");
  const auto all = pages(drawing);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].segments.size(), 2u);
  EXPECT_EQ(all[1].segments, (std::vector<VectorSegment>{{8, 8, 9, 9, 1}}));
  EXPECT_EQ(drawing.events.back().kind, DrawingEvent::Kind::kHardCopy);
}

TEST(TekReader, AnswersWhereTheBeamAndTheCrosshairAre) {
  TekReader terminal;
  VectorDrawing drawing;
  terminal.read(bytes_of("\x1d" + at(4000, 2000) + "\x1b\x05"), drawing);
  // 1000 is 31 * 32 + 8, 500 is 15 * 32 + 20.
  EXPECT_EQ(terminal.take_replies(), "4?(/4\r");
  terminal.press('x', 0, 0);
  EXPECT_EQ(terminal.take_replies(), "") << "no crosshair was asked for";
  terminal.read(bytes_of("\x1b\x1a"), drawing);
  EXPECT_TRUE(terminal.crosshair_shown());
  terminal.press('k', 4, 132);
  EXPECT_EQ(terminal.take_replies(), "k !!!\r");
  EXPECT_FALSE(terminal.crosshair_shown());
}

TEST(TekReader, WhatAnXtermSendsToItsOtherWindowIsNotDrawn) {
  EXPECT_TRUE(read("\x1b[?38h\x1b[?38lprompt> ").texts.empty());
  EXPECT_EQ(read("\x1b[?38h\x1b\x03prompt\x1b[?38hback").texts.size(), 1u);
  EXPECT_EQ(read("\x1b[?38lshown").texts.size(), 1u) << "no xterm";
}

TEST(TekReader, PiecesGiveWhatTheWholeGives) {
  const std::string stream =
      "\x1b\x0c\x1d" + at(3, 4) + at(50, 60) + "\x1f label\x1b\x3a b\x1e PAAEE";
  const VectorDrawing whole = read(stream);
  TekReader terminal;
  VectorDrawing pieces;
  for (const char& c : stream) terminal.read(bytes_of({&c, 1}), pieces);
  terminal.flush(pieces);
  EXPECT_EQ(pieces.segments, whole.segments);
  ASSERT_EQ(pieces.texts.size(), whole.texts.size());
}

TEST(TekReader, AnyBytesAreHarmless) {
  std::mt19937 random(1);
  std::size_t most = 0;
  for (int n = 0; n < 2000; ++n) {
    std::string stream;
    for (int i = 0; i < 300; ++i) {
      const auto r = random();
      stream += static_cast<char>(r % 8 == 0 ? r >> 8 & 31 : r >> 8 & 127);
    }
    const VectorDrawing drawing = beam_strokes(read(stream));
    for (const VectorSegment& s : drawing.segments) {
      ASSERT_LE(std::abs(s.x2), 1e5f);
      ASSERT_LE(std::abs(s.y2), 1e5f);
    }
    most = std::max(most, drawing.segments.size());
  }
  EXPECT_GT(most, 50u);
}

}  // namespace
}  // namespace kinescope
