// A picture of each demo as it was judged good by eye. KINESCOPE_UPDATE_GOLDEN=1 (or
// scripts/update-golden) writes them anew: look at each before committing it.
#include <cstdlib>
#include <ostream>
#include <string>

#include "demo_testing.h"
#include "demos/session.h"
#include "raster/image/codecs.h"

namespace kinescope {
namespace {

// Colours may differ by 1/255 between instruction sets, and a tube's gain widens that a little.
constexpr int kCodes = 3;
constexpr double kShare = 0.002;

Image<Srgb8> render(std::string_view name, std::int64_t frame, const std::string& script) {
  DemoFilm film;
  film.first_frame = film.last_frame = frame;
  film.script = InputScript::parse(script, "golden");
  Image<Srgb8> result;
  render_demo(find_demo(name), {320, 240, 1, 2}, film,
              [&](std::int64_t, const Image<Srgb8>& picture) {
                result = picture;
                return true;
              });
  return result;
}

bool differs(Srgb8 a, Srgb8 b) {
  return std::abs(a.r - b.r) > kCodes || std::abs(a.g - b.g) > kCodes ||
         std::abs(a.b - b.b) > kCodes;
}

/// The share of pixels that differ by more than the tolerance; 1 if the sizes do.
double difference(const Image<Srgb8>& a, const Image<Srgb8>& b) {
  if (a.width() != b.width() || a.height() != b.height()) return 1;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    count += differs(a.pixels()[i], b.pixels()[i]);
  return static_cast<double>(count) / static_cast<double>(a.pixels().size());
}

struct Golden {
  std::string file, demo;
  std::int64_t frame;
  std::string script;
};

void PrintTo(const Golden& golden, std::ostream* out) { *out << golden.file; }

class GoldenPicture : public ::testing::TestWithParam<Golden> {};

TEST_P(GoldenPicture, IsStillDrawn) {
  const Golden& golden = GetParam();
  const std::string path = KINESCOPE_SOURCE_DIR "/tests/golden/" + golden.file + ".png";
  const Image<Srgb8> now = render(golden.demo, golden.frame, golden.script);
  if (std::getenv("KINESCOPE_UPDATE_GOLDEN") != nullptr) {
    write_png(path, now);
    GTEST_SKIP() << "wrote " << path;
  }
  const double share = difference(now, read_image_file(path));
  if (share > kShare) write_png(::testing::TempDir() + golden.file + ".png", now);
  EXPECT_LE(share, kShare) << "the picture as it is now: " << ::testing::TempDir() << golden.file
                           << ".png";
}

INSTANTIATE_TEST_SUITE_P(
    Demos, GoldenPicture,
    ::testing::Values(
        Golden{"teapot", "teapot", 8, ""},
        Golden{"teapot-wireframe", "teapot", 4, "0 key w\n0 key d\n"},
        Golden{"retrace", "retrace", 40, "2 key ]\n2 key ]\n2 key ]\n2 key ]\n"},
        Golden{"frame-buffer", "frame-buffer", 6, "1 key Left\n1 key Left\n1 key Left\n"},
        Golden{"frame-buffer-torn", "frame-buffer", 20, "0 key 3\n0 key f\n"},
        Golden{"phosphors", "phosphors", 30, "0 key t\n0 key t\n"},
        Golden{"pipeline", "pipeline", 3, ""},
        Golden{"test-patterns", "test-patterns", 5, "0 key m\n"},
        Golden{"tube", "tube", 5, "0 key F5\n0 key d\n0 key d\n0 key m\n0 key j\n"},
        Golden{"tube-close", "tube", 5, "0 key z\n0 key z\n"}, Golden{"masks", "masks", 3, ""},
        Golden{"sync", "sync", 30, ""}, Golden{"light-pen-raster", "light-pen-raster", 40, ""},
        Golden{"polygon-clipping", "polygon-clipping", 3, "1 key End\n"},
        Golden{"text-clipping", "text-clipping", 3, "1 key End\n"},
        Golden{"curve-clipping", "curve-clipping", 3, "1 key End\n"},
        Golden{"window-to-viewport", "window-to-viewport", 3, "1 key End\n"},
        Golden{"viewing-steps", "viewing-steps", 3, "1 key End\n"},
        Golden{"view-confusion", "view-confusion", 3, "0 key 3\n0 key c\n1 key End\n"},
        Golden{"transformations-3d", "transformations-3d", 3, "0 key o\n1 key End\n"},
        Golden{"planes-and-normals", "planes-and-normals", 3, "1 key End\n"},
        Golden{"practical-5", "practical-5", 3, "1 key End\n"},
        Golden{"practical-6", "practical-6", 3, "1 key End\n"},
        Golden{"practical-11", "practical-11", 30, "0 key 2\n0 key k\n0 key k\n"},
        Golden{"practical-12", "practical-12", 60, "0 key g\n"},
        Golden{"splines", "splines", 4, "1 key End\n"},
        Golden{"continuity", "continuity", 4, "0 key k\n1 key End\n"},
        Golden{"nurbs", "nurbs", 4, "0 key 3\n1 key End\n"},
        Golden{"curve-properties", "curve-properties", 4, "1 key End\n"},
        Golden{"iterated-functions", "iterated-functions", 4, "0 key 2\n1 key End\n"},
        Golden{"gaskets", "gaskets", 4, "1 key End\n"},
        Golden{"generator-curves", "generator-curves", 4, "1 key End\n"},
        Golden{"plasma", "plasma", 4, "1 key End\n"},
        Golden{"brownian", "brownian", 4, "1 key End\n"},
        Golden{"aggregation", "aggregation", 4, "1 key End\n"},
        Golden{"coastline", "coastline", 4, "1 key End\n"},
        Golden{"fractal-compression", "fractal-compression", 4, "1 key End\n"},
        Golden{"self-similarity", "self-similarity", 4, "1 key End\n"},
        Golden{"mandelbrot", "mandelbrot", 4, "0 key Home\n1 key End\n2 key End\n3 key End\n"}),
    [](const auto& golden) {
      std::string name = golden.param.file;
      std::erase(name, '-');
      return name;
    });

// Lessons of chapters 1, 2, 3 and 8 at their courses' ends.
INSTANTIATE_TEST_SUITE_P(
    Lessons, GoldenPicture,
    ::testing::Values(Golden{"lines", "lines", 4, "1 key End\n"},
                      Golden{"circles", "circles", 4, "1 key End\n"},
                      Golden{"conics", "conics", 4, "0 key 5\n1 key End\n"},
                      Golden{"strokes", "strokes", 4, "1 key End\n"},
                      Golden{"inside-tests", "inside-tests", 4, "1 key End\n"},
                      Golden{"seed-fill", "seed-fill", 4, "1 key End\n"},
                      Golden{"scanline-fill", "scanline-fill", 4, "1 key End\n"},
                      Golden{"areas", "areas", 4, "1 key End\n"},
                      Golden{"characters", "characters", 4, "1 key End\n"},
                      Golden{"antialiasing", "antialiasing", 4, "1 key End\n"},
                      // Of the photograph, diffusion spreads what instruction sets round apart.
                      Golden{"dithering", "dithering", 4, "0 key p\n1 key End\n"},
                      Golden{"transformations", "transformations", 4, "1 key End\n"},
                      Golden{"samples", "samples", 4, "1 key End\n"},
                      Golden{"coordinates", "coordinates", 4, "1 key End\n"},
                      Golden{"cad-part", "cad-part", 4, "1 key End\n"},
                      Golden{"charts", "charts", 4, "0 key 3\n1 key End\n"},
                      Golden{"enhancement", "enhancement", 4, "1 key End\n"},
                      Golden{"dithering-palette", "dithering", 4, "0 key i\n1 key End\n"},
                      Golden{"paint", "paint", 9,
                             "1 key 2\n1 drag 40 40 90 70 4\n6 key 6\n6 drag 40 90 60 100 2\n"},
                      Golden{"windows", "windows", 9,
                             "1 drag 45 50 60 120 4\n7 click 150 50 right\n"},
                      Golden{"display-file", "display-file", 9, "0 key -\n0 drag 40 60 280 60 4\n"},
                      Golden{"rubber-band", "rubber-band", 9, "0 drag 100 60 220 130 20\n"},
                      Golden{"light-pen", "light-pen", 9, "0 drag 92 87 140 100 20\n"},
                      Golden{"spacewar", "spacewar", 30, "0 key f\n0 key w\n0 key Left\n"},
                      Golden{"oscilloscope", "oscilloscope", 9, "0 key 2\n0 key =\n"},
                      Golden{"storage", "storage", 40, "0 key l\n0 key l\n39 key h\n"},
                      Golden{"wireframe", "wireframe", 4, "0 key -\n"},
                      Golden{"four-operations", "four-operations", 9, ""}),
    [](const auto& golden) {
      std::string name = golden.param.file;
      std::erase(name, '-');
      return name;
    });

TEST(GoldenComparison, SeesADifferenceAndForgivesATrifle) {
  Image<Srgb8> a(100, 100, {90, 90, 90, 255}), b = a;
  for (int i = 0; i < 100; ++i) b.at(i, 5).g = 93;
  EXPECT_EQ(difference(a, b), 0);
  for (int i = 0; i < 21; ++i) b.at(i, 5).g = 94;
  EXPECT_GT(difference(a, b), kShare);
  EXPECT_EQ(difference(a, Image<Srgb8>(100, 99)), 1);
}

}  // namespace
}  // namespace kinescope
