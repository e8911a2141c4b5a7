// Bitmap and stroke fonts by hand and by law; outlines beside FreeType's own scan converter.
#include <ft2build.h>
#include <gtest/gtest.h>
#include FT_OUTLINE_H

#include <cmath>
#include <limits>

#include "hershey_roman_simplex.h"
#include "raster/base/error.h"
#include "raster/characters/bitmap_font.h"
#include "raster/characters/glyph_scan.h"
#include "raster/characters/stroke_font.h"
#include "raster/line.h"
#include "raster/path/font.h"
#include "tests/raster/ascii.h"
#include "tests/raster/free_type_face.h"

namespace kinescope {
namespace {

using testing::AsciiCanvas;

TEST(CharactersBitmap, FixedDrawsItsPixels) {
  const BitmapFont font = BitmapFont::fixed();
  EXPECT_EQ(font.ascent(), 11);
  EXPECT_EQ(font.descent(), 2);
  AsciiCanvas canvas(14, 13);
  EXPECT_EQ(font.draw("A1", {1, 11}, canvas), glm::ivec2(13, 11));
  EXPECT_EQ(canvas.text(),
            "..............\n"
            "..............\n"
            "...#.....#....\n"
            "..#.#...##....\n"
            ".#...#.#.#....\n"
            ".#...#...#....\n"
            ".#...#...#....\n"
            ".#####...#....\n"
            ".#...#...#....\n"
            ".#...#...#....\n"
            ".#...#.#####..\n"
            "..............\n"
            "..............\n");
  EXPECT_EQ(canvas.outside(), 0);
  EXPECT_EQ(font.glyph(U'\u4e00'), font.glyph(U'?')) << "what the font lacks";
  for (char32_t c = 32; c < 127; ++c) EXPECT_EQ(font.glyph(c)->advance, 6);
}

constexpr const char* kSmallFont =
    "STARTFONT 2.1\r\nFONT_ASCENT 3\nSTARTCHAR a\nENCODING 97\nDWIDTH 4 0\nBBX 3 2 -1 1\nBITMAP\n"
    "a0\nE0\nENDCHAR\nENDFONT\n";

TEST(CharactersBitmap, BoxesStandWhereTheySay) {
  const BitmapFont font = BitmapFont::parse_bdf(kSmallFont, "small");
  AsciiCanvas canvas(5, 4);
  font.draw("a", {1, 3}, canvas);
  EXPECT_EQ(canvas.text(), "#.#..\n###..\n.....\n.....\n");
  EXPECT_EQ(font.glyph(U'b'), nullptr) << "no question mark either";
  EXPECT_EQ(font.draw("b", {1, 3}, canvas), glm::ivec2(1, 3));
}

TEST(CharactersBitmap, BrokenFontsSayWhere) {
  const std::string whole = kSmallFont;
  const auto broken = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  for (const std::string& text :
       {std::string(), std::string("STARTFONT 2.1\nENDFONT\n"), broken("STARTFONT", "FONT"),
        broken("BBX 3 2 -1 1", "BBX 3 2"), broken("BBX 3 2", "BBX 3000000 2"),
        broken("BBX 3 2", "BBX -3 2"), broken("a0\nE0\n", "a0\n"), broken("a0", "g0"),
        broken("a0", ""), broken("ENDCHAR\nENDFONT\n", ""), broken("DWIDTH 4", "DWIDTH 99999"),
        broken("ENCODING 97", "ENCODING x"), broken("BITMAP\na0\nE0\n", "")}) {
    EXPECT_THROW(BitmapFont::parse_bdf(text, "broken.bdf"), Error) << text;
  }
}

TEST(CharactersStroke, RomanSimplexIsTheRomanAlphabet) {
  const StrokeFont font = StrokeFont::roman_simplex();
  EXPECT_EQ(font.size(), 96u);
  // Capital I is one stroke from cap height to baseline in the middle.
  const StrokeGlyph* i = font.glyph(U'I');
  ASSERT_EQ(i->polylines.size(), 1u);
  EXPECT_EQ(i->polylines[0], (std::vector<glm::ivec2>{{0, -12}, {0, 9}}));
  EXPECT_EQ(font.glyph(U' ')->polylines.size(), 0u);
  EXPECT_EQ(font.glyph(U'H')->polylines.size(), 3u);
  EXPECT_EQ(font.glyph(U'\u00e9'), font.glyph(U'?'));
  for (char32_t c = 33; c < 127; ++c) {
    for (const auto& line : font.glyph(c)->polylines) {
      for (const glm::ivec2 p : line) EXPECT_TRUE(p.y >= -16 && p.y <= 16) << int(c);
    }
  }
  AsciiCanvas canvas(9, 12);
  const glm::dvec2 pen = font.draw("L", {0, 10}, 0.5, [&](glm::dvec2 a, glm::dvec2 b) {
    const auto at = [](double v) { return static_cast<int>(std::floor(v + 0.5)); };
    bresenham(at(a.x), at(a.y), at(b.x), at(b.y), canvas);
  });
  EXPECT_EQ(pen, glm::dvec2(8.5, 10));
  EXPECT_EQ(canvas.outside(), 0);
  EXPECT_EQ(canvas.text().substr(90, 20), "..#......\n..2######\n") << "the corner twice";
}

TEST(CharactersStroke, LongGlyphsMayBreakTheirLines) {
  const StrokeFont whole = StrokeFont::parse_jhf("  700  4G]RFR[ R\n", "a");
  const StrokeFont broken = StrokeFont::parse_jhf("  700  4G]RF\nR[ R", "b");
  EXPECT_EQ(whole.size(), 1u);
  EXPECT_EQ(broken.size(), 1u);
}

TEST(CharactersStroke, BrokenFontsSayWhere) {
  for (const char* text : {"", "\n\n", "  700", "  700  0", "  700 1x", "  700  4G]RF",
                           "  700 -1G]", "  700999G]RFR[ R", "  700  2G]\x01R"}) {
    EXPECT_THROW(StrokeFont::parse_jhf(text, "broken.jhf"), Error) << text;
  }
  const std::string_view whole = embedded::hershey_roman_simplex();
  EXPECT_THROW(StrokeFont::parse_jhf(whole.substr(0, whole.size() - 4), "cut.jhf"), Error);
}

constexpr int kSide = 48;

/// FreeType's outline as a path in pixels, y downwards.
Path path_of(FT_Outline& outline) {
  Path path;
  const auto at = [](const FT_Vector* p) {
    return glm::vec2(static_cast<float>(p->x) / 64, kSide - static_cast<float>(p->y) / 64);
  };
  struct Sink {
    Path& path;
    decltype(at)& place;
  } sink{path, at};
  const FT_Outline_Funcs into{
      [](const FT_Vector* to, void* user) {
        Sink& s = *static_cast<Sink*>(user);
        s.path.move_to(s.place(to));
        return 0;
      },
      [](const FT_Vector* to, void* user) {
        Sink& s = *static_cast<Sink*>(user);
        s.path.line_to(s.place(to));
        return 0;
      },
      [](const FT_Vector* c, const FT_Vector* to, void* user) {
        Sink& s = *static_cast<Sink*>(user);
        s.path.quadratic_to(s.place(c), s.place(to));
        return 0;
      },
      [](const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* user) {
        Sink& s = *static_cast<Sink*>(user);
        s.path.cubic_to(s.place(a), s.place(b), s.place(to));
        return 0;
      },
      0,
      0};
  FT_Outline_Decompose(&outline, &into, &sink);
  return path;
}

std::vector<bool> by_freetype(FT_Library library, FT_Outline& outline, int flags) {
  outline.flags = flags | FT_OUTLINE_HIGH_PRECISION;
  std::vector<unsigned char> bits(kSide * kSide / 8);
  const FT_Bitmap bitmap{kSide, kSide, kSide / 8, bits.data(), 2, FT_PIXEL_MODE_MONO, 0, nullptr};
  EXPECT_EQ(FT_Outline_Get_Bitmap(library, &outline, &bitmap), 0);
  std::vector<bool> pixels;
  for (int i = 0; i < kSide * kSide; ++i) {
    pixels.push_back(bits[static_cast<std::size_t>(i / 8)] >> (7 - i % 8) & 1);
  }
  return pixels;
}

int differing(const Image<GlyphPixel>& ours, const std::vector<bool>& theirs) {
  int count = 0;
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    count += (ours.pixels()[i] != GlyphPixel::kOff) != theirs[i];
  }
  return count;
}

// At small sizes every thin stroke falls between centres somewhere.
TEST(CharactersOutline, FillsAndMendsAsFreeTypeDoes) {
  const FreeTypeFace oracle;
  const FT_Face face = oracle.face();
  int filled = 0, fill_apart = 0, mended = 0, mend_apart = 0;
  for (const int size : {6, 7, 8, 9, 11, 14, 20, 29}) {
    FT_Set_Char_Size(face, 0, size * 64, 72, 72);
    for (FT_ULong code = 33; code < 127; ++code) {
      ASSERT_EQ(FT_Load_Char(face, code, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP), 0);
      FT_Outline& outline = face->glyph->outline;
      FT_Outline_Translate(&outline, 5 * 64 + 13, 12 * 64 + 7);
      GlyphScan scan(path_of(outline), {1, 0, 0, 1, 0, 0}, kSide, kSide);
      scan.skip_fitting();
      ASSERT_TRUE(scan.next());
      ASSERT_EQ(scan.step(), GlyphScan::Step::kFill);
      fill_apart += differing(scan.pixels(),
                              by_freetype(oracle.library(), outline, FT_OUTLINE_IGNORE_DROPOUTS));
      for (const GlyphPixel p : scan.pixels().pixels()) filled += p != GlyphPixel::kOff;
      ASSERT_TRUE(scan.next());
      mend_apart += differing(scan.pixels(),
                              by_freetype(oracle.library(), outline, FT_OUTLINE_INCLUDE_STUBS));
      for (const GlyphPixel p : scan.pixels().pixels()) mended += p > GlyphPixel::kInside;
      ASSERT_FALSE(scan.next());
    }
  }
  RecordProperty("apart", std::to_string(fill_apart) + " of " + std::to_string(filled));
  EXPECT_GT(mended, 1000) << "the comparison means something";
  // It cuts curves otherwise.
  EXPECT_LE(fill_apart, filled / 500) << filled;
  EXPECT_LE(mend_apart, mended / 50 + filled / 500) << mended << ", fill " << fill_apart;
}

Path bar(float x0, float y0, float x1, float y1) {
  Path path;
  path.move_to({x0, y0});
  path.line_to({x1, y0});
  path.line_to({x1, y1});
  path.line_to({x0, y1});
  return path;
}

TEST(CharactersOutline, ThinStrokesAreMended) {
  GlyphScan upright(bar(2.6f, 1, 3.4f, 5), {1, 0, 0, 1, 0, 0}, 6, 6);
  upright.skip_fitting();
  upright.next();
  EXPECT_EQ(upright.pixels(), (Image<GlyphPixel>(6, 6, GlyphPixel::kOff))) << "it fell between";
  upright.next();
  for (int y = 1; y < 5; ++y) EXPECT_EQ(upright.pixels().at(2, y), GlyphPixel::kDropoutRow);
  GlyphScan level(bar(1, 2.6f, 5, 3.4f), {1, 0, 0, 1, 0, 0}, 6, 6);
  level.skip_fitting();
  while (level.next()) {
  }
  for (int x = 1; x < 5; ++x) EXPECT_EQ(level.pixels().at(x, 3), GlyphPixel::kDropoutColumn);
}

TEST(CharactersOutline, FourStepsOfALetter) {
  const Font font = Font::sans();
  const float scale = 20 / font.units_per_em();
  GlyphScan scan(font.outline(U'H'), {scale, 0, 0, -scale, 2, 18.3f}, 24, 24);
  EXPECT_EQ(scan.step(), GlyphScan::Step::kNone);
  ASSERT_TRUE(scan.next());
  float bottom = 0;
  for (const glm::vec2 p : scan.outline().points) bottom = std::max(bottom, p.y);
  EXPECT_NEAR(bottom, 18.3f, 1e-4);
  ASSERT_TRUE(scan.next());
  float top = 99;
  bottom = 0;
  for (const glm::vec2 p : scan.outline().points) {
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  EXPECT_NEAR(bottom, 18, 1e-4);
  EXPECT_NEAR(top, std::round(18.3 - 20 * 1493.0 / 2048), 1e-4)
      << "DejaVu's capitals are 1493 high";
  while (scan.next()) {
  }
  EXPECT_EQ(scan.step(), GlyphScan::Step::kDropout);
  int on = 0;
  for (const GlyphPixel p : scan.pixels().pixels()) on += p != GlyphPixel::kOff;
  EXPECT_GT(on, 60);
}

TEST(CharactersOutline, EmptyAndBrokenOutlines) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Path broken = bar(kNan, 1, 3, kNan);
  for (const Path& path : {Path(), broken}) {
    GlyphScan scan(path, {1, 0, 0, 1, 0, 0}, 8, 8);
    while (scan.next()) {
    }
    EXPECT_EQ(scan.pixels(), (Image<GlyphPixel>(8, 8, GlyphPixel::kOff)));
  }
  GlyphScan none(bar(1, 1, 3, 3), {1, 0, 0, 1, 0, 0}, 0, 0);
  while (none.next()) {
  }
  GlyphScan far(bar(1, 1, 1e20f, 3), {1, 0, 0, 1, 0, 0}, 8, 8);
  EXPECT_THROW(while (far.next()){}, Error);
}

}  // namespace
}  // namespace kinescope
