#include "raster/path/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <array>
#include <cassert>
#include <cmath>
#include <string>
#include <unordered_map>
#include <vector>

#include "dejavu_sans.h"
#include "dejavu_sans_mono.h"
#include "raster/base/direct_cache.h"
#include "raster/base/error.h"
#include "raster/path/exact_area.h"
#include "raster/path/flatten.h"
#include "raster/path/glyph_painter.h"
#include "raster/path/utf8.h"

namespace kinescope {
namespace {

// Pens stand at quarters of a pixel: letters stay evenly spaced without a bitmap for every place.
constexpr int kPhases = 4;
// A curve this far from its chord changes a pixel by less than half a code of 255.
constexpr float kTolerancePx = 1.0f / 512;
[[maybe_unused]] constexpr float kLargestPx = 2048;

// FreeType has whole units between a curve's control points, 1/64 pixel each unless shifted: too
// coarse, since half a unit is two codes of coverage.
constexpr int kOutlineShift = 6;
constexpr float kUnitsPerPx = 64 << kOutlineShift;

/// Receives FreeType's outline and flattens it into edges. Outlines have y upwards.
struct OutlineSink {
  ExactArea& area;
  float left, top;
  glm::vec2 pen{0}, start{0};

  glm::vec2 place(const FT_Vector* p) const {
    return {static_cast<float>(p->x) / kUnitsPerPx - left,
            top - static_cast<float>(p->y) / kUnitsPerPx};
  }
  void line_to(glm::vec2 to) {
    area.add_edge(pen, to);
    pen = to;
  }
  void close() { line_to(start); }
};

int move_to(const FT_Vector* to, void* user) {
  OutlineSink& sink = *static_cast<OutlineSink*>(user);
  sink.close();
  sink.start = sink.pen = sink.place(to);
  return 0;
}

int line_to(const FT_Vector* to, void* user) {
  OutlineSink& sink = *static_cast<OutlineSink*>(user);
  sink.line_to(sink.place(to));
  return 0;
}

int quadratic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
  OutlineSink& sink = *static_cast<OutlineSink*>(user);
  flatten_quadratic(sink.pen, sink.place(control), sink.place(to), kTolerancePx,
                    [&](glm::vec2 p) { sink.line_to(p); });
  return 0;
}

int cubic_to(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* user) {
  OutlineSink& sink = *static_cast<OutlineSink*>(user);
  flatten_cubic(sink.pen, sink.place(a), sink.place(b), sink.place(to), kTolerancePx,
                [&](glm::vec2 p) { sink.line_to(p); });
  return 0;
}

GlyphCoverage scan_convert(FT_Outline& outline) {
  FT_BBox box;
  FT_Outline_Get_CBox(&outline, &box);
  const int left = static_cast<int>(box.xMin >> 6), top = static_cast<int>(-((box.yMax + 63) >> 6));
  ExactArea area(static_cast<int>((box.xMax + 63) >> 6) - left,
                 static_cast<int>(-(box.yMin >> 6)) - top);
  OutlineSink sink{area, static_cast<float>(left), static_cast<float>(-top)};
  const FT_Outline_Funcs callbacks{move_to, line_to, quadratic_to, cubic_to, kOutlineShift, 0};
  FT_Outline_Decompose(&outline, &callbacks, &sink);
  sink.close();
  std::vector<std::uint8_t> pixels;
  area.rows(FillRule::kNonZero, [&](int, std::span<const float> row) {
    for (const float c : row) pixels.push_back(static_cast<std::uint8_t>(c * 255 + 0.5f));
  });
  return {left, top, area.width(), std::move(pixels)};
}

glm::vec2 in_units(const FT_Vector* p) {
  return {static_cast<float>(p->x), static_cast<float>(p->y)};
}

constexpr FT_Outline_Funcs kIntoPath{
    [](const FT_Vector* to, void* user) {
      static_cast<Path*>(user)->move_to(in_units(to));
      return 0;
    },
    [](const FT_Vector* to, void* user) {
      static_cast<Path*>(user)->line_to(in_units(to));
      return 0;
    },
    [](const FT_Vector* control, const FT_Vector* to, void* user) {
      static_cast<Path*>(user)->quadratic_to(in_units(control), in_units(to));
      return 0;
    },
    [](const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* user) {
      static_cast<Path*>(user)->cubic_to(in_units(a), in_units(b), in_units(to));
      return 0;
    },
    0,
    0};

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

struct Font::State {
  explicit State(std::span<const std::uint8_t> bytes) {
    FT_Error error = FT_Init_FreeType(&library);
    if (!error) {
      error =
          FT_New_Memory_Face(library, bytes.data(), static_cast<FT_Long>(bytes.size()), 0, &face);
    }
    if (!error && !FT_IS_SCALABLE(face)) error = FT_Err_Unknown_File_Format;
    if (!error) {
      kerned = FT_HAS_KERNING(face);
      return;
    }
    FT_Done_FreeType(library);
    throw_bad_input("not a scalable font (FreeType error " + std::to_string(error) + ")", "font");
  }
  ~State() { FT_Done_FreeType(library); }  // and the face with it
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void set_size(float size_px) {
    assert(size_px > 0 && size_px <= kLargestPx);
    size = std::max<FT_F26Dot6>(1, std::lround(size_px * 64));
  }
  /// FreeType hears of a size only when it is asked for something: text changes sizes often.
  void apply_size() {
    if (applied_size == size) return;
    applied_size = size;
    FT_Set_Char_Size(face, 0, size, 72, 72);
  }

