// SVG by hand; tests/compare_vectors holds the reader to librsvg on whole drawings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>

#include "display/vector/input/svg_reader.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

using ::testing::HasSubstr;

VectorDrawing read_whole(std::string_view text) {
  return read_svg({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "a.svg");
}

/// A body on a square of 100 user units.
VectorDrawing read(const std::string& body) {
  return read_whole(
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:x='http://www.w3.org/1999/xlink' "
      "width='100' height='100' stroke='black' fill='none'>" +
      body + "</svg>");
}

/// "x1,y1-x2,y2 ..." y downwards again, rounded to hundredths.
std::string lines(const std::string& body) {
  std::string out;
  for (const VectorSegment& s : read(body).segments) {
    const auto r = [](float v) { return std::round(100 * static_cast<double>(v)) / 100 + 0.0; };
    char part[99];
    std::snprintf(part, sizeof part, "%s%g,%g-%g,%g", out.empty() ? "" : " ", r(s.x1),
                  r(100 - s.y1), r(s.x2), r(100 - s.y2));
    out += part;
  }
  return out;
}

TEST(SvgReader, PathsAndShapes) {
  EXPECT_EQ(lines("<path d='M10 20h30v5z'/>"), "10,20-40,20 40,20-40,25 40,25-10,20");
  EXPECT_EQ(lines("<line x1='1' y1='2' x2='3' y2='4'/>"), "1,2-3,4");
  EXPECT_EQ(lines("<polyline points='1,2 3,4,5 6'/>"), "1,2-3,4 3,4-5,6");
  EXPECT_EQ(lines("<polygon points='0 0 9 0 9 9'/>"), "0,0-9,0 9,0-9,9 9,9-0,0");
  EXPECT_EQ(lines("<rect x='10%' y='1mm' width='10' height='5'/>"),
            "10,3.78-20,3.78 20,3.78-20,8.78 20,8.78-10,8.78 10,8.78-10,3.78");
  for (const VectorSegment& s : read("<circle cx='50' cy='50' r='40'/>").segments) {
    EXPECT_NEAR(std::hypot(s.x1 - 50, s.y1 - 50), 40, 0.06);
  }
  EXPECT_EQ(lines("<rect width='0' height='5'/><circle r='-1'/><path d=''/><line/>"), "0,0-0,0");
}

TEST(SvgReader, TransformsNest) {
  EXPECT_EQ(lines("<g transform='translate(10 20)'><g transform='scale(2)'><path d='M1 1L2 3'/></g>"
                  "</g>"),
            "12,22-14,26");
  EXPECT_EQ(lines("<path transform='rotate(90)' d='M10 0L20 0'/>"), "0,10-0,20");
  EXPECT_EQ(lines("<path transform='rotate(90 50 50), translate(1)' d='M49 50h9'/>"),
            "50,50-50,59");
  EXPECT_EQ(lines("<path transform='matrix(1 0 .5 1 2 3) skewX(45)' d='M0 0v2'/>"), "2,3-5,5");
}

TEST(SvgReader, ViewBoxesFit) {
  const auto first = [](const std::string& attributes) {
    return read_whole("<svg " + attributes + "><path stroke='red' d='M0 0L10 10'/></svg>")
        .segments.at(0);
  };
  EXPECT_EQ(first("viewBox='0 0 10 10' width='200' height='100'"),
            (VectorSegment{50, 100, 150, 0, 1}));
  EXPECT_EQ(first("viewBox='0 0 10 10' width='200' height='100' preserveAspectRatio='none'"),
            (VectorSegment{0, 100, 200, 0, 1}));
  EXPECT_EQ(first("viewBox='0 0 10 10' width='200' height='100' preserveAspectRatio='xMinYMin "
                  "slice'"),
            (VectorSegment{0, 100, 200, -100, 1}));
}

TEST(SvgReader, UsesAndNestedViewports) {
  EXPECT_EQ(lines("<defs><path id='p' d='M0 0h5'/></defs><use href='#p' x='3' y='4'/>"), "3,4-8,4");
  EXPECT_EQ(lines("<symbol id='s' viewBox='0 0 10 10'><path d='M0 0L10 10'/></symbol>"
                  "<use x:href='#s' x='10' width='20' height='20'/>"),
            "10,0-30,20");
  EXPECT_EQ(lines("<svg x='10' y='10' width='20' height='20'><path d='M-50 5H50'/></svg>"),
            "10,15-30,15")
      << "cut to its viewport";
  EXPECT_EQ(lines("<use href='#nowhere'/><path id='q' d='M0 0h1'/>"), "0,0-1,0");
}

TEST(SvgReader, StylesCascade) {
  EXPECT_EQ(
      lines("<style>.a{display:none} /* no */ #b, path {stroke-width:4}</style><path class='c a' "
            "d='M0 0h1'/><path id='b' d='M0 0h2'/>"),
      "0,0-2,0");
  const VectorDrawing drawing = read(
      "<g stroke='#f00' opacity='.5'><path style='stroke-width:3;stroke-opacity:50%' "
      "d='M0 0h1'/></g><path stroke='rgb(0,100%,0)' d='M0 0h1'/>");
  EXPECT_EQ(drawing.segments[0].intensity, 0.25f);
  EXPECT_EQ(drawing.pens[0].pen.colour, (Srgb8{255, 0, 0}));
  EXPECT_EQ(drawing.pens[0].pen.width, 3);
  EXPECT_EQ(drawing.pens[1].pen.colour, (Srgb8{0, 255, 0}));
  EXPECT_EQ(lines("<path visibility='hidden' d='M0 0h1'/><path stroke='none' d='M0 0h2'/>"), "");
}

TEST(SvgReader, DashesBreakStrokes) {
  EXPECT_EQ(lines("<path stroke-dasharray='3 2' d='M0 0h9'/>"), "0,0-3,0 5,0-8,0");
  EXPECT_EQ(lines("<path stroke-dasharray='3 2' stroke-dashoffset='4' d='M0 0h9'/>"),
            "1,0-4,0 6,0-9,0");
  EXPECT_EQ(lines("<path stroke-dasharray='4' d='M0 0h6v6'/>"), "0,0-4,0 6,2-6,6");
}

TEST(SvgReader, TextIsOneLineAtItsAnchor) {
  const auto texts =
      read(
          "<text x='50' y='20' text-anchor='middle' font-size='10' fill='red'> two\n <tspan>words"
          "</tspan></text>")
          .texts;
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts[0].text, "two words");
  EXPECT_EQ(texts[0].place, glm::vec2(23, 80));
}

