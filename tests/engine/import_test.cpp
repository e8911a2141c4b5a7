#include "engine/io/import.h"

#include <gmock/gmock.h>

#include <chrono>

#include "engine/io/crease_normals.h"
#include "tests/engine/model_files.h"

namespace kinescope::testing {
namespace {

using ::testing::HasSubstr;

constexpr char kOff[] = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(Import, TellsFormatsByContentBeforeEnding) {
  EXPECT_EQ(import_contents("lies.stl", kOff).triangles(), 1u);
  EXPECT_EQ(import_contents("no_ending", kOff).triangles(), 1u);
  EXPECT_EQ(import_contents("a.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").triangles(), 1u);
  EXPECT_THAT(error_of("a.txt", "v 0 0 0\n"), HasSubstr("not a model file of a known kind"));
}

TEST(Import, RefusesWhatIsNoModelInOneLine) {
  EXPECT_THAT(error_of_file((test_folder() / "nobody.ply").string()), HasSubstr("cannot be read"));
  EXPECT_THAT(error_of_file(test_folder().string()), HasSubstr("a folder"));
  for (const char* name : {"a.ply", "a.stl", "a.off", "a.obj", "a.gltf", "a.glb"}) {
    EXPECT_THAT(error_of(name, ""), HasSubstr("is empty"));
    EXPECT_NE(error_of(name, "x"), "") << name;
    EXPECT_NE(error_of(name, std::string(3000, '\0')), "") << name;
    EXPECT_NE(error_of(name, "\x89PNG\r\n\x1a\n and so on"), "") << name;
  }
}

TEST(Import, TakesAMillionDegenerateTrianglesInLinearTime) {
  const auto began = std::chrono::steady_clock::now();
  const auto file_of = [](std::uint32_t count) {
    std::string file(80, ' ');
    append(file, count);
    std::string triangle(50, '\0');  // three times the same point
    for (std::uint32_t i = 0; i < count; ++i) file += triangle;
    return file;
  };
  EXPECT_EQ(import_contents("flat.stl", file_of(1000000)).triangles(), 1000000u);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  EXPECT_LT(took.count(), 60.0);
}

// All triangles meet in one point, in one edge: what walks the neighbours of each would never end.
TEST(Import, TakesAFanOfManyTrianglesAboutOneEdge) {
  std::string file = "OFF\n100002 100000 0\n0 0 0\n0 0 1\n";
  for (int i = 0; i < 100000; ++i) {
    file += std::to_string(i % 317) + " " + std::to_string(i / 317 + 1) + " 0\n";
  }
  for (int i = 0; i < 100000; ++i) file += "3 0 1 " + std::to_string(i + 2) + "\n";
  EXPECT_EQ(import_contents("fan.off", file).triangles(), 100000u);
}

TEST(Import, KeepsSmoothShadingAcrossATextureSeam) {
  // Two faces in one plane with a vertex each along their edge: their normals agree there.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.3f}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.3f}};
  mesh.texcoords.assign(6, glm::vec2(0.0f));
  mesh.indices = {0, 1, 2, 3, 4, 5};
  compute_crease_normals(mesh, kCreaseRad);
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.normals[1], mesh.normals[3]);
  EXPECT_EQ(mesh.normals[2], mesh.normals[5]);
  EXPECT_NE(mesh.normals[0], mesh.normals[1]);
  compute_crease_normals(mesh, 0.01f);
  EXPECT_NE(mesh.normals[1], mesh.normals[3]) << "below the angle between them, a crease";
}

}  // namespace
}  // namespace kinescope::testing
