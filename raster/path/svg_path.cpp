#include "raster/path/svg_path.h"

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

namespace kinescope {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/// Reads numbers as the standard writes them: "1-2.5.5" is three of them.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::size_t place() const { return at_; }
  bool at_end() {
    skip_space();
    return at_ == text_.size();
  }
  char peek() {
    skip_space();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  char take() { return text_[at_++]; }

  /// A number is next, perhaps after a comma.
  bool has_number() {
    const std::size_t before = at_;
    skip_comma();
    const char c = peek();
    const bool found = c == '+' || c == '-' || c == '.' || (c >= '0' && c <= '9');
    at_ = before;
    return found;
  }

  std::optional<float> number() {
    skip_comma();
    std::size_t begin = at_;
    if (begin < text_.size() && text_[begin] == '+') {
      ++begin;
      if (begin < text_.size() && text_[begin] == '-') return std::nullopt;
    }
    float value = 0;
    const char* const end = text_.data() + text_.size();
    const auto result = std::from_chars(text_.data() + begin, end, value);
    if (result.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    return value;
  }

  /// 0 or 1; the next number may follow without a space.
  std::optional<bool> flag() {
    skip_comma();
    if (at_ == text_.size() || (text_[at_] != '0' && text_[at_] != '1')) return std::nullopt;
    return text_[at_++] == '1';
  }

 private:
  void skip_space() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }
  void skip_comma() {
    skip_space();
    if (at_ < text_.size() && text_[at_] == ',') ++at_;
    skip_space();
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

struct Arc {
  glm::dvec2 from, to, radii;
  double turn = 0;  ///< of the ellipse's first axis, radians
  bool large = false, sweep = false;
};

/// A quarter of the ellipse or less as one cubic, each time. Source: SVG 1.1, F.6.5 and F.6.6.
void add_arc(Arc arc, Path& path) {
  glm::dvec2 r = glm::abs(arc.radii);
  if (arc.from == arc.to) return;
  if (r.x == 0 || r.y == 0) return path.line_to(arc.to);
  const double c = std::cos(arc.turn), s = std::sin(arc.turn);
  const glm::dvec2 middle = 0.5 * (arc.from - arc.to);
  const glm::dvec2 p{c * middle.x + s * middle.y, c * middle.y - s * middle.x};
  const double size = (p.x / r.x) * (p.x / r.x) + (p.y / r.y) * (p.y / r.y);
  if (size > 1) r *= std::sqrt(size);  // too small to reach: as large as needed
  const double side = std::sqrt(std::max(0.0, 1 / std::min(size, 1.0) - 1));
  const double sign = arc.large == arc.sweep ? -1 : 1;
  // The centre, and both ends as seen from it, where the ellipse is the unit circle.
  const glm::dvec2 centre = sign * side * glm::dvec2(p.y / r.y, -p.x / r.x);
  const glm::dvec2 begin = p / r - centre, end = -p / r - centre;
  double angle = std::atan2(begin.x * end.y - begin.y * end.x, glm::dot(begin, end));
  if (arc.sweep && angle < 0) angle += 2 * std::numbers::pi;
  if (!arc.sweep && angle > 0) angle -= 2 * std::numbers::pi;
  const glm::dvec2 moved = 0.5 * (arc.from + arc.to);
  const auto place = [&](glm::dvec2 unit) {
    const glm::dvec2 q = (unit + centre) * r;
    return glm::vec2(moved + glm::dvec2(c * q.x - s * q.y, s * q.x + c * q.y));
  };
  const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / 1.5708)));
  const double step = angle / parts, handle = 4.0 / 3 * std::tan(step / 4);
  const double start = std::atan2(begin.y, begin.x);
  for (int i = 0; i < parts; ++i) {
    const double t0 = start + step * i, t1 = t0 + step;
    const glm::dvec2 a{std::cos(t0), std::sin(t0)}, b{std::cos(t1), std::sin(t1)};
    const glm::dvec2 after = a + handle * glm::dvec2(-a.y, a.x);
    const glm::dvec2 before = b - handle * glm::dvec2(-b.y, b.x);
    path.cubic_to(place(after), place(before), i + 1 == parts ? glm::vec2(arc.to) : place(b));
  }
}

