#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/io/gltf/materials.h"
#include "raster/image/codecs.h"
#include "tests/engine/model_files.h"

namespace kinescope::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// GLB of a JSON text and binary data.
std::string glb(std::string json, std::string binary) {
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  std::string file = "glTF";
  append<std::uint32_t>(file, 2);
  append(file, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
  append(file, static_cast<std::uint32_t>(json.size()));
  file += "JSON" + json;
  append(file, static_cast<std::uint32_t>(binary.size()));
  file += std::string("BIN\0", 4) + binary;
  return file;
}

/// What tests change of a unit square: 4 positions at 0, 6 short indices at 48, 64 bytes more.
struct Square {
  std::string attributes = R"("POSITION": 0)";
  std::string primitive = R"("indices": 1)";
  std::string nodes = R"([{"mesh": 0}])";
  std::string scenes = R"("scene": 0, "scenes": [{"nodes": [0]}])";
  std::string position = R"("bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3")";
  std::string index = R"("bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR")";
  std::string more_accessors;
  std::string more;  ///< of the top level, each with a comma before it
  std::string extra = std::string(64, '\0');

  std::string json() const {
    return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 124}], "bufferViews": [)"
           R"({"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12},)"
           R"({"buffer": 0, "byteOffset": 60, "byteLength": 64},)"
           R"({"buffer": 0, "byteOffset": 60, "byteLength": 64, "byteStride": 16}],)"
           R"("accessors": [{)" +
           position + "}, {" + index + "}" + more_accessors +
           R"(], "meshes": [{"name": "square", "primitives": [{"attributes": {)" + attributes +
           "}, " + primitive + R"(}]}], "nodes": )" + nodes + ", " + scenes + more + "}";
  }
  std::string binary() const {
    std::string bytes;
    for (const float x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) append(bytes, x);
    for (const std::uint16_t i : {0, 1, 2, 0, 2, 3}) append(bytes, i);
    return bytes + extra;
  }
  std::string file() const { return glb(json(), binary()); }
  Imported read() const { return import_contents("square.glb", file()); }
  std::string error() const { return error_of("square.glb", file()); }
};

