#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "raster/image/codecs.h"
#include "tests/engine/model_files.h"

namespace kinescope::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr char kSquare[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// A cube whose faces point outward.
constexpr char kCube[] =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

float srgb(double value) { return srgb_decode(static_cast<float>(value)); }

TEST(Obj, ReadsACubeWithSharpEdgesOutward) {
  const Imported model = import_contents("cube.obj", kCube);
  EXPECT_EQ(model.triangles(), 12u);
  EXPECT_THAT(model.warnings, IsEmpty());
  const Mesh& mesh = model.mesh();
  EXPECT_EQ(mesh.positions.size(), 24u) << "three normals at each corner";
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const glm::vec3 normal = mesh.normals[mesh.indices[i]];
    const glm::vec3 from_middle = mesh.positions[mesh.indices[i]] - glm::vec3(0.5f);
    EXPECT_FLOAT_EQ(glm::length(normal), 1.0f);
    EXPECT_FLOAT_EQ(glm::dot(normal, from_middle), 0.5f) << "along the face it belongs to";
  }
}

TEST(Obj, HonoursSmoothingGroups) {
  EXPECT_EQ(import_contents("s.obj", std::string("s 1\n") + kCube).mesh().positions.size(), 8u);
  EXPECT_EQ(import_contents("f.obj", std::string("s off\n") + kCube).mesh().positions.size(), 24u);
}

TEST(Obj, CountsBackwardsAndReadsEveryKindOfCorner) {
  const Imported model = import_contents(
      "a.obj", std::string(kSquare) + "vt 0 0.25\nvn 0 0 2\nf -4/-1/-1 2/1/1 3//1 \\\n 4\n");
  const Mesh& mesh = model.mesh();
  EXPECT_EQ(model.triangles(), 2u);
  EXPECT_EQ(mesh.positions[0], glm::vec3(0, 0, 0));
  EXPECT_EQ(mesh.texcoords[0], glm::vec2(0.0f, 0.75f)) << "v runs down";
  EXPECT_EQ(mesh.texcoords[2], glm::vec2(0.0f)) << "none given";
  for (const glm::vec3& normal : mesh.normals) {
    EXPECT_EQ(normal, glm::vec3(0, 0, 1)) << "given, or filled in";
  }
}

