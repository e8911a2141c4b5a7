#include "engine/clip/orientation.h"

#include <array>
#include <cmath>

namespace kinescope {
namespace {

/// A sum of doubles kept exactly, as terms that do not overlap, least first.
struct Expansion {
  std::array<double, 12> term{};
  std::size_t size = 0;

  void add(double value) {
    for (std::size_t i = 0; i < size; ++i) {
      const double sum = value + term[i];
      const double part = sum - value;
      term[i] = (value - (sum - part)) + (term[i] - part);
      value = sum;
    }
    term[size++] = value;
  }
  void add_product(double x, double y) {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }
  int sign() const {
    for (std::size_t i = size; i-- > 0;) {
      if (term[i] != 0.0) return term[i] > 0.0 ? 1 : -1;
    }
    return 0;
  }
};

}  // namespace

int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double area = left - right;
  // Shewchuk's bound for what the roundings above may have changed.
  const double bound = 3.3306690738754716e-16 * (std::abs(left) + std::abs(right));
  if (area > bound) return 1;
  if (area < -bound) return -1;
  Expansion exact;
  exact.add_product(a.x, b.y);
  exact.add_product(-a.x, c.y);
  exact.add_product(-c.x, b.y);
  exact.add_product(-a.y, b.x);
  exact.add_product(a.y, c.x);
  exact.add_product(c.y, b.x);
  return exact.sign();
}

}  // namespace kinescope
