#include <gmock/gmock.h>

#include "raster/colour/colour.h"
#include "tests/engine/model_files.h"

namespace kinescope::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Off, ReadsPolygonsAndComments) {
  const Imported model = import_contents("square.off",
                                         "# made by hand\nOFF # plain\n 4 2\n\n0 0 0\n1 0 0 # two\n"
                                         "1 1 0\n0 1 0\n4 0 1 2 3\n3 1 2 3\n");
  EXPECT_THAT(model.mesh().indices, ElementsAre(0, 1, 2, 0, 2, 3, 1, 2, 3));
  EXPECT_EQ(model.mesh().positions[2], glm::vec3(1, 1, 0));
}

TEST(Off, ReadsEveryKindOfVertex) {
  const std::string tail = "\n3 0 1 2\n";
  const auto mesh_of = [&](const std::string& kind, const std::array<std::string, 3>& vertices) {
    return import_contents("a.off", kind + "\n3 1 3\n" + vertices[0] + "\n" + vertices[1] + "\n" +
                                        vertices[2] + tail)
        .mesh();
  };
  const Mesh coloured =
      mesh_of("COFF", {"0 0 0 255 0 0 255", "1 0 0 0 188 0 255", "0 1 0 0 0 0 0"});
  EXPECT_EQ(coloured.colours[0], glm::vec3(1, 0, 0));
  EXPECT_FLOAT_EQ(coloured.colours[1].g, srgb_decode(188.0f / 255.0f));
  const Mesh unit = mesh_of("COFF", {"0 0 0 0.5 0 0", "1 0 0 0.0 1.0 0.0", "0 1 0 0. 0. 0."});
  EXPECT_FLOAT_EQ(unit.colours[0].r, srgb_decode(0.5f));
  const Mesh normals = mesh_of("NOFF", {"0 0 0 0 3 0", "1 0 0 0 1 0", "0 1 0 0 1 0"});
  EXPECT_EQ(normals.normals[0], glm::vec3(0, 1, 0));
  const Mesh textured = mesh_of("STOFF", {"0 0 0 0.25 0.75", "1 0 0 1 0", "0 1 0 0 1"});
  EXPECT_EQ(textured.texcoords[0], glm::vec2(0.25f, 0.25f)) << "v runs down";
  const Mesh homogeneous = mesh_of("4OFF", {"0 0 0 1", "4 0 0 2", "0 1 0 0.5"});
  EXPECT_EQ(homogeneous.positions[1], glm::vec3(2, 0, 0));
  EXPECT_EQ(homogeneous.positions[2], glm::vec3(0, 2, 0));
  const Mesh all =
      mesh_of("STCN4OFF", {"0 0 0 1 0 0 1 9 9 9 255 0.5 1", "1 0 0 1 0 0 1 9 9 9 255 1 1",
                           "0 1 0 1 0 0 1 9 9 9 255 0 0"});
  EXPECT_EQ(all.normals[2], glm::vec3(0, 0, 1));
  EXPECT_EQ(all.texcoords[0], glm::vec2(0.5f, 0.0f));
  EXPECT_FLOAT_EQ(all.colours[1].b, srgb_decode(9.0f / 255.0f));
}

TEST(Off, GivesFacesTheirOwnColours) {
  const Mesh mesh = import_contents("faces.off",
                                    "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                                    "3 0 1 2 255 0 0\n3 0 2 3 0.0 0.0 1.0\n")
                        .mesh();
  ASSERT_EQ(mesh.indices.size(), 6u);
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(mesh.colours[mesh.indices[i]], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.colours[mesh.indices[i + 3]], glm::vec3(0, 0, 1));
  }
}

TEST(Off, ReadsBinary) {
  std::string file = "OFF BINARY\n";
  const auto add = [&](auto value) { append(file, value, true); };
  for (const std::int32_t count : {3, 1, 0}) add(count);
  for (const float x : {0.0f, 0.0f, 0.0f, 2.0f, 0.0f, 0.0f, 0.0f, 3.0f, 0.0f}) add(x);
  for (const std::int32_t i : {3, 0, 1, 2, 0}) add(i);
  const Mesh mesh = import_contents("binary.off", file).mesh();
  EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
  EXPECT_EQ(mesh.positions[2], glm::vec3(0, 3, 0));
  EXPECT_THAT(error_of("short.off", file.substr(0, file.size() - 6)), HasSubstr("too early"));
  std::string huge = file;
  huge[11] = 0x7f;
  EXPECT_THAT(error_of("huge.off", huge), HasSubstr("too early"));
}

TEST(Off, RefusesDamagedFilesByPlace) {
  EXPECT_THAT(error_of("a.off", "OFF\n353535235358 6 0\n0 0 0\n"), HasSubstr("353535235358"));
  EXPECT_THAT(error_of("b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n"),
              HasSubstr("ends where a vertex number"));
  EXPECT_THAT(error_of("c.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n99999 0 1 2\n"),
              HasSubstr("ends within this face"));
  EXPECT_THAT(error_of("d.off", "OFF\nmany 1 0\n"), HasSubstr("\"many\""));
  const Imported model = import_contents(
      "e.off", "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n3 0 1 99999999999\n");
  EXPECT_EQ(model.triangles(), 1u);
  EXPECT_THAT(model.all_warnings(), HasSubstr("face 1: left out 2 faces"));
}

}  // namespace
}  // namespace kinescope::testing
