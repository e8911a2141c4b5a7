// The only file behind which MPFR stands.
#include <mpfr.h>

#include <cmath>

#include "engine/fractals/deep_zoom.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// A number of arbitrary precision.
class Big {
 public:
  explicit Big(int bits) {
    mpfr_init2(value_, bits);
    mpfr_set_zero(value_, 1);
  }
  Big(const std::string& decimal, int bits) : Big(bits) {
    const bool read = mpfr_set_str(value_, decimal.c_str(), 10, MPFR_RNDN) == 0;
    if (!read || mpfr_number_p(value_) == 0 || mpfr_cmpabs_ui(value_, 1000) > 0) {
      throw_bad_input("\"" + decimal.substr(0, 40) + "\" is no place near the Mandelbrot set");
    }
  }
  ~Big() { mpfr_clear(value_); }
  Big(const Big&) = delete;
  Big& operator=(const Big&) = delete;

  mpfr_ptr get() { return value_; }
  double rounded() const { return mpfr_get_d(value_, MPFR_RNDN); }
  void add(double by) { mpfr_add_d(value_, value_, by, MPFR_RNDN); }
  std::string decimal(int digits) const {
    char* text = nullptr;
    mpfr_asprintf(&text, "%.*Re", digits, value_);
    std::string copy(text);
    mpfr_free_str(text);
    return copy;
  }

 private:
  mpfr_t value_;
};

/// z -> z^2 + c, in place.
class Orbit {
 public:
  Orbit(Big& cx, Big& cy, int bits) : cx_(cx), cy_(cy), x_(bits), y_(bits), xx_(bits), yy_(bits) {}

  void step() {
    mpfr_sqr(xx_.get(), x_.get(), MPFR_RNDN);
    mpfr_sqr(yy_.get(), y_.get(), MPFR_RNDN);
    mpfr_mul(y_.get(), x_.get(), y_.get(), MPFR_RNDN);
    mpfr_mul_2ui(y_.get(), y_.get(), 1, MPFR_RNDN);
    mpfr_add(y_.get(), y_.get(), cy_.get(), MPFR_RNDN);
    mpfr_sub(x_.get(), xx_.get(), yy_.get(), MPFR_RNDN);
    mpfr_add(x_.get(), x_.get(), cx_.get(), MPFR_RNDN);
  }
  glm::dvec2 z() const { return {x_.rounded(), y_.rounded()}; }
  /// |z|^2 - 4, rounded only at the end.
  double excess() {
    mpfr_sqr(xx_.get(), x_.get(), MPFR_RNDN);
    mpfr_sqr(yy_.get(), y_.get(), MPFR_RNDN);
    mpfr_add(xx_.get(), xx_.get(), yy_.get(), MPFR_RNDN);
    mpfr_sub_ui(xx_.get(), xx_.get(), 4, MPFR_RNDN);
    return xx_.rounded();
  }
  /// |z| > 2, decided in full precision.
  bool escaped() {
    excess();
    return mpfr_sgn(xx_.get()) > 0;
  }

 private:
  Big &cx_, &cy_;
  Big x_, y_, xx_, yy_;
};

}  // namespace

std::vector<OrbitPoint> reference_orbit(const DeepView& view) {
  const int bits = deep_precision_bits(view);
  Big cx(view.centre_x, bits), cy(view.centre_y, bits);
  Orbit orbit(cx, cy, bits);
  std::vector<OrbitPoint> points = {{orbit.z(), orbit.excess()}};
  for (int n = 0; n < view.most && points.back().excess <= 12.0; ++n) {
    orbit.step();
    points.push_back({orbit.z(), orbit.excess()});
  }
  return points;
}

int exact_escape_time(const DeepView& view, const glm::dvec2& offset) {
  const int bits = 2 * deep_precision_bits(view);
  Big cx(view.centre_x, bits), cy(view.centre_y, bits);
  cx.add(offset.x);
  cy.add(offset.y);
  Orbit orbit(cx, cy, bits);
  for (int n = 0; n < view.most; ++n) {
    if (orbit.escaped()) return n;
    orbit.step();
  }
  return view.most;
}

DeepView moved(const DeepView& view, const glm::dvec2& offset) {
  const int bits = deep_precision_bits(view);
  Big cx(view.centre_x, bits), cy(view.centre_y, bits);
  cx.add(offset.x);
  cy.add(offset.y);
  const auto digits = static_cast<int>(std::ceil(bits * 0.30103));
  DeepView other = view;
  other.centre_x = cx.decimal(digits);
  other.centre_y = cy.decimal(digits);
  return other;
}

}  // namespace kinescope
