// `kinescope render` on models as people have them: whole, and in good light.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

#include "raster/colour/colour.h"
#include "raster/image/codecs.h"
#include "tests/demos/parse_json.h"
#include "tests/demos/program_run.h"
#include "tests/raster/optional_data.h"

namespace kinescope::test {
namespace {

struct Model {
  const char* file;         ///< below kModels
  int triangles;            ///< as Assimp counts them, instances drawn
  double least_brightness;  ///< mean of the encoded pixels of the model, 0 to 255
};

void PrintTo(const Model& model, std::ostream* out) { *out << model.file; }

const std::string kModels = "/usr/share/assimp/models/";

class ProgramModels : public ::testing::TestWithParam<Model> {
 protected:
  Image<Srgb8> picture(const std::string& shading) {
    const RunResult run = run_kinescope(
        {"render", kModels + GetParam().file, "--headless", "--display", "none", "--size",
         "400x300", "--aa", "1", "--shading", shading, "--json", "-o", "a.png"},
        {.folder = folder_.path()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(parse_json(run.out)["triangles"], GetParam().triangles);
    return read_image_file(folder_ / "a.png");
  }

 private:
  TemporaryFolder folder_;
};

double linear_sum(Srgb8 c) {
  double sum = 0;
  for (const int channel : {c.r, c.g, c.b}) sum += srgb_decode(static_cast<float>(channel) / 255);
  return sum;
}

// What a model is painted with is its own affair (the spider is dark: its textures are, and MTL
// multiplies them by Kd); that light falls on it is ours, and the same for all.
TEST_P(ProgramModels, IsWholeAndWellLit) {
  KINESCOPE_NEEDS(kModels + GetParam().file);
  const Image<Srgb8> paint = picture("unlit"), lit = picture("phong");
  double reflectance = 0, light = 0, brightness = 0;
  int pixels = 0;
  for (std::size_t i = 0; i < paint.pixels().size(); ++i) {
    const Srgb8 p = paint.pixels()[i], l = lit.pixels()[i];
    if (p == Srgb8{}) continue;
    reflectance += linear_sum(p);
    light += linear_sum(l);
    brightness += (l.r + l.g + l.b) / 3.0;
    ++pixels;
  }
  ASSERT_GT(pixels, 400 * 300 / 10);  // framed to fill the picture
  EXPECT_GT(brightness / pixels, GetParam().least_brightness);
  EXPECT_GT(light / reflectance, 0.35);
  EXPECT_LT(light / reflectance, 0.75);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, ProgramModels,
    ::testing::Values(Model{"glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", 121496, 120},
                      Model{"OBJ/spider.obj", 1368, 20}, Model{"PLY/Wuson.ply", 3732, 120},
                      Model{"STL/Spider_binary.stl", 1368, 130}));

}  // namespace
}  // namespace kinescope::test
