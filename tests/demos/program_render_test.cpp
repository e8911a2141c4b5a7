// `kinescope render` from outside: what comes out, and that it is always the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

#include "raster/base/simd.h"
#include "tests/demos/program_render.h"

namespace kinescope::test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(ProgramRender, BarePictureShowsALitCubeOnBlack) {
  const Image<Srgb8> p = picture({"--display", "none", "--size", "320x240"});
  ASSERT_EQ(p.width(), 320);
  ASSERT_EQ(p.height(), 240);
  EXPECT_GT(brightness(p.at(160, 120)), 60);
  EXPECT_LT(brightness(p.at(3, 3)), 60);
  std::set<int> shades;  // three faces are seen, each in light of its own
  for (const Srgb8 c : p.pixels()) shades.insert(c.g);
  EXPECT_GE(shades.size(), 3u);
}

TEST_F(ProgramRender, BareDefaultSizeIs1280x960) {
  const json f = figures({"--display", "none"});
  EXPECT_EQ(f["width"], 1280);
  EXPECT_EQ(f["height"], 960);
}

TEST_F(ProgramRender, TheTubeShowsThePictureAtItsOwnSize) {
  const Image<Srgb8> bare = picture({"--display", "none", "--size", "640x480"});
  const Image<Srgb8> tube = picture({});
  ASSERT_EQ(tube.width(), 1280);
  ASSERT_EQ(tube.height(), 960);
  // Gamma correction keeps the tones: means over a patch of a lit face agree.
  double on_tube = 0, on_paper = 0;
  for (int i = 0; i < 400; ++i) {
    on_tube += brightness(tube.at(600 + i % 20, 500 + i / 20)) / 400;
    on_paper += brightness(bare.at(300 + i % 20 / 2, 250 + i / 40)) / 400;
  }
  EXPECT_NEAR(on_tube, on_paper, 4);
  EXPECT_LT(brightness(tube.at(3, 3)), 60);
}

TEST_F(ProgramRender, TheTubeKeepsItsShapeOnBlack) {
  const Image<Srgb8> wide = picture({"--size", "600x240", "--shading", "unlit"});
  ASSERT_EQ(wide.width(), 600);
  ASSERT_EQ(wide.height(), 240);
  for (int y = 0; y < 240; ++y) {
    ASSERT_EQ(wide.at(100, y), Srgb8{}) << y;  // 320 pixels in the middle are the tube
    ASSERT_EQ(wide.at(499, y), Srgb8{}) << y;
  }
  EXPECT_GT(brightness(wide.at(300, 120)), 60);
}

TEST_F(ProgramRender, GreenPhosphorIsGreen) {
  const Image<Srgb8> p = picture({"--display", "vga-green", "--size", "320x240"});
  const Srgb8 c = p.at(160, 120);
  EXPECT_GT(c.g, c.r + 30);
  EXPECT_GT(c.g, c.b + 10);
}

TEST_F(ProgramRender, AShortShutterCatchesABand) {
  const Image<Srgb8> band =
      picture({"--shading", "unlit", "--shutter", "1/1000", "--size", "320x240"});
  const Image<Srgb8> whole = picture({"--shading", "unlit", "--size", "320x240"});
  EXPECT_LT(mean_brightness(band), 0.5 * mean_brightness(whole));
}

TEST_F(ProgramRender, EveryShadingModelLooksDifferent) {
  std::set<std::string> hashes;
  const std::vector<std::string> models{"flat", "gouraud", "phong", "blinn", "unlit", "wireframe"};
  // A sphere of sorts: rounded by its shared normals, shiny.
  write_text(folder_ / "model.obj", "mtllib m.mtl\nusemtl m\n" + cube_obj());
  write_text(folder_ / "m.mtl", "newmtl m\nKd .5 .4 .3\nKs 1 1 1\nNs 8\n");
  std::string obj = read_text(folder_ / "model.obj");
  for (const char* n :
       {"-1 -1 -1", "1 -1 -1", "1 1 -1", "-1 1 -1", "-1 -1 1", "1 -1 1", "1 1 1", "-1 1 1"}) {
    obj += std::string("vn ") + n + "\n";
  }
  std::string smooth;
  std::istringstream lines(obj);
  std::string faces;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("f ")) {
      smooth += line + "\n";
      continue;
    }
    std::istringstream words(line.substr(2));
    faces += "f";
    for (std::string i; words >> i;) faces += " " + i + "//" + i;
    faces += "\n";
  }
  write_text(folder_ / "model.obj", smooth + faces);
  for (const std::string& model : models) {
    hashes.insert(
        figures({"--display", "none", "--size", "200x150", "--shading", model})["colour_hash"]
            .get<std::string>());
  }
  EXPECT_EQ(hashes.size(), models.size());
}

