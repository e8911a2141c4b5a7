#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/engine/model_files.h"

namespace kinescope::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Triangles = std::vector<std::array<glm::vec3, 3>>;

std::string binary_stl(const Triangles& triangles, const std::string& title) {
  std::string file = title;
  file.resize(80, '\0');
  append(file, static_cast<std::uint32_t>(triangles.size()));
  for (const auto& triangle : triangles) {
    for (int i = 0; i < 3; ++i) append(file, 7.0f);  // a normal that means nothing
    for (const glm::vec3& corner : triangle) {
      for (int i = 0; i < 3; ++i) append(file, corner[i]);
    }
    append<std::uint16_t>(file, 0xffff);
  }
  return file;
}

/// The side of a cylinder about z, radius 1, without caps.
Triangles tube(int sides) {
  Triangles triangles;
  const auto point = [&](int i, float z) {
    const double angle = 2.0 * std::numbers::pi * (i % sides) / sides;
    return glm::vec3(std::cos(angle), std::sin(angle), z);
  };
  for (int i = 0; i < sides; ++i) {
    triangles.push_back({point(i, 0), point(i + 1, 0), point(i + 1, 1)});
    triangles.push_back({point(i, 0), point(i + 1, 1), point(i, 1)});
  }
  return triangles;
}

constexpr char kTwoSolids[] =
    "solid first facet of a name\n facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0\n"
    "vertex 0 1 0 endloop endfacet endsolid first\n"
    "SOLID second\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 1e0 0 -0\nVERTEX +1 1 0\n"
    "VERTEX 0 1 0\nENDLOOP\nENDFACET\nendsolid\nsolid empty\nendsolid\n";

TEST(Stl, ReadsAsciiByWordsWithSeveralSolids) {
  const Imported model = import_contents("two.stl", kTwoSolids);
  EXPECT_EQ(model.triangles(), 2u);
  EXPECT_EQ(model.mesh().positions.size(), 4u) << "equal corners are joined, -0 with 0";
  EXPECT_THAT(model.mesh().indices, ElementsAre(0, 1, 2, 1, 3, 2));
}

TEST(Stl, ReadsBinaryThatBeginsWithSolid) {
  const Triangles triangles{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  const Imported model = import_contents("a.stl", binary_stl(triangles, "solid lies"));
  EXPECT_THAT(model.mesh().positions,
              ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
  EXPECT_EQ(model.mesh().normals[0], glm::vec3(0, 0, 1)) << "computed, not read";
}

TEST(Stl, SmoothsACylinderAndKeepsAPrismSharp) {
  const Mesh round = import_contents("round.stl", binary_stl(tube(24), "")).mesh();
  EXPECT_EQ(round.positions.size(), 48u);
  for (std::size_t i = 0; i < round.positions.size(); ++i) {
    EXPECT_NEAR(round.normals[i].x, round.positions[i].x, 1e-3);
    EXPECT_NEAR(round.normals[i].y, round.positions[i].y, 1e-3);
  }
  // Six sides meet at 60 degrees, above the crease angle: each keeps corners of its own.
  const Mesh prism = import_contents("prism.stl", binary_stl(tube(6), "")).mesh();
  EXPECT_EQ(prism.positions.size(), 24u);
}

TEST(Stl, RefusesDamagedFiles) {
  const std::string whole = binary_stl(tube(8), "eight sides");
  EXPECT_THAT(error_of("a.stl", whole.substr(0, whole.size() - 60)),
              HasSubstr("promises 16 triangles and holds 14"));
  EXPECT_THAT(error_of("b.stl", whole.substr(0, 82)), HasSubstr("ends too early"));
  EXPECT_THAT(error_of("c.stl", binary_stl({}, "none")), HasSubstr("has no triangles"));
  const std::string text = kTwoSolids;
  EXPECT_THAT(error_of("d.stl", text.substr(0, text.find("ENDFACET"))),
              HasSubstr("ends within a facet"));
  EXPECT_THAT(error_of("e.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 x 0\n"),
              AllOf(HasSubstr("line 4"), HasSubstr("\"x\"")));
}

}  // namespace
}  // namespace kinescope::testing
