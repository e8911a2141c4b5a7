// Lessons of the engine's algorithms, used as a user would, beside the algorithms themselves.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "engine/clip/liang_barsky.h"
#include "engine/fractals/escape_time.h"
#include "lesson_user.h"

namespace kinescope {
namespace {

TEST(EngineLessons, ADraggedLineIsClippedAsTheLibraryClipsIt) {
  LessonUser user("line-clipping");
  const World world = user.lesson().world();
  const auto corner = [&](double x, double y) {
    return glm::round(glm::dvec2(x, y) * user.size()) + 0.5;
  };
  const glm::dvec2 from(30.5, 40.5);
  user.pass({user.mouse(InputKind::kMouseDown, corner(0.05, 0.15))});
  user.pass({user.mouse(InputKind::kMouseMove, from)});
  user.pass({user.mouse(InputKind::kMouseUp, from)});
  // Pixels by their names, as they would be typed.
  const auto named = [&](glm::dvec2 middle) { return world.named(middle - 0.5); };
  const glm::dvec2 a = named(corner(0.25, 0.75)), b = named(corner(0.75, 0.25));
  const auto left =
      clip_liang_barsky({glm::min(a, b), glm::max(a, b)}, {named(from), named(corner(0.95, 0.7))});
  ASSERT_TRUE(left);
  EXPECT_EQ(user.lesson().course().remarks.at(0),
            fmt::format("inside: ({:.2f}, {:.2f}) to ({:.2f}, {:.2f})", left->from.x, left->from.y,
                        left->to.x, left->to.y));
}

TEST(EngineLessons, AnLSystemWithoutEndIsRefusedInThePanel) {
  LessonUser user("l-systems");
  EXPECT_EQ(user.lesson().fault(), "");
  for (int i = 0; i < 9; ++i) user.pass({key_down("2")});
  EXPECT_NE(user.lesson().fault().find("more than 20000 symbols"), std::string::npos);
}

TEST(EngineLessons, AClickHalvesTheMandelbrotSetsView) {
  LessonUser user("mandelbrot");
  const glm::dvec2 middle(std::floor(user.size().x / 2) + 0.5, std::floor(user.size().y / 2) + 0.5);
  user.pass({user.mouse(InputKind::kMouseDown, middle)});
  EscapeView view;
  view.width = static_cast<int>(user.size().x);
  view.height = static_cast<int>(user.size().y);
  view.step = 1.7 / view.width;
  view.most = 200;
  // What the first cells of a pass say of a row, the last pass says too.
  for (int pass = 0; pass < 5; ++pass) user.pass({key_down("End")});
  const Track& track = user.lesson().course().tracks.at(0);
  std::set<double> cells;
  int rows = 0;
  for (std::size_t i = 0; i < track.steps(); ++i) {
    const auto cell = static_cast<int>(track.values(i)[0]),
               j = static_cast<int>(track.values(i)[1]);
    int inside = 0;
    for (int x = view.width / 2 % cell; x < view.width; x += cell) {
      inside += escape_time(view, x, j) >= view.most;
    }
    EXPECT_EQ(track.values(i)[2], inside) << j << " by cells of " << cell;
    cells.insert(cell);
    rows += cell == 1;
  }
  EXPECT_EQ(cells, (std::set<double>{1, 2, 4, 8, 16}));
  EXPECT_EQ(rows, view.height);
}

TEST(EngineLessons, AJuliaSetIsShownWhole) {
  LessonUser user("mandelbrot");
  EXPECT_EQ(user.lesson().course().remarks.at(0), "centre -0.75");
  user.pass({key_down("2")});
  EXPECT_EQ(user.lesson().course().remarks.at(0), "centre 0");
}

TEST(EngineLessons, TheSetIsRecordedFinerOnlyAsItIsShown) {
  LessonUser user("mandelbrot");
  const std::size_t first = user.lesson().course().tracks.at(0).steps();
  user.pass({key_down("Home"), key_down("n")});  // by hand
  EXPECT_EQ(user.lesson().course().tracks.at(0).steps(), first);
  for (std::size_t i = 1; i < first; ++i) user.pass({key_down("n")});
  EXPECT_EQ(user.lesson().shown(), first);
  EXPECT_GT(user.lesson().course().tracks.at(0).steps(), first);
}

}  // namespace
}  // namespace kinescope