TEST(Gltf, ReadsASquareFromEitherContainer) {
  const Imported binary = Square().read();
  EXPECT_THAT(binary.warnings, IsEmpty());
  EXPECT_THAT(binary.mesh().indices, ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_EQ(binary.mesh().positions[2], glm::vec3(1, 1, 0));
  EXPECT_EQ(binary.mesh().normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(binary.mesh().name, "square");

  write_file("data+1.bin", Square().binary());
  std::string json = Square().json();
  json.insert(json.find("\"byteLength\": 124"), R"("uri": "data+1.bin", )");
  const Imported text = import_contents("square.gltf", json);
  EXPECT_EQ(text.mesh().positions, binary.mesh().positions);
}

TEST(Gltf, ReadsEveryModeOfTriangles) {
  Square square;
  square.primitive = R"("mode": 5)";
  const Mesh strip = square.read().mesh();  // its second half is turned over
  std::vector<glm::vec3> corners;
  for (const std::uint32_t i : strip.indices) corners.push_back(strip.positions[i]);
  const glm::vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
  EXPECT_THAT(corners, ElementsAre(a, b, c, c, b, d)) << "strip";
  square.primitive = R"("mode": 6)";
  EXPECT_THAT(square.read().mesh().indices, ElementsAre(0, 1, 2, 0, 2, 3)) << "fan";
  square.primitive = R"("mode": 4)";
  EXPECT_EQ(square.read().triangles(), 1u) << "the fourth corner makes no triangle";
  square.primitive = R"("mode": 4}, {"attributes": {"POSITION": 0}, "mode": 1)";
  EXPECT_THAT(square.read().all_warnings(), HasSubstr("1 primitives that are points or lines"));
  square.primitive = R"("mode": 0)";
  EXPECT_THAT(square.error(), HasSubstr("has no triangles"));
}

TEST(Gltf, PlacesInstancesByTheNodeTree) {
  Square square;
  square.nodes = R"([{"children": [1, 2], "translation": [0, 0, 5]},
      {"mesh": 0, "rotation": [0, 0, 0.70710678, 0.70710678], "scale": [2, 1, 1]},
      {"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 7,8,9,1]}, {"mesh": 0}])";
  const Imported model = square.read();
  EXPECT_EQ(model.triangles(), 4u) << "node 3 is in no scene";
  EXPECT_EQ(model.scene.meshes.size(), 1u);
  const std::vector<glm::mat4> world = world_transforms(model.scene);
  const glm::vec4 turned = world.at(1) * glm::vec4(1, 0, 0, 1);
  EXPECT_NEAR(glm::length(turned - glm::vec4(0, 2, 5, 1)), 0.0f, 1e-6f);
  EXPECT_EQ(world.at(2) * glm::vec4(0, 0, 0, 1), glm::vec4(7, 8, 14, 1));

  square.scenes = R"("scene": 1, "scenes": [{"nodes": [0]}, {"nodes": [3]}])";
  EXPECT_EQ(square.read().triangles(), 2u) << "the default scene alone";
  square.scenes = R"("scenes": [{"nodes": [0]}, {"nodes": [3]}])";
  EXPECT_EQ(square.read().triangles(), 4u) << "the first where none is the default";
  square.scenes = R"("extras": 0)";
  EXPECT_EQ(square.read().triangles(), 6u) << "every tree where there are no scenes";
}

TEST(Gltf, RefusesCyclesAndTakesLongChains) {
  Square square;
  square.nodes = R"([{"mesh": 0, "children": [1]}, {"children": [0]}])";
  EXPECT_THAT(square.error(), HasSubstr("node 0: is among its own descendants"));
  square.nodes = R"([{"mesh": 0, "children": [1, 1]}, {"mesh": 0}])";
  EXPECT_EQ(square.read().triangles(), 4u) << "drawn below one parent only";
  square.nodes = R"([{"mesh": 0, "children": [9]}])";
  EXPECT_THAT(square.error(), HasSubstr("node 9: is not there"));
  std::string chain = "[";
  for (int i = 1; i < 20000; ++i) chain += "{\"children\": [" + std::to_string(i) + "]},";
  square.nodes = chain + "{\"mesh\": 0}]";
  EXPECT_EQ(square.read().triangles(), 2u);
}

TEST(Gltf, ReadsNormalizedIntegersStridesAndSparseAccessors) {
  Square square;
  square.extra.clear();
  for (int i = 0; i < 4; ++i) {
    for (const std::uint8_t c : {255, 0, 51, 128}) append(square.extra, c);
    for (const std::int8_t n : {0, -127, -128, 0}) append(square.extra, n);
    for (const std::uint16_t uv : {65535, 13107}) append(square.extra, uv);
    append(square.extra, 9.0f);
  }
  square.more_accessors =
      R"(, {"bufferView": 3, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC4"},
         {"bufferView": 3, "byteOffset": 4, "componentType": 5120, "normalized": true, "count": 4,
          "type": "VEC3"},
         {"bufferView": 3, "byteOffset": 8, "componentType": 5123, "normalized": true, "count": 4,
          "type": "VEC2"})";
  square.attributes = R"("POSITION": 0, "COLOR_0": 2, "NORMAL": 3, "TEXCOORD_0": 4)";
  const Imported model = square.read();
  EXPECT_EQ(model.mesh().colours[3], glm::vec3(1.0f, 0.0f, 0.2f));
  EXPECT_NEAR(model.mesh().normals[0].z, -std::sqrt(0.5f), 1e-6) << "-128 counts as -127";
  EXPECT_EQ(model.mesh().texcoords[1], glm::vec2(1.0f, 0.2f));

  Square sparse;
  sparse.extra.clear();
  append<std::uint16_t>(sparse.extra, 2);
  append<std::uint16_t>(sparse.extra, 0);
  for (const float x : {5.0f, 6.0f, 7.0f}) append(sparse.extra, x);
  sparse.extra.resize(64);
  sparse.position +=
      R"(, "sparse": {"count": 1, "indices": {"bufferView": 2, "componentType": 5123},
                                     "values": {"bufferView": 2, "byteOffset": 4}})";
  EXPECT_EQ(sparse.read().mesh().positions[2], glm::vec3(5, 6, 7));
  sparse.extra[0] = 4;
  EXPECT_THAT(sparse.error(), HasSubstr("accessor 0: its sparse part replaces an element"));
}

