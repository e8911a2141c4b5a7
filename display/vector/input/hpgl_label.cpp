// Where a plotter sets its characters. Cells: a character's space is 1.5 widths, a line 2 heights.
// Source: 7550A manual, chapter 7; label origins measured on hp2xx.
#include <cmath>
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
  const double length = n > 0 ? n * cell.space - (cell.space - cell.width) : 0;
  double x = -0.5 * length * column, y = -2.0 / 3 * cell.height * row;
  if (origin > 10) {
    x += 0.5 * cell.width * (1 - column);
    y += 2.0 / 3 * cell.height * (1 - row);
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

class Label {
 public:
  explicit Label(HpglPlotter& plotter) : plotter_(plotter), cell_(plotter) {}

  void write(const std::string& text) {
    start_line(text, 0);
    for (std::size_t i = 0; i < text.size(); ++i) {
      switch (text[i]) {
        case '\r':
          flush();
          plotter_.pen = plotter_.line_start;
          start_line(text, i + 1);
          break;
        case '\n':
          line_feed();
          start_line(text, i + 1);
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
  }

  /// One down the page, or to the next column of vertical text.
  void line_feed() {
    flush();
    const glm::dvec2 step =
        plotter_.vertical ? -2 * cell_.space * cell_.right : -cell_.line * cell_.up;
    plotter_.pen += step;
    plotter_.line_start += step;
  }
  glm::dvec2 advance() const {
    return plotter_.vertical ? -cell_.line * cell_.up : cell_.space * cell_.right;
  }
  const Cell& cell() const { return cell_; }

 private:
  void start_line(const std::string& text, std::size_t from) {
    shift_ = origin_shift(plotter_, cell_, characters_of_line(text, from));
  }
  void add(char c) {
    if (run_.empty()) run_start_ = plotter_.pen;
    run_ += c;
    plotter_.pen += advance();
    if (plotter_.vertical) flush();
  }
  void flush() {
    if (run_.empty()) return;
    DrawnText text;
    text.text = std::exchange(run_, {});
    const auto turned = [&](glm::dvec2 v) { return glm::vec2(plotter_.turned(v)); };
    text.place = turned(run_start_ + shift_);
    text.advance = turned(cell_.space * cell_.right);
    text.up = turned(cell_.height * (cell_.up + plotter_.slant * cell_.right));
    text.segments = plotter_.out->segments.size();
    if (plotter_.pen_number == 0 || plotter_.in_polygon) return;
    plotter_.out->texts.push_back(std::move(text));
  }

  HpglPlotter& plotter_;
  Cell cell_;
  glm::dvec2 shift_{0}, run_start_{0};
  std::string run_;
};

}  // namespace

void hpgl_label(HpglPlotter& plotter, const std::string& text) {
  plotter.dot_due = false;
  Label(plotter).write(text);
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
