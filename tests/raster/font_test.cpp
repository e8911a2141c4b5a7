#include "raster/path/font.h"

#include <ft2build.h>
#include <gtest/gtest.h>
#include FT_OUTLINE_H

#include "raster/base/error.h"
#include "raster/path/utf8.h"
#include "tests/raster/free_type_face.h"

namespace kinescope {
namespace {

constexpr Srgb8 kClear{0, 0, 0, 0}, kWhite{255, 255, 255, 255};

/// Text drawn on nothing: alpha is its coverage.
Image<Srgb8> drawn(const Font& font, std::string_view text, float size_px, int width = 60,
                   int height = 60, float x = 10, float y = 45) {
  Image<Srgb8> picture(width, height, kClear);
  font.draw(picture, x, y, text, size_px, kWhite);
  return picture;
}

int ink(const Image<Srgb8>& picture) {
  int sum = 0;
  for (const Srgb8 p : picture.pixels()) sum += p.a;
  return sum;
}

constexpr int kSide = 60, kPenX = 10, kBaseline = 45, kScale = 16;

/// The loaded glyph by FreeType's own rasterizer, 0 to 255 a pixel. Drawn 16 times as large and
/// averaged, since it takes curves only to within 1/16 of a pixel.
std::vector<double> by_freetype(FT_Library library, FT_Outline& outline) {
  for (int i = 0; i < outline.n_points; ++i) {
    outline.points[i].x = (outline.points[i].x + kPenX * 64) * kScale;
    outline.points[i].y = (outline.points[i].y + (kSide - kBaseline) * 64) * kScale;
  }
  constexpr int kLarge = kSide * kScale;
  std::vector<unsigned char> large(kLarge * kLarge);
  const FT_Bitmap bitmap{kLarge, kLarge, kLarge, large.data(), 256, FT_PIXEL_MODE_GRAY, 0, nullptr};
  EXPECT_EQ(FT_Outline_Get_Bitmap(library, &outline, &bitmap), 0);
  std::vector<double> pixels(kSide * kSide);
  for (int y = 0; y < kLarge; ++y) {
    for (int x = 0; x < kLarge; ++x) {
      pixels[static_cast<std::size_t>(y / kScale * kSide + x / kScale)] +=
          large[static_cast<std::size_t>(y * kLarge + x)] / double{kScale * kScale};
    }
  }
  return pixels;
}

TEST(Font, CoversPixelsAsFreeTypeDoes) {
  const FreeTypeFace oracle;
  const FT_Face face = oracle.face();
  const Font font = Font::sans();
  double worst = 0;
  for (const int size : {12, 17, 32}) {
    FT_Set_Char_Size(face, 0, size * 64, 72, 72);
    for (const char letter : std::string_view("aBgQ@S&%3$ij|W8")) {
      ASSERT_EQ(FT_Load_Char(face, static_cast<FT_ULong>(letter),
                             FT_LOAD_TARGET_LIGHT | FT_LOAD_NO_BITMAP),
                0);
      const std::vector<double> theirs = by_freetype(oracle.library(), face->glyph->outline);
      const Image<Srgb8> ours =
          drawn(font, {&letter, 1}, static_cast<float>(size), kSide, kSide, kPenX, kBaseline);
      for (std::size_t i = 0; i < theirs.size(); ++i) {
        ASSERT_NEAR(ours.pixels()[i].a, theirs[i], 1.5)
            << letter << ' ' << size << ": " << i % kSide << ' ' << i / kSide;
        worst = std::max(worst, std::abs(ours.pixels()[i].a - theirs[i]));
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

TEST(Font, WidthsScaleAndAddUp) {
  const Font sans = Font::sans(), mono = Font::mono();
  EXPECT_NEAR(sans.width_px("Phosphor", 24), 2 * sans.width_px("Phosphor", 12), 0.3);
  EXPECT_FLOAT_EQ(mono.width_px("iiii", 16), mono.width_px("WWWW", 16));
  EXPECT_FLOAT_EQ(mono.width_px("iiii", 16), 4 * mono.width_px("i", 16));
  EXPECT_LT(sans.width_px("AV", 32), sans.width_px("A", 32) + sans.width_px("V", 32) - 0.5f)
      << "kerning";
  EXPECT_EQ(sans.width_px("", 16), 0);
  // DejaVu Sans: ascender 1901, descender -483, no gap, of 2048 units.
  EXPECT_FLOAT_EQ(sans.ascent_px(2048), 1901);
  EXPECT_FLOAT_EQ(sans.line_height_px(2048), 2384);
}

TEST(Font, ALinesOutlineIsItsCharactersSideBySide) {
  const Font font = Font::sans();
  const float em = font.units_per_em();
  EXPECT_TRUE(font.line_outline("").points.empty());
  const std::string_view text = "AV g\xc3\xa9\xff";  // kerned, a space, two bytes, and no character
  const Path line = font.line_outline(text);
  std::size_t next = 0;
  std::string before;
  for_each_code_point(text, [&](char32_t code) {
    std::string with = before;
    with += code == U'\u00e9' ? "\xc3\xa9" : code == 0xfffd ? "\xff" : std::string(1, char(code));
    const Path one = font.outline(code);
    // The pen is as far as the text so far, kerned to this character.
    const float pen = font.width_px(with, em) - font.width_px(with.substr(before.size()), em);
    for (const glm::vec2 p : one.points) {
      ASSERT_LT(next, line.points.size());
      EXPECT_NEAR(line.points[next].x, p.x + pen, 1.5f) << with;
      EXPECT_EQ(line.points[next++].y, p.y);
    }
    before = with;
  });
  EXPECT_EQ(next, line.points.size());
}

TEST(Font, DrawReturnsThePenAfterTheText) {
  const Font font = Font::sans();
  Image<Srgb8> picture(300, 40, kClear);
  const float pen = font.draw(picture, 5.3f, 30, "retrace", 18, kWhite);
  EXPECT_NEAR(pen, 5.3f + font.width_px("retrace", 18), 1e-3);
}

// Shifting the text by whole pixels shifts the pixels; clipping takes some away and changes none.
TEST(Font, ClippingAndWholeShiftsKeepPixels) {
  const Font font = Font::sans();
  const Image<Srgb8> whole = drawn(font, "scan line 525", 20, 160, 60, 20, 40);
  for (const int shift : {-31, -7, 13, 50, 140}) {
    Image<Srgb8> part(90, 30, kClear);
    font.draw(part, static_cast<float>(20 + shift), 40 - 20, "scan line 525", 20, kWhite);
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 90; ++x) {
        const int from = x - shift;
        const Srgb8 expected = from >= 0 && from < 160 ? whole.at(from, y + 20) : kClear;
        ASSERT_EQ(part.at(x, y).a, expected.a) << shift << ": " << x << ' ' << y;
      }
    }
  }
  Image<Srgb8> tiny(1, 1, kClear);
  font.draw(tiny, 1e6f, -1e6f, "far away", 30, kWhite);
  EXPECT_EQ(tiny.at(0, 0), kClear);
}

TEST(Font, MissingGlyphsDrawABox) {
  const Font font = Font::sans();
  const Image<Srgb8> one = drawn(font, "\U000F1234", 24), two = drawn(font, "\U0010FFF0", 24);
  EXPECT_GT(ink(one), 1000);
  EXPECT_EQ(one, two);
  EXPECT_GT(font.width_px("\U000F1234", 24), 8);
  EXPECT_EQ(ink(drawn(font, " ", 24)), 0);
}

TEST(Font, RefusesWhatIsNoFont) {
  for (const std::string& text :
       {std::string(), std::string("not a font at all"), std::string(1000, '\0')}) {
    EXPECT_THROW(Font({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}), Error);
  }
  const std::string_view whole = embedded::dejavu_sans();
  EXPECT_THROW(Font({reinterpret_cast<const std::uint8_t*>(whole.data()), 500}), Error);
}

TEST(Font, MovesAndDrawsTheSameAgain) {
  Font font = Font::mono();
  const Image<Srgb8> before = drawn(font, "60 Hz", 15);
  Font moved = std::move(font);
  EXPECT_EQ(drawn(moved, "60 Hz", 15), before);
  drawn(moved, "60 Hz", 31);  // another size in between
  EXPECT_EQ(drawn(moved, "60 Hz", 15), before);
}

std::u32string decoded(std::string_view text) {
  std::u32string all;
  for_each_code_point(text, [&](char32_t c) { all += c; });
  return all;
}

TEST(Utf8, DecodesEveryCodePoint) {
  for (char32_t c = 1; c < 0x110000; ++c) {
    if (c >= 0xd800 && c < 0xe000) continue;
    std::string text;
    const auto put = [&](unsigned v) { text += static_cast<char>(v); };
    if (c < 0x80) {
      put(c);
    } else if (c < 0x800) {
      put(0xc0 | c >> 6);
      put(0x80 | (c & 63));
    } else if (c < 0x10000) {
      put(0xe0 | c >> 12);
      put(0x80 | (c >> 6 & 63));
      put(0x80 | (c & 63));
    } else {
      put(0xf0 | c >> 18);
      put(0x80 | (c >> 12 & 63));
      put(0x80 | (c >> 6 & 63));
      put(0x80 | (c & 63));
    }
    ASSERT_EQ(decoded(text), std::u32string(1, c));
  }
}

TEST(Utf8, ReplacesWhatFitsNowhereAndGoesOn) {
  const std::u32string bad1 = U"\ufffdx", bad2 = U"\ufffd\ufffdx", bad3 = U"\ufffd\ufffd\ufffdx";
  EXPECT_EQ(decoded("\x80x"), bad1);
  EXPECT_EQ(decoded("\xffx"), bad1);
  EXPECT_EQ(decoded("\xc3x"), bad1);
  EXPECT_EQ(decoded("\xc0\xafx"), bad2) << "overlong";
  EXPECT_EQ(decoded("\xe0\x80\x80x"), bad3) << "overlong";
  EXPECT_EQ(decoded("\xed\xa0\x80x"), bad3) << "surrogate";
  EXPECT_EQ(decoded("\xe2\x82"), U"\ufffd\ufffd") << "cut off";
  EXPECT_EQ(decoded("\xf4\x90\x80\x80").size(), 4u) << "beyond Unicode";
}

}  // namespace
}  // namespace kinescope