TEST(Gltf, RefusesAccessorsThatLeaveTheirViewsByNumber) {
  const auto error_with = [](auto change) {
    Square square;
    change(square);
    return square.error();
  };
  const auto position = [&](const std::string& text) {
    return error_with([&](Square& s) { s.position = text; });
  };
  const std::string vec3 = R"("componentType": 5126, "type": "VEC3", )";
  EXPECT_THAT(position(vec3 + R"("bufferView": 0, "count": 5)"),
              HasSubstr("accessor 0: reaches past the end of its buffer view"));
  EXPECT_THAT(position(vec3 + R"("bufferView": 0, "byteOffset": 4, "count": 4)"),
              HasSubstr("accessor 0"));
  EXPECT_THAT(position(vec3 + R"("bufferView": 77, "count": 4)"), HasSubstr("accessor 0"));
  EXPECT_THAT(position(vec3 + R"("bufferView": 0, "count": 18446744073709551615)"),
              HasSubstr("accessor 0"));
  EXPECT_THAT(position(vec3 + R"("count": 4000000000)"), HasSubstr("promises more elements"));
  EXPECT_THAT(position(R"("bufferView": 0, "componentType": 5126, "count": 2, "type": "MAT2")"),
              HasSubstr("has a type"));
  EXPECT_THAT(error_with([](Square& s) { s.attributes = R"("POSITION": 99)"; }),
              HasSubstr("accessor 99: is not there"));
  EXPECT_THAT(error_with([](Square& s) {
                s.index = R"("bufferView": 1, "componentType": 5126, "count": 3, "type": "SCALAR")";
              }),
              HasSubstr("accessor 1: cannot serve as indices"));
}

TEST(Gltf, LeavesOutTrianglesThatNameNoVertex) {
  Square square;
  std::string binary = square.binary();
  binary[48 + 10] = 9;
  const Imported model = import_contents("a.glb", glb(square.json(), binary));
  EXPECT_EQ(model.triangles(), 1u);
  EXPECT_THAT(model.all_warnings(), HasSubstr("accessor 1: left out 1 triangles that name"));
}

TEST(Gltf, RefusesDamagedContainers) {
  const std::string whole = Square().file();
  for (std::size_t size = 4; size < whole.size(); size += 17) {
    EXPECT_NE(error_of("a.glb", whole.substr(0, size)), "") << size;
  }
  std::string long_chunk = whole;
  const auto at = long_chunk.find(std::string("BIN\0", 4)) - 4;
  long_chunk[at] = static_cast<char>(long_chunk[at] + 8);  // past the end by less than a header
  EXPECT_THAT(error_of("b.glb", long_chunk), HasSubstr("ends too early"));
  EXPECT_THAT(error_of("c.gltf", "{" + std::string(100000, '[')), HasSubstr("nested too deeply"));
  EXPECT_THAT(error_of("d.gltf", R"({"asset": {"version": "1.0"}})"), HasSubstr("version 1.0"));
  std::string many = R"({"asset": {"version": "2.0"}, "buffers": [)";
  for (int i = 0; i < 40000; ++i) many += R"({"byteLength": 100000},)";
  EXPECT_THAT(error_of("e.glb", glb(many + "{}]}", std::string(100000, '\0'))),
              HasSubstr("too many buffers"));
  Square square;
  square.more = R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])";
  EXPECT_THAT(square.error(), HasSubstr("KHR_draco_mesh_compression, which is not read"));
  square.more = R"(, "extensionsRequired": ["KHR_materials_sheen"])";
  EXPECT_THAT(square.read().all_warnings(), HasSubstr("without the extension KHR_materials_sheen"));
}

TEST(Gltf, OpensNoFileByAbsolutePath) {
  const std::string elsewhere = (test_folder().parent_path() / "outside.bin").string();
  std::ofstream(elsewhere, std::ios::binary) << Square().binary();
  std::string json = Square().json();
  json.insert(json.find("\"byteLength\": 124"), R"("uri": ")" + elsewhere + R"(", )");
  EXPECT_THAT(error_of("a.gltf", json), HasSubstr("not found"));
}

