// Where a plotter sets its characters. Cells: a character's space is 1.5 widths, a line 2 heights.
// Source: 7550A manual, chapter 7; label origins measured on hp2xx.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "display/vector/input/hpgl_plotter.h"

namespace kinescope {
namespace {

/// Width and height of a character and the ways that text runs, plotter units.
struct Cell {
  glm::dvec2 right, up;  ///< unit vectors
  double width, height;
  double space, line;  ///< to the next character and line

  explicit Cell(const HpglPlotter& plotter) {
    const glm::dvec2 page = plotter.p2 - plotter.p1;
    const glm::dvec2 size = plotter.relative_size ? plotter.size * glm::abs(page) : plotter.size;
    width = size.x;
    height = size.y;
    right = plotter.direction * (plotter.relative_direction ? page : glm::dvec2(1));
    const double length = glm::length(right);
    right = length > 0 ? right / length : glm::dvec2(1, 0);
    up = {-right.y, right.x};
    space = 1.5 * width * (1 + plotter.extra_space.x);
    line = 2 * height * (1 + plotter.extra_space.y);
  }
};

/// How far a line of text lies from its anchor: origins 1 to 9 in columns left, middle, right and
/// rows bottom, middle, top; 11 to 19 the same, held off.
glm::dvec2 origin_shift(const HpglPlotter& plotter, const Cell& cell, std::size_t characters) {
  const int origin = plotter.label_origin;
  if (origin < 1 || origin > 19 || origin == 10) return glm::dvec2(0);
  const int place = (origin - 1) % 10, column = place / 3, row = place % 3;
  const double n = static_cast<double>(characters);
  const glm::dvec2 size = glm::dvec2(cell.width, cell.height) * (1.0 + plotter.extra_space);
  const double length = n > 0 ? (1.5 * n - 0.5) * size.x : 0;
  double x = -0.5 * length * column, y = -2.0 / 3 * size.y * row;
  if (origin > 10) {
    x += 0.5 * size.x * (1 - column);
    y += 2.0 / 3 * size.y * (1 - row);
  }
  return x * cell.right + y * cell.up;
}

/// Printable characters that begin at text[from] and share a line.
std::size_t characters_of_line(const std::string& text, std::size_t from) {
  std::size_t count = 0;
  for (std::size_t i = from; i < text.size() && text[i] != '\r' && text[i] != '\n'; ++i) {
    count += static_cast<unsigned char>(text[i]) >= 32;
  }
  return count;
}

/// Lines of a buffered label lie left-aligned about its anchor; it has at least one.
struct Block {
  std::size_t longest = 0, lines = 1;

  explicit Block(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      longest = std::max(longest, characters_of_line(text, i));
      lines += text[i] == '\n';
    }
  }
};

class Label {
 public:
  explicit Label(HpglPlotter& plotter) : plotter_(plotter), cell_(plotter) {}

  /// All lines begin below each other, and the last is where a single one would be.
  void write_block(const std::string& text) {
    const Block block(text);
    const int row = (plotter_.label_origin - 1) % 10 % 3;
    block_shift_ = origin_shift(plotter_, cell_, block.longest);
    const glm::dvec2 up =
        (1 - 0.5 * row) * static_cast<double>(block.lines - 1) * cell_.line * cell_.up;
    plotter_.pen += up;
    plotter_.line_start += up;
    is_block_ = true;
    write(text);
  }
  void write(const std::string& text) {
    start_line(text, 0);
    std::size_t last_line = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      switch (text[i]) {
        case '\r':
          flush();
          carriage_return();
          start_line(text, last_line = i + 1);
          break;
        case '\n':
          line_feed();
          start_line(text, last_line = i + 1);
          break;
        case '\b':
          flush();
          plotter_.pen -= advance();
          break;
        default:
          if (static_cast<unsigned char>(text[i]) >= 32) add(text[i]);
      }
    }
    flush();
    // The pen stays at the end of what it drew.
    const int column = (plotter_.label_origin - 1) % 10 / 3;
    const auto drawn = static_cast<double>(characters_of_line(text, last_line));
    if (plotter_.label_origin > 0 && !plotter_.vertical) {
      plotter_.pen -= 0.5 * column * drawn * cell_.space * cell_.right;
    }
  }

