#include "bench/peer_cairo.h"

#include <cairo.h>

#include <vector>

namespace kinescope::bench {
namespace {

struct Shape {
  cairo_path_t* path;
  LinearRgba colour;
  cairo_fill_rule_t rule;
};

/// Builds the path in pixels.
void trace(cairo_t* cairo, const FilledPath& filled) {
  const auto at = [&](glm::vec2 p) { return filled.place * glm::vec3(p, 1); };
  const glm::vec2* p = filled.path->points.data();
  for (const Path::Verb verb : filled.path->verbs) {
    switch (verb) {
      case Path::Verb::kMove: {
        const glm::vec2 to = at(*p++);
        cairo_move_to(cairo, to.x, to.y);
        break;
      }
      case Path::Verb::kLine: {
        const glm::vec2 to = at(*p++);
        cairo_line_to(cairo, to.x, to.y);
        break;
      }
      case Path::Verb::kQuadratic: {
        double x, y;
        cairo_get_current_point(cairo, &x, &y);
        const glm::vec2 control = at(p[0]), to = at(p[1]);
        p += 2;
        cairo_curve_to(cairo, (x + 2 * control.x) / 3, (y + 2 * control.y) / 3,
                       (to.x + 2 * control.x) / 3, (to.y + 2 * control.y) / 3, to.x, to.y);
        break;
      }
      case Path::Verb::kCubic: {
        const glm::vec2 a = at(p[0]), b = at(p[1]), to = at(p[2]);
        p += 3;
        cairo_curve_to(cairo, a.x, a.y, b.x, b.y, to.x, to.y);
        break;
      }
      case Path::Verb::kClose:
        cairo_close_path(cairo);
        break;
    }
  }
}

Image<Linear8> pixels_of(cairo_surface_t* surface) {
  const int stride = cairo_image_surface_get_stride(surface);
  const unsigned char* const data = cairo_image_surface_get_data(surface);
  Image<Linear8> picture(cairo_image_surface_get_width(surface),
                         cairo_image_surface_get_height(surface));
  for (int y = 0; y < picture.height(); ++y) {
    const unsigned char* p = data + y * stride;
    for (int x = 0; x < picture.width(); ++x, p += 4) picture.at(x, y) = {p[2], p[1], p[0], p[3]};
  }
  return picture;
}

void paint_white(cairo_t* cairo) {
  cairo_set_source_rgb(cairo, 1, 1, 1);
  cairo_paint(cairo);
}

/// A picture that Cairo draws on.
struct CairoPage {
  CairoPage(int width, int height)
      : surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height)),
        cairo(cairo_create(surface)) {}
  ~CairoPage() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }
  CairoPage(const CairoPage&) = delete;
  CairoPage& operator=(const CairoPage&) = delete;

  cairo_surface_t* surface;
  cairo_t* cairo;
};

}  // namespace

struct CairoFills::State : CairoPage {
  using CairoPage::CairoPage;
  ~State() {
    for (const Shape& shape : shapes) cairo_path_destroy(shape.path);
  }
  std::vector<Shape> shapes;
};

CairoFills::CairoFills(std::span<const FilledPath> paths, float tolerance_px, CairoQuality quality,
                       int width, int height)
    : state_(std::make_unique<State>(width, height)) {
  cairo_t* const cairo = state_->cairo;
  cairo_set_tolerance(cairo, static_cast<double>(tolerance_px));
  cairo_set_antialias(
      cairo, quality == CairoQuality::kBest ? CAIRO_ANTIALIAS_BEST : CAIRO_ANTIALIAS_DEFAULT);
  for (const FilledPath& filled : paths) {
    cairo_new_path(cairo);
    trace(cairo, filled);
    state_->shapes.push_back(
        {cairo_copy_path(cairo), filled.ink.colour,
         filled.rule == FillRule::kEvenOdd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING});
  }
}
CairoFills::~CairoFills() = default;

void CairoFills::draw() {
  cairo_t* const cairo = state_->cairo;
  for (const Shape& shape : state_->shapes) {
    const LinearRgba c = shape.colour;
    cairo_new_path(cairo);
    cairo_append_path(cairo, shape.path);
    cairo_set_source_rgba(cairo, static_cast<double>(c.r), static_cast<double>(c.g),
                          static_cast<double>(c.b), static_cast<double>(c.a));
    cairo_set_fill_rule(cairo, shape.rule);
    cairo_fill(cairo);
  }
  cairo_surface_flush(state_->surface);
}

void CairoFills::clear() { paint_white(state_->cairo); }

Image<Linear8> CairoFills::picture() const { return pixels_of(state_->surface); }

std::string CairoFills::version() { return cairo_version_string(); }

struct CairoText::State : CairoPage {
  using CairoPage::CairoPage;
};

CairoText::CairoText(float size_px, int width, int height)
    : state_(std::make_unique<State>(width, height)) {
  cairo_t* const cairo = state_->cairo;
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, static_cast<double>(size_px));
  cairo_font_options_t* const plain = cairo_font_options_create();
  cairo_font_options_set_hint_style(plain, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(plain, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(plain, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo, plain);
  cairo_font_options_destroy(plain);
}

CairoText::~CairoText() = default;

double CairoText::width_px(const std::string& line) const {
  cairo_text_extents_t extents;
  cairo_text_extents(state_->cairo, line.c_str(), &extents);
  return extents.x_advance;
}

void CairoText::draw(glm::vec2 pen, const std::string& line) {
  cairo_set_source_rgb(state_->cairo, 0, 0, 0);
  cairo_move_to(state_->cairo, static_cast<double>(pen.x), static_cast<double>(pen.y));
  cairo_show_text(state_->cairo, line.c_str());
}

void CairoText::clear() { paint_white(state_->cairo); }

Image<Linear8> CairoText::picture() const {
  cairo_surface_flush(state_->surface);
  return pixels_of(state_->surface);
}

}  // namespace kinescope::bench