  /// Light hinting moves outlines up and down only: stems keep their distances, while the baseline
  /// and the tops of letters lie on pixel rows.
  bool load(FT_UInt index) {
    apply_size();
    return FT_Load_Glyph(face, index, FT_LOAD_TARGET_LIGHT | FT_LOAD_NO_BITMAP) == 0;
  }

  /// A glyph, or a character, at the size as it is set; indices of glyphs have 16 bits.
  std::uint64_t key(std::uint32_t index_or_code) const {
    return std::uint64_t{index_or_code} << 32 | static_cast<std::uint64_t>(size) << 8;
  }

  struct Letter {
    FT_UInt index = 0;
    float advance_px = 0;
    std::array<const GlyphCoverage*, kPhases> at_phase{};  ///< those that were drawn
  };
  Letter& letter(char32_t code) {
    return letters.get(key(code), [&] {
      const FT_UInt index = FT_Get_Char_Index(face, code);
      const float advance = load(index) ? float(face->glyph->linearHoriAdvance) / 65536 : 0;
      return Letter{index, advance};
    });
  }

  float kerning_px(FT_UInt before, FT_UInt index) {
    if (!before || !kerned) return 0;
    return kernings.get(key(before) << 16 | index, [&] {
      apply_size();
      return static_cast<float>(kerning(before, index, FT_KERNING_UNFITTED)) / 64;
    });
  }

  const GlyphCoverage& glyph(Letter& letter, int phase) {
    const GlyphCoverage*& known = letter.at_phase[static_cast<std::size_t>(phase)];
    if (known) return *known;
    const auto [at, is_new] =
        glyphs.try_emplace(key(letter.index) | static_cast<std::uint64_t>(phase));
    FT_Outline& outline = face->glyph->outline;
    if (is_new && load(letter.index) && face->glyph->format == FT_GLYPH_FORMAT_OUTLINE &&
        outline.n_points > 0) {
      FT_Outline_Translate(&outline, phase * 64 / kPhases, 0);
      at->second = scan_convert(outline);
    }
    known = &at->second;
    return *known;
  }

  FT_Pos kerning(FT_UInt before, FT_UInt index, FT_Kerning_Mode mode) const {
    FT_Vector shift{0, 0};
    if (before && kerned) FT_Get_Kerning(face, before, index, mode, &shift);
    return shift.x;
  }