  /// Vertical text goes on in the next column.
  void carriage_return() {
    flush();
    if (plotter_.vertical) plotter_.line_start -= cell_.space * cell_.right;
    plotter_.pen = plotter_.line_start;
  }
  /// One down the page, or to the next column of vertical text.
  void line_feed() {
    flush();
    if (plotter_.vertical) {
      plotter_.pen -= cell_.space * cell_.right;
      return;
    }
    plotter_.pen -= cell_.line * cell_.up;
    plotter_.line_start -= cell_.line * cell_.up;
  }
  glm::dvec2 advance() const {
    return plotter_.vertical ? -cell_.line * cell_.up : cell_.space * cell_.right;
  }
  const Cell& cell() const { return cell_; }

 private:
  void start_line(const std::string& text, std::size_t from) {
    shift_ =
        is_block_ ? block_shift_ : origin_shift(plotter_, cell_, characters_of_line(text, from));
  }
  void add(char c) {
    if (hidden(plotter_.pen + shift_)) {
      flush();
      plotter_.pen += advance();
      return;
    }
    if (run_.empty()) run_start_ = plotter_.pen;
    run_ += c;
    plotter_.pen += advance();
    if (plotter_.vertical) flush();
  }
  /// Whether a character at this place leaves the window: it is not drawn then.
  bool hidden(glm::dvec2 at) const {
    if (!plotter_.clipped) return false;
    glm::dvec2 least = at, most = at;
    for (const glm::dvec2 corner : {at + cell_.width * cell_.right, at + cell_.height * cell_.up}) {
      least = glm::min(least, corner);
      most = glm::max(most, corner);
    }
    const glm::dvec2 a = plotter_.window_least, b = plotter_.window_most;
    return least.x < a.x || least.y < a.y || most.x > b.x || most.y > b.y;
  }
  void flush() {
    if (run_.empty()) return;
    DrawnText text;
    text.text = std::exchange(run_, {});
    const auto turned = [&](glm::dvec2 v) { return glm::vec2(plotter_.turned(v)); };
    text.place = turned(run_start_ + shift_);
    text.advance = turned(cell_.space * cell_.right);
    text.up = turned(cell_.height * (cell_.up + plotter_.slant * cell_.right));
    text.intensity = plotter_.pen_intensity();
    text.pen = plotter_.pen_in_hand();
    text.segments = plotter_.out->segments.size();
    if (plotter_.pen_number == 0 || plotter_.in_polygon) return;
    plotter_.out->texts.push_back(std::move(text));
  }

  HpglPlotter& plotter_;
  Cell cell_;
  glm::dvec2 shift_{0}, block_shift_{0}, run_start_{0};
  bool is_block_ = false;
  std::string run_;
};

}  // namespace

void hpgl_label(HpglPlotter& plotter, const std::string& text) {
  plotter.dot_due = false;
  Label(plotter).write(text);
}

void hpgl_print_buffer(HpglPlotter& plotter) {
  plotter.dot_due = false;
  Label(plotter).write_block(plotter.label_buffer);
}

/// The character's middle on the pen.
void hpgl_symbol(HpglPlotter& plotter) {
  if (plotter.symbol == 0) return;
  const glm::dvec2 pen = plotter.pen, line_start = plotter.line_start;
  const int origin = std::exchange(plotter.label_origin, 5);
  hpgl_label(plotter, std::string(1, plotter.symbol));
  plotter.label_origin = origin;
  plotter.pen = pen;
  plotter.line_start = line_start;
}

void hpgl_character_plot(HpglPlotter& plotter, double spaces, double lines) {
  const Label label(plotter);
  const Cell& cell = label.cell();
  plotter.pen += spaces * label.advance();
  const glm::dvec2 up = plotter.vertical ? cell.space * cell.right : cell.line * cell.up;
  plotter.pen += lines * up;
}

void hpgl_new_line(HpglPlotter& plotter) {
  plotter.pen = plotter.line_start;
  Label(plotter).line_feed();
}

}  // namespace kinescope
