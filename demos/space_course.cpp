#include "demos/space_course.h"

#include <fmt/format.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "engine/transform/in_between.h"

namespace kinescope {
namespace {

Track track_of(const SpaceCourse& space, int pane, const std::string& name) {
  Track track(name,
              space.flat ? std::vector<std::string>{"matrix", "x", "y"}
                         : std::vector<std::string>{"matrix", "x", "y", "z"},
              pane);
  const auto step = [&](std::size_t shown, std::string note) {
    const glm::dvec3 p = apply(matrix_at(space, shown), space.figure.points[space.traced]);
    const double number = double(shown) / space.smooth;
    track.step(space.flat ? std::vector{number, p.x, p.y} : std::vector{number, p.x, p.y, p.z},
               std::move(note));
  };
  const auto lines = space.flat ? plane_matrix_lines : matrix_lines;
  glm::dmat4 product(1.0);
  std::size_t shown = 0;
  std::string last;
  for (std::size_t k = 0; k < space.steps.size(); ++k) {
    product = space.steps[k].matrix * product;
    last = fmt::format("{}/{}: {}\n", k + 1, space.steps.size(), space.steps[k].name) +
           (space.brief ? "" : lines(space.steps[k].matrix)) + "product so far\n" + lines(product);
    for (int i = 0; i < space.smooth; ++i) {
      const bool end = k + 1 == space.steps.size() && i + 1 == space.smooth;
      if (end) ink_wire(track, space.view, space.figure, product, theme::kText);
      step(++shown, last);
    }
  }
  if (shown > 0) step(shown, last);
  return track;
}

}  // namespace

glm::dmat4 matrix_at(const SpaceCourse& course, std::size_t shown) {
  const auto smooth = static_cast<std::size_t>(course.smooth);
  glm::dmat4 product(1.0);
  for (std::size_t k = 0; k < course.steps.size() && k * smooth < shown; ++k) {
    const std::size_t done = std::min(shown - k * smooth, smooth);
    const double share = static_cast<double>(done) / static_cast<double>(smooth);
    product = in_between(course.steps[k].matrix, share) * product;
  }
  return product;
}

void show(SpaceCourse space, Course& course, int pane, std::string name) {
  course.tracks.push_back(track_of(space, pane, name));
  const auto shared = std::make_shared<const SpaceCourse>(std::move(space));
  course.painter = [shared, pane, before = std::move(course.painter)](std::size_t shown, int which,
                                                                      Image<Srgb8>& paper) {
    if (before) before(shown, which, paper);
    if (which != pane) return;
    PaperInk ink{paper};
    ink_wire(ink, shared->view, shared->figure, glm::dmat4(1.0), theme::kKeyCap);
    ink_wire(ink, shared->view, shared->figure, matrix_at(*shared, shown), theme::kAccent);
  };
  course.overlay = [shared, pane, before = std::move(course.overlay)](std::size_t shown) {
    Overlay over = before ? before(shown) : Overlay{};
    shared->view.add_axes(over, 2.5, pane, shared->flat ? 2 : 3);
    const glm::dmat4 matrix = matrix_at(*shared, shown);
    for (const auto& [a, b] : shared->carried.edges) {
      shared->view.add_line(over, apply(matrix, shared->carried.points[a]),
                            apply(matrix, shared->carried.points[b]), theme::kCool, pane);
    }
    return over;
  };
}

std::vector<TransformStep3> without_identities(std::vector<TransformStep3> steps) {
  std::erase_if(steps, [](const TransformStep3& s) { return s.matrix == glm::dmat4(1.0); });
  return steps;
}

std::vector<std::string> class_remarks(const glm::dmat4& product) {
  const glm::dmat3 linear(product);
  const double volume = glm::determinant(linear);
  const glm::dmat3 square = glm::transpose(linear) * linear;
  double off = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) off = std::max(off, std::abs(square[i][j] - (i == j)));
  }
  return {fmt::format("determinant {:.3g}: {}", volume,
                      std::abs(volume) < 1e-12 ? "flattened, nothing brings it back"
                      : volume < 0             ? "turned over, as in a mirror"
                                               : "not turned over"),
          off < 1e-9 ? "lengths and angles are kept" : "lengths or angles change"};
}

}  // namespace kinescope
