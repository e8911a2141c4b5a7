#include <gmock/gmock.h>

#include "raster/colour/colour.h"
#include "tests/engine/model_files.h"

namespace kinescope::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr char kSquare[] =
    "ply\nformat ascii 1.0\ncomment a square\n"
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "property float nx\nproperty float ny\nproperty float nz\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "property float s\nproperty float t\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 5 0 0 2 255 0 0 0 0\n"
    "1 0 5 0 0 2 0 255 0 1 0\n"
    "1 1 5 0 0 2 0 0 188 1 1\n"
    "0 1 5 0 0 2 255 255 255 0 0.25\n"
    "4 0 1 2 3\n";

TEST(Ply, ReadsAsciiWithNormalsColoursAndTexcoords) {
  const Imported model = import_contents("square.ply", kSquare);
  EXPECT_THAT(model.warnings, ::testing::IsEmpty());
  const Mesh& mesh = model.mesh();
  EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_EQ(mesh.positions[2], glm::vec3(1, 1, 5));
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1)) << "made unit length";
  EXPECT_EQ(mesh.texcoords[3], glm::vec2(0, 0.75f)) << "v runs down";
  EXPECT_EQ(mesh.colours[0], glm::vec3(1, 0, 0));
  EXPECT_FLOAT_EQ(mesh.colours[2].b, srgb_decode(188.0f / 255.0f)) << "linear";
}

std::string binary_square(bool big) {
  std::string file = std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
                     "_endian 1.0\r\nelement face 1\r\nproperty list ushort uint vertex_index\r\n"
                     "element vertex 4\r\nproperty uchar flags\r\nproperty double z\r\n"
                     "property float y\r\nproperty short x\r\n"
                     "property list uchar float weights\r\nend_header\r\n";
  append<std::uint16_t>(file, 4, big);
  for (const std::uint32_t i : {0u, 1u, 2u, 3u}) append(file, i, big);
  for (int i = 0; i < 4; ++i) {
    append<std::uint8_t>(file, 7);
    append(file, 5.0, big);
    append(file, i >= 2 ? 1.0f : 0.0f, big);
    append<std::int16_t>(file, i == 1 || i == 2 ? 1 : 0, big);
    append<std::uint8_t>(file, static_cast<std::uint8_t>(i));  // a list to leave out
    for (int k = 0; k < i; ++k) append(file, 9.0f, big);
  }
  return file;
}

TEST(Ply, ReadsBothByteOrdersAnyPropertyOrderAndFacesFirst) {
  const Mesh expected = import_contents("square.ply", kSquare).mesh();
  for (const bool big : {false, true}) {
    const Imported model = import_contents("square.ply", binary_square(big));
    EXPECT_EQ(model.mesh().positions, expected.positions) << big;
    EXPECT_EQ(model.mesh().indices, expected.indices) << big;
    EXPECT_EQ(model.mesh().normals, expected.normals) << "computed; " << big;
  }
}

TEST(Ply, ReadsTriangleStrips) {
  const Imported model =
      import_contents("strip.ply",
                      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\n"
                      "property float y\nproperty float z\nelement tristrips 1\n"
                      "property list int int vertex_indices\nend_header\n"
                      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 2 3 4\n");
  EXPECT_THAT(model.mesh().indices, ElementsAre(0, 1, 2, 2, 1, 3, 2, 3, 4));
  for (const glm::vec3& normal : model.mesh().normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(Ply, RefusesDamagedFilesByPlace) {
  const std::string square = kSquare;
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string file = square;
    return file.replace(file.find(from), from.size(), to);
  };
  EXPECT_THAT(error_of("a.ply", square.substr(0, 120)), HasSubstr("the PLY header has no end"));
  EXPECT_THAT(error_of("b.ply", square.substr(0, square.size() - 30)),
              HasSubstr("promises 4 of vertex"));
  EXPECT_THAT(error_of("k.ply", square.substr(0, square.size() - 4)), HasSubstr("too early"));
  EXPECT_THAT(error_of("c.ply", replaced("vertex 4", "vertex 4000000000000")),
              HasSubstr("promises 4000000000000 of vertex"));
  EXPECT_THAT(error_of("d.ply", replaced("float x", "quaternion x")), HasSubstr("line 5"));
  EXPECT_THAT(error_of("e.ply", replaced("ascii", "morse")), HasSubstr("\"morse\""));
  EXPECT_THAT(error_of("f.ply", replaced("1 0 5", "1 zero 5")),
              AllOf(HasSubstr("line 20"), HasSubstr("\"zero\"")));
  EXPECT_THAT(error_of("g.ply", replaced("4 0 1 2 3", "-4 0 1 2 3")),
              HasSubstr("no proper length"));
  EXPECT_THAT(error_of("h.ply", replaced("4 0 1 2 3", "4000000 0 1")), HasSubstr("within a list"));
  EXPECT_THAT(error_of("i.ply", replaced("float y", "float q")), HasSubstr("lack x, y or z"));
  EXPECT_THAT(error_of("l.ply", replaced("element face 1", "element vertex 1")),
              HasSubstr("named twice"));
  const std::string binary = binary_square(false);
  EXPECT_THAT(error_of("j.ply", binary.substr(0, binary.size() - 5)), HasSubstr("too early"));
}

TEST(Ply, LeavesOutWhatIsNotAFaceOrNotFinite) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  const Imported model = import_contents(
      "odd.ply", head + "0 0 0\n1 0 0\n0 1 0\nnan inf 1e99\n3 0 1 2\n3 0 1 7\n3 0 1 3\n2 0 1\n");
  EXPECT_EQ(model.triangles(), 1u);
  EXPECT_EQ(model.mesh().positions.size(), 3u) << "the vertex that is not finite is gone";
  EXPECT_THAT(model.all_warnings(), HasSubstr("face 1: left out 1 face that names a vertex"));
  EXPECT_THAT(model.all_warnings(), HasSubstr("1 triangle with a vertex that is not a finite"));
}

}  // namespace
}  // namespace kinescope::testing
