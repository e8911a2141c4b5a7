#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/fractals/brownian.h"
#include "engine/fractals/compression.h"
#include "engine/fractals/dimension.h"
#include "engine/fractals/dla.h"
#include "engine/fractals/escape_time.h"
#include "engine/fractals/gasket.h"
#include "engine/fractals/gasket_view.h"
#include "engine/fractals/ifs.h"
#include "engine/fractals/plasma.h"
#include "engine/fractals/random_koch.h"
#include "engine/fractals/turtle.h"
#include "raster/base/error.h"
#include "raster/base/simd.h"
#include "raster/base/workers.h"

namespace kinescope {
namespace {

using Vec = glm::dvec2;

std::ptrdiff_t letters(const std::string& name, int generations, const std::string& which) {
  const std::string s = l_system_string(l_system_preset(name), generations);
  return std::count_if(s.begin(), s.end(),
                       [&](char c) { return which.find(c) != std::string::npos; });
}

TEST(LSystem, WorkedExamples) {
  EXPECT_EQ(letters("quadratic-koch", 2, "F"), 25);
  EXPECT_EQ(letters("quadratic-koch", 3, "F"), 125);
  EXPECT_EQ(letters("sierpinski-arrowhead", 2, "FG"), 9);
  EXPECT_EQ(letters("sierpinski-arrowhead", 4, "FG"), 81);
  EXPECT_EQ(letters("sierpinski-arrowhead", 6, "FG"), 729);
  EXPECT_EQ(letters("sierpinski-arrowhead", 9, "FG"), 19683);
  EXPECT_EQ(letters("dragon", 10, "F"), 1024);
  EXPECT_EQ(letters("plant", 6, "F"), 6048);
  EXPECT_EQ(l_system_counts(l_system_preset("plant"), 6).at('F'), 6048u);
  EXPECT_NEAR(similarity_dimension(5, 1.0 / 3), 1.465, 5e-4);
  EXPECT_NEAR(similarity_dimension(3, 0.5), 1.585, 5e-4);
}

TEST(LSystem, KochKeepsItsEnds) {
  Vec last(0);
  int segments = 0;
  draw_l_system(l_system_preset("koch"), 5, [&](const Vec& a, const Vec& b) {
    EXPECT_NEAR(glm::distance(a, last), 0, 1e-12);
    last = b;
    ++segments;
  });
  EXPECT_EQ(segments, 1024);
  EXPECT_NEAR(glm::distance(last, Vec(1, 0)), 0, 1e-12);
}

TEST(RandomKoch, HasTheLinesOfKochsCurveButNotItsTurns) {
  SeededRandom random(7), other(8);
  const auto curve = random_koch_curve(4, random);
  ASSERT_EQ(curve.size(), 257u);
  EXPECT_EQ(curve.front(), glm::dvec2(0, 0));
  EXPECT_EQ(curve.back(), glm::dvec2(1, 0));
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    EXPECT_NEAR(glm::distance(curve[i], curve[i + 1]), std::pow(3.0, -4), 1e-12);
  }
  EXPECT_NE(random_koch_curve(4, other), curve);
  EXPECT_EQ(random_koch_curve(-3, random).size(), 2u);
}

TEST(LSystem, WithoutEndIsRefused) {
  const LSystem doubling{"", "F", {{'F', "FF"}}, 90, 0, 1};
  EXPECT_THROW(l_system_string(doubling, 1'000'000, 1000), Error);
  EXPECT_EQ(l_system_string({"", "A", {}, 90, 0, 1}, 2'000'000'000), "A");
  EXPECT_THROW(read_l_system("F -> FF"), Error);
  EXPECT_THROW(read_l_system("axiom F\nangle x"), Error);
  EXPECT_THROW(read_l_system("axiom F\nFG -> F"), Error);
  EXPECT_EQ(read_l_system("axiom F # here\nF -> F + F").rules.at('F'), "F+F");
  EXPECT_THROW(l_system_preset("none"), Error);
  Turtle turtle("]]]F[", 1, 90);
  while (turtle.next([](const Vec&, const Vec&) {})) {
  }
  EXPECT_EQ(turtle.state.position, Vec(1, 0));
}

TEST(Gasket, CountsAndSizes) {
  int pieces = 0;
  double length = 0;
  cantor_set(0, 1, 5, [&](double a, double b) { ++pieces, length += b - a; });
  EXPECT_EQ(pieces, 32);
  EXPECT_NEAR(length, std::pow(2.0 / 3, 5), 1e-14);
  int triangles = 0, squares = 0, solids = 0;
  sierpinski_triangle({Vec(0, 0), Vec(1, 0), Vec(0, 1)}, 5, [&](const Triangle2&) { ++triangles; });
  sierpinski_carpet({0, 0}, {1, 1}, 3, [&](const Vec&, const Vec&) { ++squares; });
  sierpinski_tetrahedron({}, 4, [&](const Tetrahedron&) { ++solids; });
  EXPECT_EQ(triangles, 243);
  EXPECT_EQ(squares, 512);
  EXPECT_EQ(solids, 256);
}

TEST(Gasket, TetrahedraComeFarFirstAndShowTheirOutsides) {
  const auto whole = seen_tetrahedra(0, 25, 20);
  ASSERT_EQ(whole.size(), 1u);
  for (const glm::dvec3& corner : whole[0]) EXPECT_NEAR(glm::length(corner), 1, 1e-12);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_NEAR(glm::distance(whole[0][0], whole[0][i]), std::sqrt(8.0 / 3), 1e-12);
  }
  const auto pieces = seen_tetrahedra(3, 25, 20);
  EXPECT_EQ(pieces.size(), 64u);
  double last = -4;
  for (const Tetrahedron& t : pieces) {
    const double near = 0.25 * (t[0].z + t[1].z + t[2].z + t[3].z);
    EXPECT_GE(near, last);
    last = near;
  }
  // From straight ahead, above by 20 degrees: the bottom is hidden, and what is seen covers the
  // outline once: the areas of faces that look here and of those that look away are equal.
  double seen_area = 0, away_area = 0;
  Tetrahedron back = whole[0];
  for (glm::dvec3& p : back) p = {-p.x, p.y, -p.z};  // from behind
  const auto area = [](const Triangle3& c) {
    return 0.5 * std::abs(glm::cross(c[1] - c[0], c[2] - c[0]).z);
  };
  int faces = 0;
  faces_seen(whole[0], [&](std::size_t face, const Triangle3& c) {
    EXPECT_NE(face, 0u);
    seen_area += area(c);
    ++faces;
  });
  faces_seen(back, [&](std::size_t, const Triangle3& c) {
    away_area += area(c);
    ++faces;
  });
  EXPECT_EQ(faces, 4);
  EXPECT_NEAR(seen_area, away_area, 1e-12);
}

TEST(Dimension, BoxesAndRulersFindTheKnownOnes) {
  std::vector<Vec> points;
  chaos_game(triangle_ifs(), 1, 400'000, [&](const Vec& p) { points.push_back(p); });
  const std::vector<double> sizes = {0.25, 0.125, 0.0625, 0.03125, 0.015625};
  EXPECT_NEAR(fit_dimension(count_boxes(points, sizes)).dimension, std::log2(3.0), 0.06);
  std::vector<Vec> coast = {{0, 0}};
  draw_l_system(l_system_preset("koch"), 7, [&](const Vec&, const Vec& b) { coast.push_back(b); });
  std::vector<Covering> walks;
  for (double ruler = 0.2; ruler > 0.005; ruler /= 1.5) {
    walks.push_back({ruler, walk_coast(coast, ruler).steps});
  }
  EXPECT_NEAR(fit_dimension(walks).dimension, std::log(4.0) / std::log(3.0), 0.05);
  EXPECT_THROW(walk_coast(coast, 0), Error);
  EXPECT_THROW(walk_coast(coast, NAN), Error);
}

TEST(EscapeTime, EveryInstructionSetAgreesWithTheReference) {
  EscapeView view;
  view.width = 203;
  view.height = 31;
  view.step = 3.0 / 203;
  view.most = 200;
  for (const bool julia : {false, true}) {
    if (julia) view.julia = Vec(-0.8, 0.156);
    for (const std::string& target : simd_targets()) {
      use_simd_target(target);
      std::vector<std::int32_t> row(203);
      for (int j = 0; j < view.height; ++j) {
        escape_row(view, j, row.data());
        for (int i = 0; i < view.width; ++i) {
          ASSERT_EQ(row[static_cast<std::size_t>(i)], escape_time(view, i, j)) << target;
        }
      }
    }
    use_simd_target("best");
  }
  Workers workers(1);
  view.width = 0;
  EXPECT_THROW(escape_times(view, workers), Error);
}

TEST(Random, PlasmaAggregationAndBrownianMotion) {
  EXPECT_EQ(plasma(5, 0.5, 3).height, plasma(5, 0.5, 3).height);
  EXPECT_THROW(plasma(13, 0.5, 1), Error);
  EXPECT_THROW(plasma(3, NAN, 1), Error);
  double square = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Vec last(0);
    brownian_path(seed, 100, [&](const Vec& p) { last = p; });
    square += glm::dot(last, last) / 400;
  }
  EXPECT_NEAR(square, 200, 40);
  Aggregation cluster(64, 5);
  while (cluster.next()) {
    const glm::ivec2 p = cluster.particles.back();
    ASSERT_TRUE(cluster.occupied(p.x, p.y));
  }
  EXPECT_GT(cluster.particles.size(), 50u);
  EXPECT_THROW(Aggregation(1, 1), Error);
  EXPECT_THROW(ChaosGame({}, 1), Error);
}

TEST(DiamondSquare, WhatIsMadeIsFoundAndJoinedEvenly) {
  DiamondSquare made(4, 0.7, 5);
  do {
    const int side = made.field.side;
    const auto is_made = [&](int i, int j) {
      const int s = made.stride, half = s / 2;
      return (i % s == 0 && j % s == 0) || (made.diamonds_next && i % s == half && j % s == half);
    };
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const glm::ivec2 p = made.nearest_made(i, j);
        ASSERT_TRUE(is_made(p.x, p.y));
        int least = 2 * side;
        for (int y = 0; y < side; ++y) {
          for (int x = 0; x < side; ++x) {
            if (is_made(x, y)) least = std::min(least, std::abs(x - i) + std::abs(y - j));
          }
        }
        ASSERT_EQ(std::abs(p.x - i) + std::abs(p.y - j), least) << i << ' ' << j;
        if (i % made.stride == 0 && j % made.stride == 0) {
          EXPECT_EQ(made.height_between(i, j), made.field.at(i, j));
        }
      }
    }
    const double s = made.stride;
    EXPECT_NEAR(
        made.height_between(0.25 * s, 0.5 * s),
        0.375 * (made.field.at(0, 0) + made.field.at(0, made.stride)) +
            0.125 * (made.field.at(made.stride, 0) + made.field.at(made.stride, made.stride)),
        1e-12);
  } while (made.next());
}