TEST(Gltf, ReadsCamerasAndLights) {
  Square square;
  square.nodes = R"([{"mesh": 0, "children": [1, 2, 3, 4]}, {"camera": 0}, {"camera": 1},
      {"extensions": {"KHR_lights_punctual": {"light": 0}}},
      {"extensions": {"KHR_lights_punctual": {"light": 1}}}])";
  square.more = R"(, "cameras": [
      {"type": "perspective", "perspective": {"yfov": 1.0, "aspectRatio": 2.0, "znear": 0.5}},
      {"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 2, "znear": 1, "zfar": 9}}],
      "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "directional", "color": [1, 0.5, 0], "intensity": 3.14159265},
        {"type": "spot", "intensity": 2, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.4}}]}})";
  const Imported model = square.read();
  ASSERT_EQ(model.scene.cameras.size(), 2u);
  const Camera& camera = model.scene.cameras[0].item;
  EXPECT_EQ(model.scene.cameras[0].node, 1);
  EXPECT_EQ(camera.look_at - camera.eye, glm::vec3(0, 0, -1));
  EXPECT_NEAR(camera.window_max.y / camera.view_distance, std::tan(0.5), 1e-6);
  EXPECT_NEAR(camera.window_max.x, 2.0f * camera.window_max.y, 1e-6);
  EXPECT_EQ(model.scene.cameras[1].item.projection, Projection::kOrthographic);
  EXPECT_EQ(model.scene.cameras[1].item.window_max, glm::vec2(3, 2));
  ASSERT_EQ(model.scene.lights.size(), 2u);
  EXPECT_EQ(model.scene.lights[0].item.kind, LightKind::kDirectional);
  EXPECT_NEAR(model.scene.lights[0].item.colour.g, 0.5f, 1e-6);
  EXPECT_EQ(model.scene.lights[1].node, 4);
  EXPECT_EQ(model.scene.lights[1].item.kind, LightKind::kSpot);
  EXPECT_FLOAT_EQ(model.scene.lights[1].item.outer_cone_rad, 0.4f);
}

TEST(Gltf, MapsPhysicalSurfacesToPhong) {
  Material plastic;
  set_phong(plastic, {{1.0f, 0.5f, 0.25f}, 0.0f, 0.5f, glm::vec3(0.04f)});
  EXPECT_EQ(plastic.base_colour, glm::vec3(1.0f, 0.5f, 0.25f));
  EXPECT_FLOAT_EQ(plastic.shininess, 30.0f / 4.0f) << "alpha 1/4, Blinn's exponent 30";
  EXPECT_FLOAT_EQ(plastic.specular.r, 0.04f * 38.0f / 8.0f);
  Material gold;
  set_phong(gold, {{1.0f, 0.5f, 0.25f}, 1.0f, 0.5f, glm::vec3(0.04f)});
  EXPECT_LT(gold.base_colour.r, 0.5f) << "darker body";
  EXPECT_FLOAT_EQ(gold.specular.g / gold.specular.r, 0.5f) << "tinted highlight";
  EXPECT_LE(gold.specular.r, 1.0f);
  Material mirror, chalk;
  set_phong(mirror, {glm::vec3(1.0f), 1.0f, 0.0f, glm::vec3(0.04f)});
  set_phong(chalk, {glm::vec3(1.0f), 0.0f, 1.0f, glm::vec3(0.04f)});
  EXPECT_GT(mirror.shininess, 500.0f);
  EXPECT_EQ(chalk.shininess, 1.0f);
}