class Parser {
 public:
  explicit Parser(std::string_view text) : in_(text) {}

  /// @return where the fault is
  std::size_t parse(Path& path) {
    while (!in_.at_end()) {
      const std::size_t before = in_.place();
      const char command = in_.take();
      if (path.verbs.empty() && command != 'M' && command != 'm') return before;
      if (command == 'Z' || command == 'z') {
        close(path);
        continue;
      }
      char again = command;
      do {
        if (!segment(again, path)) return in_.place();
        // Points after a move's first are lines.
        if (again == 'M') again = 'L';
        if (again == 'm') again = 'l';
      } while (in_.has_number());
    }
    return std::string_view::npos;
  }

 private:
  void close(Path& path) {
    path.close();
    pen_ = start_;
    last_ = 'z';
    closed_ = true;
  }

  std::optional<glm::vec2> point(bool relative) {
    const auto x = in_.number();
    const auto y = x ? in_.number() : std::nullopt;
    if (!y) return std::nullopt;
    return glm::vec2(*x, *y) + (relative ? pen_ : glm::vec2(0));
  }

  /// Where the last curve's handle continues on the other side, if it was of this kind.
  glm::vec2 mirrored(char kind) const { return last_ == kind ? 2.0f * pen_ - handle_ : pen_; }

  bool segment(char command, Path& path) {
    const bool relative = command >= 'a';
    const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
    if (kind == 'M') return move(relative, path);
    if (closed_) path.move_to(start_);
    closed_ = false;
    switch (kind) {
      case 'L':
      case 'H':
      case 'V':
        return line(kind, relative, path);
      case 'C':
      case 'S':
        return cubic(kind, relative, path);
      case 'Q':
      case 'T':
        return quadratic(kind, relative, path);
      case 'A':
        return arc(relative, path);
      default:
        return false;
    }
  }

  bool move(bool relative, Path& path) {
    const auto to = point(relative);
    if (!to) return false;
    path.move_to(*to);
    start_ = *to;
    closed_ = false;
    return arrive(*to, 'M');
  }

  bool line(char kind, bool relative, Path& path) {
    std::optional<glm::vec2> to;
    if (kind == 'L') {
      to = point(relative);
    } else if (const auto value = in_.number()) {
      to = pen_;
      float& moved = kind == 'H' ? to->x : to->y;
      moved = *value + (relative ? moved : 0);
    }
    if (!to) return false;
    path.line_to(*to);
    return arrive(*to, kind);
  }

  bool cubic(char kind, bool relative, Path& path) {
    const auto a = kind == 'C' ? point(relative) : mirrored('C');
    const auto b = a ? point(relative) : std::nullopt;
    const auto to = b ? point(relative) : std::nullopt;
    if (!to) return false;
    path.cubic_to(*a, *b, *to);
    handle_ = *b;
    return arrive(*to, 'C');
  }

  bool quadratic(char kind, bool relative, Path& path) {
    const auto control = kind == 'Q' ? point(relative) : mirrored('Q');
    const auto to = control ? point(relative) : std::nullopt;
    if (!to) return false;
    path.quadratic_to(*control, *to);
    handle_ = *control;
    return arrive(*to, 'Q');
  }

  bool arc(bool relative, Path& path) {
    const auto rx = in_.number();
    const auto ry = rx ? in_.number() : std::nullopt;
    const auto degrees = ry ? in_.number() : std::nullopt;
    const auto large = degrees ? in_.flag() : std::nullopt;
    const auto sweep = large ? in_.flag() : std::nullopt;
    const auto to = sweep ? point(relative) : std::nullopt;
    if (!to) return false;
    add_arc({pen_, *to, {*rx, *ry}, *degrees * std::numbers::pi / 180, *large, *sweep}, path);
    return arrive(*to, 'A');
  }

  bool arrive(glm::vec2 to, char kind) {
    pen_ = to;
    last_ = kind;
    return true;
  }

  Scanner in_;
  glm::vec2 pen_{0}, start_{0}, handle_{0};
  char last_ = 'M';
  bool closed_ = false;
};

}  // namespace

Path parse_svg_path(std::string_view text, std::size_t* fault) {
  Path path;
  const std::size_t place = Parser(text).parse(path);
  if (fault) *fault = place;
  return path;
}

}  // namespace kinescope