TEST(MidpointLine, HalvesAndKeepsWhatWasThere) {
  MidpointLine line(0.5, 3);
  EXPECT_EQ(line.heights.size(), 2u);
  EXPECT_EQ(line.heights[0], 0.0);
  for (std::size_t level = 1; level <= 6; ++level) {
    const std::vector<double> coarse = line.heights;
    ASSERT_TRUE(line.next());
    ASSERT_EQ(line.heights.size(), (std::size_t{1} << level) + 1);
    for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_EQ(line.heights[2 * i], coarse[i]);
  }
  MidpointLine again(0.5, 3);
  for (int level = 0; level < 6; ++level) again.next();
  EXPECT_EQ(line.heights, again.heights);
}

// By the definition of fractional motion, heights t apart differ by t^hurst in the root mean
// square: of neighbours this holds at every level.
TEST(MidpointLine, DifferencesFollowHurstsExponent) {
  for (const double hurst : {0.25, 0.5, 0.75}) {
    double half = 0, fine = 0;
    const int lines = 4000;
    for (int seed = 0; seed < lines; ++seed) {
      MidpointLine line(hurst, static_cast<std::uint64_t>(seed));
      line.next();
      half += std::pow(line.heights[1] - line.heights[0], 2) / lines;
      for (int level = 1; level < 5; ++level) line.next();
      for (std::size_t i = 0; i < 32; ++i) {
        fine += std::pow(line.heights[i + 1] - line.heights[i], 2) / 32 / lines;
      }
    }
    EXPECT_NEAR(half / std::exp2(-2 * hurst), 1, 0.1) << hurst;
    EXPECT_NEAR(fine / std::exp2(-10 * hurst), 1, 0.1) << hurst;
  }
}