std::string fault_of(const std::string& text) {
  try {
    read_whole(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    return error.what();
  }
  return "none";
}

TEST(SvgReader, BadFilesAreOneClearLine) {
  EXPECT_THAT(fault_of("<svg><g></svg>"), HasSubstr("a.svg: line 1: is no sound XML"));
  EXPECT_THAT(fault_of("<svg"), HasSubstr("is no sound XML"));
  EXPECT_THAT(fault_of(""), HasSubstr("is no sound XML"));
  EXPECT_THAT(fault_of("<html/>"), HasSubstr("no SVG"));
  EXPECT_THAT(fault_of("<svg width='-1' height='5'/>"), HasSubstr("no size"));
  EXPECT_THAT(fault_of("<svg width='1e30' height='5'/>"), HasSubstr("no size"));
}

TEST(SvgReader, BombsAreRefused) {
  std::string deep = "<svg>";
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  EXPECT_THAT(fault_of(deep), HasSubstr("nested too deep"));

  std::string laughs = "<!DOCTYPE svg [<!ENTITY a0 '<path d=\"M0 0h1\"/>'>";
  for (int i = 1; i < 12; ++i) {
    laughs += "<!ENTITY a" + std::to_string(i) + " '";
    for (int k = 0; k < 10; ++k) laughs += "&a" + std::to_string(i - 1) + ";";
    laughs += "'>";
  }
  EXPECT_THAT(fault_of(laughs + "]><svg>&a11;</svg>"), HasSubstr("amplification"));

  std::string uses = "<svg><g id='u0'><path d='M0 0h1'/></g>";
  for (int i = 1; i < 15; ++i) {
    uses += "<g id='u" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) uses += "<use href='#u" + std::to_string(i - 1) + "'/>";
    uses += "</g>";
  }
  EXPECT_THAT(fault_of(uses + "</svg>"), HasSubstr("refers to itself too often"));
  EXPECT_EQ(fault_of("<svg><g id='me'><use href='#me'/></g></svg>"), "none") << "ends by itself";
}

}  // namespace
}  // namespace kinescope