TEST(Obj, ReadsVertexColours) {
  const Imported model =
      import_contents("c.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(model.mesh().colours[0], glm::vec3(1, 0, 0));
  EXPECT_FLOAT_EQ(model.mesh().colours[1].g, srgb(0.5));
  EXPECT_EQ(model.mesh().colours[2], glm::vec3(1, 1, 1)) << "none given";
}

TEST(Obj, ReadsMaterialsAndTextures) {
  Image<Srgb8> picture(2, 2, {255, 0, 0, 255});
  picture.at(0, 0) = {0, 255, 0, 255};
  write_png((test_folder() / "a picture.png").string(), picture);
  write_file("my own.mtl",
             "newmtl  shiny red\nKd 1 0.5 0\nKs 0.5 0.5 0.5\nNs 60\nKe 0 0 0.5\nd 0.5\nillum 2\n"
             "newmtl textured\nKd 1 1 1\nmap_Kd -clamp on a picture.png\n"
             "newmtl again\nmap_Kd .\\a picture.png\nnewmtl dull\nKs 1 1 1\nillum 1\n");
  const Imported model = import_contents(
      "m.obj",
      "mtllib my own.mtl\n" + std::string(kSquare) +
          "usemtl shiny red \nf 1 2 3\nusemtl textured\nf 1 3 4\nusemtl shiny red\nf 1 2 4\n");
  EXPECT_THAT(model.warnings, IsEmpty());
  ASSERT_EQ(model.scene.meshes.size(), 2u) << "one a material";
  EXPECT_EQ(model.mesh(0).indices.size(), 6u);
  const Material& red = model.scene.materials.at(static_cast<std::size_t>(model.mesh(0).material));
  EXPECT_EQ(red.name, "shiny red");
  EXPECT_FLOAT_EQ(red.base_colour.g, srgb(0.5));
  EXPECT_FLOAT_EQ(red.specular.r, srgb(0.5));
  EXPECT_FLOAT_EQ(red.emission.b, srgb(0.5));
  EXPECT_FLOAT_EQ(red.shininess, 60.0f);
  EXPECT_FLOAT_EQ(red.opacity, 0.5f);
  const Material& laid = model.scene.materials.at(static_cast<std::size_t>(model.mesh(1).material));
  const Texture& texture = model.scene.textures.at(static_cast<std::size_t>(laid.base_texture));
  EXPECT_EQ(texture.wrap_u, Wrap::kClamp);
  EXPECT_EQ(texture.level(0).at(0, 0).g, 65535);
  EXPECT_EQ(texture.level(0).at(1, 1).r, 65535);
  EXPECT_EQ(model.scene.textures.at(1).wrap_u, Wrap::kRepeat);
  EXPECT_EQ(model.scene.materials.at(3).specular, glm::vec3(0.0f)) << "illum 1 has no highlight";
}

TEST(Obj, DrawsWithoutWhatIsMissing) {
  write_file("broken.png", "this is no picture");
  write_file(
      "m.mtl",
      "newmtl a\nmap_Kd gone.png\nnewmtl b\nmap_Kd broken.png\nnewmtl c\nmap_Kd /etc/gone.png\n");
  const Imported model =
      import_contents("a.obj", "mtllib gone.mtl\nmtllib m.mtl\n" + std::string(kSquare) +
                                   "usemtl nobody\nf 1 2 3\nusemtl a\nf 1 3 4\n");
  EXPECT_EQ(model.triangles(), 2u);
  const std::string told = model.all_warnings();
  EXPECT_THAT(told, HasSubstr("gone.mtl is missing"));
  EXPECT_THAT(told, HasSubstr("gone.png: the texture is missing"));
  EXPECT_THAT(told, HasSubstr("broken.png"));
  EXPECT_THAT(told, HasSubstr("line 7: the material nobody is not defined"));
  EXPECT_EQ(model.scene.textures.size(), 0u);
}

TEST(Obj, LeavesOutFacesThatCannotBe) {
  const Imported model = import_contents(
      "a.obj", std::string(kSquare) +
                   "v nan 0 0\nf 1 2 3\nf 1 2 99\nf 0 1 2\nf -99 1 2\nf 1 2 5\nf 1 2\nf\nf a b c\n"
                   "f 1/9/9 2/9/9 3/9/9\nf 1 2 99999999999999999999\n");
  EXPECT_EQ(model.triangles(), 2u);
  EXPECT_THAT(model.all_warnings(), HasSubstr("line 7: left out 5 faces"));
  EXPECT_THAT(model.all_warnings(), HasSubstr("1 triangle with a vertex that is not"));
}

TEST(Obj, ReadsPolygonsOfAnySizeAndOddText) {
  std::string ring;
  std::string face = "f";
  for (int i = 1; i <= 300; ++i) {
    ring += "v " + std::to_string(std::cos(i * 0.02)) + " " + std::to_string(std::sin(i * 0.02)) +
            " 0\r\n";
    face += " " + std::to_string(i);
  }
  EXPECT_EQ(import_contents("r.obj", "\xef\xbb\xbf# a ring\r\n" + ring + face).triangles(), 298u);
  std::string wide("\xff\xfe");
  for (const char c : std::string(kSquare) + "f 1 2 3 4\n") wide += std::string(1, c) + '\0';
  EXPECT_EQ(import_contents("w.obj", wide).triangles(), 2u) << "UTF-16";
  EXPECT_THAT(error_of("e.obj", kSquare), HasSubstr("has no triangles"));
  EXPECT_THAT(error_of("b.obj", std::string(5000, '\x01')), HasSubstr("has no triangles"));
}

TEST(Obj, SurvivesHostileMaterialFiles) {
  for (const std::string& mtl :
       {std::string(), std::string("newmtl"), std::string("newmtl \nKd\nNs\nmap_Kd\nd\n"),
        std::string("map_Kd -o -s -t -bm\nKd nan inf -1e999\nNs 1e400\nd -5\n"),
        std::string(100000, 'x'), std::string("newmtl a\nmap_Kd ") + std::string(9000, '/'),
        std::string("newmtl a\nKd 1e30 1e30 1e30\nNs -3\nKe 1e38 0 0\nmap_Kd -imfchan\n") +
            std::string(2, '\0')}) {
    write_file("m.mtl", mtl);
    const Imported model =
        import_contents("a.obj", "mtllib m.mtl\nusemtl a\n" + std::string(kSquare) + "f 1 2 3\n");
    for (const Material& material : model.scene.materials) {
      EXPECT_GE(material.shininess, 1.0f);
      EXPECT_GE(material.opacity, 0.0f);
      for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(material.base_colour[i] >= 0.0f && material.base_colour[i] <= 1.0f);
        EXPECT_TRUE(material.emission[i] >= 0.0f && material.emission[i] <= 1.0f);
      }
    }
  }
}

}  // namespace
}  // namespace kinescope::testing
