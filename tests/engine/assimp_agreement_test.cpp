// Our triangle counts against Assimp's, on every model of Debian's assimp-testmodels that is in a
// format we read. Assimp crashes on hostile files, so what is in `invalid` only our readers see.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <chrono>
#include <map>
#include <optional>

#include "tests/engine/model_files.h"

namespace kinescope::testing {
namespace {

namespace fs = std::filesystem;

constexpr char kModels[] = "/usr/share/assimp/models";

/// Where we differ from Assimp, on purpose.
const std::map<std::string, std::string>& exceptions() {
  static const std::map<std::string, std::string> kExceptions{
      {"OBJ/box_UTF16BE.obj", "UTF-16 text, of which Assimp makes an empty model; we read it"},
      {"OFF/invalid.off", "its second face has 220 corners and ends at the first: truncated"},
      {"glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb",
       "every triangle has an infinite vertex and is left out, which leaves none"},
      {"glTF2/draco/2CylinderEngine.gltf", "compressed with Draco, which we say we do not read"},
      {"glTF2/issue_3269/texcoord_crash.gltf",
       "Assimp refuses a gap in the numbers of texture coordinates; we need none of them"},
      {"glTF2/wrongTypes/badExtension.gltf", "a wrong type in a material; drawn all the same"},
      {"glTF2/wrongTypes/badNumber.gltf", "a wrong type in a material; drawn all the same"},
      {"glTF2/wrongTypes/badObject.gltf", "a wrong type in a material; drawn all the same"},
      {"glTF2/wrongTypes/badString.gltf", "a scene's name is no text; drawn all the same"},
      {"glTF2/wrongTypes/badUint.gltf", "a wrong type in a material; drawn all the same"}};
  return kExceptions;
}

std::vector<std::string> files_of(const std::string& folder, std::vector<std::string> endings) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(kModels) / folder)) {
    std::string ending = entry.path().extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool fits = std::find(endings.begin(), endings.end(), ending) != endings.end();
    if (fits || entry.path().filename() == "formatDetection") {
      files.push_back(fs::relative(entry.path(), kModels).string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Triangles that Assimp would draw; none where it refuses the file or finds only points and lines.
std::uint64_t assimp_triangles(const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFile(path, aiProcess_Triangulate | aiProcess_PreTransformVertices);
  std::uint64_t triangles = 0;
  for (unsigned m = 0; scene && m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) triangles += mesh.mFaces[f].mNumIndices == 3;
  }
  return triangles;
}

/// Triangles that we would draw; none where we refuse the file, in one line.
std::uint64_t our_triangles(const std::string& path) {
  const auto began = std::chrono::steady_clock::now();
  Warnings warnings;
  std::uint64_t triangles = 0;
  try {
    triangles = drawn_triangle_count(import_model(path, warnings));
    EXPECT_GT(triangles, 0u) << path;
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  EXPECT_LT(took.count(), 20.0) << path;
  return triangles;
}

void expect_agreement(const std::string& folder, const std::vector<std::string>& endings,
                      std::size_t at_least) {
  const std::vector<std::string> files = files_of(folder, endings);
  EXPECT_GE(files.size(), at_least);
  for (const std::string& file : files) {
    const std::string path = (fs::path(kModels) / file).string();
    const std::uint64_t ours = our_triangles(path);
    const std::uint64_t theirs = assimp_triangles(path);
    const auto exception = exceptions().find(file);
    if (exception == exceptions().end()) {
      EXPECT_EQ(ours, theirs) << file;
    } else {
      EXPECT_NE(ours, theirs) << file << " is no exception any more: " << exception->second;
    }
  }
}

TEST(AssimpAgreement, Gltf) {
  KINESCOPE_NEED_DATA(kModels);
  expect_agreement("glTF2", {".gltf", ".glb"}, 40);
}
TEST(AssimpAgreement, Obj) {
  KINESCOPE_NEED_DATA(kModels);
  expect_agreement("OBJ", {".obj"}, 22);
}
TEST(AssimpAgreement, Ply) {
  KINESCOPE_NEED_DATA(kModels);
  expect_agreement("PLY", {".ply"}, 8);
}
TEST(AssimpAgreement, Stl) {
  KINESCOPE_NEED_DATA(kModels);
  expect_agreement("STL", {".stl"}, 9);
}
TEST(AssimpAgreement, Off) {
  KINESCOPE_NEED_DATA(kModels);
  expect_agreement("OFF", {".off"}, 4);
}

TEST(AssimpAgreement, CountsInstances) {
  KINESCOPE_NEED_DATA(kModels);
  const Imported engine =
      import(std::string(kModels) + "/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb");
  std::uint64_t stored = 0;
  for (const Mesh& mesh : engine.scene.meshes) stored += mesh.indices.size() / 3;
  EXPECT_EQ(stored, 75730u);
  EXPECT_EQ(engine.triangles(), 121496u);
}

constexpr char kFurniture[] = "/usr/share/sweethome3d/furniture/KatorLegaz.sh3f";

// Textured OBJ files as their authors' tools wrote them; the smaller ones, for the time it takes.
TEST(AssimpAgreement, Furniture) {
  KINESCOPE_NEED_DATA(kFurniture);
  KINESCOPE_NEED_DATA("/usr/bin/unzip");
  const fs::path folder = test_folder();
  const std::string unzip =
      std::string("unzip -qq -o ") + kFurniture + " -d '" + folder.string() + "' 2>&1";
  ASSERT_EQ(std::system(unzip.c_str()), 0);
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".obj" || entry.file_size() > 200000) continue;
    const std::string path = entry.path().string();
    EXPECT_EQ(our_triangles(path), assimp_triangles(path)) << path;
    ++files;
  }
  EXPECT_GE(files, 24u);
  fs::remove_all(folder);
}

TEST(AssimpAgreement, Bunny) {
  constexpr char kBunny[] = "/usr/share/glmark2/models/bunny.obj";
  KINESCOPE_NEED_DATA(kBunny);
  EXPECT_EQ(our_triangles(kBunny), 69666u);
}

// glTF 1 is another format, which the same ending hides.
TEST(AssimpAgreement, RefusesGltf1ByName) {
  KINESCOPE_NEED_DATA(kModels);
  for (const std::string& file : files_of("glTF", {".gltf", ".glb"})) {
    EXPECT_THAT(error_of_file((fs::path(kModels) / file).string()),
                ::testing::AnyOf(::testing::HasSubstr("only version 2 is read"),
                                 ::testing::HasSubstr("does not say that it is glTF 2")));
  }
}

TEST(AssimpAgreement, EveryFileOfAnyKindEndsInAModelOrOneLine) {
  KINESCOPE_NEED_DATA(kModels);
  std::size_t models = 0;
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kModels)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    models += our_triangles(entry.path().string()) > 0;
  }
  EXPECT_GT(files, 300u);
  EXPECT_GT(models, 60u);
}

}  // namespace
}  // namespace kinescope::testing