TEST(Landscape, CoversTheSquareFacingUpAndNothingLiesBelowTheSea) {
  const HeightField field = plasma(4, 0.6, 9);
  const double sea = 0.1, relief = 0.5;
  int triangles = 0, drowned = 0;
  double area = 0;
  landscape_triangles(field, relief, sea, [&](const auto& a, const auto& b, const auto& c) {
    ++triangles;
    const double twice = glm::cross(b - a, c - a).z;
    EXPECT_GT(twice, 0);
    area += twice / 2;
    for (const glm::dvec3& p : {a, b, c}) {
      const double h = field.at(static_cast<int>(std::lround(p.x * 16)),
                                static_cast<int>(std::lround(p.y * 16)));
      EXPECT_EQ(p.z, relief * std::max(h, sea));
      drowned += h < sea;
    }
  });
  EXPECT_EQ(triangles, 2 * 16 * 16);
  EXPECT_NEAR(area, 1, 1e-12);
  EXPECT_GT(drowned, 0);
  EXPECT_LT(drowned, 3 * triangles);
}

TEST(FractalCompression, SettlesNearThePicture) {
  GreySquare p{32, {}};
  for (int k = 0; k < 32 * 32; ++k) {
    p.level.push_back(0.5f + 0.4f * std::sin(0.2f * static_cast<float>(k % 32)) *
                                 std::cos(0.15f * static_cast<float>(k / 32)));
  }
  Workers workers(2);
  FractalDecoder decoder(compress_fractally(p, 4, 4, workers));
  for (int i = 0; i < 60; ++i) decoder.next();
  EXPECT_LT(decoder.next(), 1e-3f);
  double error = 0;
  for (std::size_t i = 0; i < p.level.size(); ++i) {
    error += std::pow(p.level[i] - decoder.picture.level[i], 2) / 1024;
  }
  EXPECT_LT(error, 1e-3);
  EXPECT_THROW(compress_fractally(p, 5, 4, workers), Error);
}

}  // namespace
}  // namespace kinescope