TEST_F(ProgramRender, JsonHoldsTheFigures) {
  const json f = figures(
      {"--display", "none", "--size", "64x48", "--aa", "8", "--threads", "3", "-o", "a.png"});
  EXPECT_EQ(f["triangles"], 12);
  EXPECT_EQ(f["drawn"], 6);  // of a convex body's faces half are seen
  EXPECT_GT(f["fragments"].get<int>(), 100);
  EXPECT_EQ(f["samples"], 8);
  EXPECT_EQ(f["threads"], 3);
  EXPECT_EQ(f["simd"], simd_target());
  const auto frame_ms = [&](const char* figure) { return f["frame_ms"][figure].get<double>(); };
  EXPECT_GT(frame_ms("min"), 0);
  EXPECT_LE(frame_ms("min"), frame_ms("median"));
  EXPECT_LE(frame_ms("median"), frame_ms("max"));
  EXPECT_LE(frame_ms("max"), f["ms"].get<double>());
  EXPECT_EQ(f["stages_ms"].size(), 3u);
  for (const char* stage : {"draw", "display", "write"}) {
    ASSERT_TRUE(f["stages_ms"][stage].is_number()) << stage;
    EXPECT_GE(f["stages_ms"][stage].get<double>(), 0) << stage;
  }
  EXPECT_GT(f["stages_ms"]["draw"].get<double>(), 0);
  EXPECT_EQ(f["visibility_hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(f["colour_hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(f["frames"].size(), 1u);
  EXPECT_GT(f["peak_memory_mib"].get<double>(), 1);
  EXPECT_GT(f["ms"].get<double>(), 0);
  EXPECT_TRUE(f["warnings"].empty());
}

TEST_F(ProgramRender, SamePictureForAnyThreadsAndRun) {
  for (const char* display : {"none", "vga-colour"}) {
    std::set<std::string> seen;
    for (const char* threads : {"1", "2", "8", "8"}) {
      const json f = figures({"--display", display, "--size", "320x240", "--threads", threads});
      seen.insert(f["frames"].dump());
      EXPECT_EQ(f["threads"], std::stoi(threads));
    }
    EXPECT_EQ(seen.size(), 1u) << display;
  }
}

TEST_F(ProgramRender, SameVisibilityOnEveryInstructionSet) {
  std::set<std::string> seen;
  for (const std::string& target : simd_targets()) {
    const json f = figures({"--display", "none", "--size", "320x240", "--simd", target});
    EXPECT_EQ(f["simd"], target);
    seen.insert(f["visibility_hash"].get<std::string>());
  }
  EXPECT_EQ(seen.size(), 1u);
}

TEST_F(ProgramRender, OnePixelIsAPicture) {
  for (const char* display : {"none", "vga-colour"}) {
    const Image<Srgb8> p = picture({"--display", display, "--size", "1x1"});
    EXPECT_EQ(p.width(), 1);
    EXPECT_EQ(p.height(), 1);
  }
}

TEST_F(ProgramRender, SixteenBitPng) {
  for (const char* display : {"none", "vga-colour"}) {
    picture({"--display", display, "--size", "64x48", "--depth", "16"});
    const std::string file = read_text(folder_ / "picture.png");
    EXPECT_EQ(file[24], 16) << display;  // bit depth in the IHDR chunk
  }
}

TEST_F(ProgramRender, SeveralModelsStandSideBySide) {
  write_text(
      folder_ / "tall.off",
      "OFF\n4 4 0\n0 0 0\n100 0 0\n50 0 90\n50 300 30\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n");
  const RunResult run = run_kinescope({"render", "model.obj", "tall.off", "model.obj", "--json",
                                       "--display", "none", "--size", "300x200", "-o", "a.png"},
                                      {.folder = folder_.path()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(parse_json(run.out)["triangles"], 12 + 4 + 12);
}

TEST_F(ProgramRender, StlStandsUpAlongZAndOthersAlongY) {
  // A spike from the origin along z.
  const std::string corners[] = {"-1 -1 0", "1 -1 0", "0 1 0", "0 0 20"};
  std::string stl = "solid spike\n", off = "OFF\n4 4 0\n-1 -1 0\n1 -1 0\n0 1 0\n0 0 20\n";
  for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    stl += "facet normal 0 0 0\nouter loop\n";
    off += "3";
    for (const int i : face) {
      stl += "vertex " + corners[i] + "\n";
      off += " " + std::to_string(i);
    }
    stl += "endloop\nendfacet\n";
    off += "\n";
  }
  const auto is_upright = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render",  name,          "--display", "none", "--size",
                                       "100x100", "--elevation", "0",         "-o",   "spike.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult result = run_kinescope(arguments, {.folder = folder_.path()});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const Image<Srgb8> p = read_image_file(folder_ / "spike.png");
    int rows = 0, columns = 0;
    for (int i = 0; i < 100; ++i) {
      bool in_row = false, in_column = false;
      for (int j = 0; j < 100; ++j) {
        in_row |= brightness(p.at(j, i)) > 10;
        in_column |= brightness(p.at(i, j)) > 10;
      }
      rows += in_row;
      columns += in_column;
    }
    return rows > 3 * columns;
  };
  write_text(folder_ / "spike.stl", stl + "endsolid spike\n");
  write_text(folder_ / "spike.off", off);
  EXPECT_TRUE(is_upright("spike.stl", {}));
  EXPECT_FALSE(is_upright("spike.off", {}));
  EXPECT_TRUE(is_upright("spike.off", {"--up", "0,0,1"}));
  EXPECT_TRUE(is_upright("spike.off", {"--up", "0,0,1", "--eye", "40,0,10", "--look", "0,0,10"}));
}

TEST_F(ProgramRender, TheCameraStandsAndLooksAsTold) {
  // Along z from afar: the cube's face fills 2 units of 2 * 9 * tan(10 degrees) = 3.17.
  const Image<Srgb8> p =
      picture({"--display", "none", "--size", "100x100", "--eye", "0,0,10", "--look", "0,0,0",
               "--up", "0,1,0", "--fov", "20", "--shading", "unlit"});
  int lit = 0;
  for (int x = 0; x < 100; ++x) lit += brightness(p.at(x, 50)) > 60;
  EXPECT_NEAR(lit, 63, 1);
  const Image<Srgb8> away =
      picture({"--display", "none", "--size", "10x10", "--eye", "0,0,10", "--look", "0,0,20"});
  EXPECT_EQ(mean_brightness(away), 0);
}

TEST_F(ProgramRender, WithoutADisplayOrANamePicturesGoToOut) {
  const RunResult result = run({"--size", "64x48"});
  EXPECT_THAT(result.err, HasSubstr("out/model.png"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/model.png"));
}

// A sanitizer would count its own memory, and take minutes over a quarter of a billion pixels.
#ifndef KINESCOPE_SANITIZED
TEST_F(ProgramRender, GreatestPictureWithinBoundedMemory) {
  const RunResult result = run_kinescope({"render", "model.obj", "--display", "none", "--size",
                                          "16384x16384", "--aa", "1", "--json", "--headless"},
                                         {.folder = folder_.path()});
  if (result.exit_code == 0) {
    EXPECT_LT(parse_json(result.out)["peak_memory_mib"].get<double>(), 4096);
  } else {
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("16384x16384"));
  }
}
#endif

}  // namespace
}  // namespace kinescope::test