TEST(Gltf, LaysTexturesByTheirSamplerSetAndTransform) {
  Image<Srgb8> picture(2, 1, {255, 0, 0, 0});
  picture.at(1, 0) = {0, 0, 255, 200};
  write_png((test_folder() / "p q.png").string(), picture);
  Square square;
  square.attributes = R"("POSITION": 0, "TEXCOORD_1": 2, "TEXCOORD_0": 0)";
  square.more_accessors =
      R"(, {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC2"})";
  square.primitive = R"("indices": 1, "material": 0)";
  const std::string transform =
      R"("extensions": {"KHR_texture_transform": {"scale": [2, 3], "offset": [0.5, 0.25]}})";
  square.more = R"(, "images": [{"uri": "p%20q.png"}, {"uri": "gone.png"}],
      "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}],
      "textures": [{"source": 0, "sampler": 0}, {"source": 1}],
      "materials": [{"doubleSided": true, "alphaMode": "MASK", "alphaCutoff": 0.5,
        "emissiveFactor": [0, 1, 0], "pbrMetallicRoughness": {"metallicFactor": 0,
        "baseColorTexture": {"index": 0, "texCoord": 1, )" +
                transform + R"(}}},
        {"pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}}])";
  const Imported model = square.read();
  const Material& material = model.scene.materials.at(0);
  EXPECT_TRUE(material.double_sided);
  EXPECT_EQ(material.emission, glm::vec3(0, 1, 0));
  const Texture& texture = model.scene.textures.at(static_cast<std::size_t>(material.base_texture));
  EXPECT_EQ(texture.wrap_u, Wrap::kClamp);
  EXPECT_EQ(texture.wrap_v, Wrap::kMirror);
  EXPECT_EQ(texture.filter, Filter::kNearest);
  EXPECT_EQ(texture.level(0).at(0, 0).a, 0) << "below the cutoff";
  EXPECT_EQ(texture.level(0).at(1, 0).a, 65535) << "above it";
  // TEXCOORD_1 shows the positions' first floats in pairs: (0,0), (0,1), (0,0), (1,1).
  EXPECT_EQ(model.mesh().texcoords[1], glm::vec2(0.5f, 3.25f));
  EXPECT_EQ(model.mesh().texcoords[3], glm::vec2(2.5f, 3.25f));
  EXPECT_THAT(model.all_warnings(), HasSubstr("gone.png"));
  EXPECT_EQ(model.scene.materials.at(1).base_texture, -1);
}

TEST(Gltf, ReadsSpecularGlossinessAndUnlit) {
  Square square;
  square.more = R"(, "materials": [
      {"extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.5, 0.25, 0, 1],
        "specularFactor": [0.2, 0.1, 0.1], "glossinessFactor": 0.5}}},
      {"extensions": {"KHR_materials_unlit": {}}, "pbrMetallicRoughness":
        {"baseColorFactor": [0, 1, 0, 0.5]}, "alphaMode": "BLEND"}])";
  const Imported model = square.read();
  const Material& glossy = model.scene.materials.at(0);
  EXPECT_EQ(glossy.base_colour, glm::vec3(0.5f, 0.25f, 0.0f));
  EXPECT_NEAR(glossy.specular.r / glossy.specular.g, 2.0f, 1e-4);
  EXPECT_FLOAT_EQ(glossy.shininess, 7.5f);
  const Material& unlit = model.scene.materials.at(1);
  EXPECT_EQ(unlit.emission, glm::vec3(0, 1, 0));
  EXPECT_EQ(unlit.base_colour, glm::vec3(0.0f));
  EXPECT_EQ(unlit.specular, glm::vec3(0.0f));
  EXPECT_FLOAT_EQ(unlit.opacity, 0.5f);
}

// Primitives that share one accessor must not multiply the file's size in memory.
TEST(Gltf, BoundsWhatManyPrimitivesMakeOfOneAccessor) {
  constexpr std::size_t kIndices = 99999;
  const auto file_of = [](int primitives) {
    std::string json =
        R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 100048}], "bufferViews": [)"
        R"({"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 100000}],)"
        R"("accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},)"
        R"({"bufferView": 1, "componentType": 5121, "count": 99999, "type": "SCALAR"}],)"
        R"("nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "meshes": [{"primitives": [)";
    for (int i = 0; i < primitives; ++i) {
      json += std::string(i ? "," : "") + R"({"attributes": {"POSITION": 0}, "indices": 1})";
    }
    return glb(json + "]}]}", std::string(100048, '\0'));
  };
  EXPECT_EQ(import_contents("few.glb", file_of(3)).triangles(), 3 * kIndices / 3);
  EXPECT_THAT(error_of("many.glb", file_of(1000)), HasSubstr("too many primitives"));
}

}  // namespace
}  // namespace kinescope::testing