  /// Calls sink(letter, pen) for each character; returns the pen after the last.
  template <typename Sink>
  float lay_out(float x_px, std::string_view text, float size_px, Sink&& sink) {
    set_size(size_px);
    float pen = x_px;
    FT_UInt before = 0;
    for_each_code_point(text, [&](char32_t code) {
      Letter& next = letter(code);
      pen += kerning_px(before, next.index);
      sink(next, pen);
      pen += next.advance_px;
      before = next.index;
    });
    return pen;
  }

  FT_Library library = nullptr;
  FT_Face face = nullptr;
  FT_F26Dot6 size = 0, applied_size = 0;
  bool kerned = false;
  std::unordered_map<std::uint64_t, GlyphCoverage> glyphs;
  // What the last characters needed, so that text allocates and searches nothing.
  DirectCache<Letter, 256> letters;
  DirectCache<float, 4096> kernings;
  GlyphPainter painter;
};

Font::Font(std::span<const std::uint8_t> bytes) : state_(std::make_unique<State>(bytes)) {}
Font::~Font() = default;
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;

Font Font::sans() { return Font(bytes_of(embedded::dejavu_sans())); }
Font Font::mono() { return Font(bytes_of(embedded::dejavu_sans_mono())); }

float Font::width_px(std::string_view text, float size_px) const {
  return state_->lay_out(0, text, size_px, [](State::Letter&, float) {});
}

float Font::ascent_px(float size_px) const {
  return size_px * static_cast<float>(state_->face->ascender) /
         static_cast<float>(state_->face->units_per_EM);
}

float Font::line_height_px(float size_px) const {
  return size_px * static_cast<float>(state_->face->height) /
         static_cast<float>(state_->face->units_per_EM);
}

Path Font::outline(char32_t code) const {
  Path path;
  const FT_Face face = state_->face;
  if (FT_Load_Char(face, code, FT_LOAD_NO_SCALE)) return path;
  if (face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) return path;
  FT_Outline_Decompose(&face->glyph->outline, &kIntoPath, &path);
  return path;
}

Path Font::line_outline(std::string_view text) const {
  Path line;
  float pen = 0;
  FT_UInt before = 0;
  const FT_Face face = state_->face;
  for_each_code_point(text, [&](char32_t code) {
    const FT_UInt index = FT_Get_Char_Index(face, code);
    pen += static_cast<float>(state_->kerning(before, index, FT_KERNING_UNSCALED));
    before = index;
    const Path glyph = outline(code);
    line.verbs.insert(line.verbs.end(), glyph.verbs.begin(), glyph.verbs.end());
    for (const glm::vec2 p : glyph.points) line.points.push_back(p + glm::vec2(pen, 0));
    pen += static_cast<float>(face->glyph->advance.x);  // of what has just been read
  });
  return line;
}

float Font::units_per_em() const { return static_cast<float>(state_->face->units_per_EM); }

float Font::draw(Image<Srgb8>& picture, float x_px, float y_px, std::string_view text,
                 float size_px, Srgb8 colour) const {
  const int baseline = static_cast<int>(std::lround(y_px));
  // A character is drawn when the next one's pixels have been asked for.
  const GlyphCoverage* waiting = nullptr;
  int waiting_pen = 0;
  const auto draw_waiting = [&] {
    if (waiting) state_->painter.draw(picture, *waiting, waiting_pen, baseline, colour);
  };
  const float end = state_->lay_out(x_px, text, size_px, [&](State::Letter& letter, float pen) {
    const float quarters = std::floor(pen * kPhases + 0.5f);
    const int whole = static_cast<int>(std::floor(quarters / kPhases));
    const int phase = static_cast<int>(quarters) - whole * kPhases;
    const GlyphCoverage& glyph = state_->glyph(letter, phase);
    GlyphPainter::ask_ahead(picture, glyph, whole, baseline);
    draw_waiting();
    waiting = &glyph, waiting_pen = whole;
  });
  draw_waiting();
  return end;
}

}  // namespace kinescope
