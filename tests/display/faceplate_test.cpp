// The front of the tube against sums over every cell and pixel, taken one by one.
#include "display/tube/faceplate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "display/tube/deflection.h"
#include "display/tube/spot.h"
#include "tests/display/tube_fixtures.h"

namespace kinescope {
namespace {

constexpr int kCells = 48, kLines = 36, kWidth = 168, kHeight = 126;

TubeSettings small_tube() {
  TubeSettings settings;
  settings.mode.name = "small";
  settings.mode.horizontal = {kCells, 4, 6, 6};
  settings.mode.vertical = {kLines, 1, 2, 2};
  settings.mode.pixel_clock_hz = 64 * 41 * 60;
  settings.glass.diagonal_mm = 30;  // 24 by 18 mm: cells and lines half a millimetre apart
  settings.spot.sigma_mm = 0.16;
  return settings;
}

const FaceplateLayer kLayers[3] = {{0, {1, 0, 0}}, {1, {0, 1, 0}}, {2, {0, 0, 1}}};

/// Random currents, as each gun's two Gaussians draw them.
std::vector<LayerLight> random_light(const SpotModel& spot, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<LayerLight> light;
  for (int gun = 0; gun < 3; ++gun) {
    LayerLight layer{{kCells, kLines}, {kCells, kLines}};
    for (int line = 0; line < kLines; ++line) {
      for (int cell = 0; cell < kCells; ++cell) {
        const double current = uniform(random) < 0.3 ? 1 : 0;
        const double wide = spot.wide_part(current);
        layer.narrow.line(line)[cell] = static_cast<float>(current - wide);
        layer.wide.line(line)[cell] = static_cast<float>(wide);
      }
    }
    light.push_back(std::move(layer));
  }
  return light;
}

/// One gun's light at a place of the picture, in output pixels: each cell is swept in small steps,
/// each step a Gaussian about the place where it lands.
class StepReference {
 public:
  StepReference(const TubeSettings& settings, int gun) : settings_(settings), spot_(settings.spot) {
    const Deflection deflection(settings.deflection, settings.glass, gun);
    const GlassCamera camera(settings.glass);
    for (int line = 0; line < kLines; ++line) {
      for (int step = 0; step < kCells * kSteps; ++step) {
        const Place sweep{(step + 0.5) / (0.5 * kCells * kSteps) - 1,
                          (line + 0.5) / (0.5 * kLines) - 1};
        landings_.push_back(picture_of_glass(camera, deflection.glass_of_sweep(sweep)));
      }
    }
  }

  double light(const LayerLight& layer, double x, double y) const {
    const PixelsAMm pixels = pixels_a_mm(settings_.glass, kWidth, kHeight);
    double sum = 0;
    for (const bool wide : {false, true}) {
      const double mm = wide ? spot_.wide_mm() : spot_.narrow_mm();
      // A pixel's own width is a twelfth of variance.
      const double across =
          std::sqrt(std::pow(mm * pixels.across * spot_.astigmatism(), 2) + 1.0 / 12);
      const double down = std::sqrt(std::pow(mm * pixels.down, 2) + 1.0 / 12);
      for (int line = 0; line < kLines; ++line) {
        const float* row = (wide ? layer.wide : layer.narrow).line(line);
        for (int step = 0; step < kCells * kSteps; ++step) {
          const Place at = landings_[static_cast<std::size_t>(line * kCells * kSteps + step)];
          const double dx = (at.x - x) / across, dy = (at.y - y) / down;
          if (std::abs(dx) > 5 || std::abs(dy) > 5) continue;
          sum += static_cast<double>(row[step / kSteps]) / kSteps *
                 std::exp(-0.5 * (dx * dx + dy * dy)) / (2 * std::numbers::pi * across * down);
        }
      }
    }
    // White is one dose a cell: as many pixels of light as a cell has area.
    return sum * kWidth * kHeight / (kCells * kLines) * settings_.deflection.width *
           settings_.deflection.height;
  }

 private:
  static constexpr int kSteps = 8;

  /// Inverts the camera by bisection along the ray from the picture's middle.
  static Place picture_of_glass(const GlassCamera& camera, Place glass) {
    double low = 0, high = 2;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      const Place seen = camera.glass_of_picture({glass.x * middle, glass.y * middle});
      (std::hypot(seen.x, seen.y) < std::hypot(glass.x, glass.y) ? low : high) = middle;
    }
    return {0.5 * (glass.x * low + 1) * kWidth, 0.5 * (glass.y * low + 1) * kHeight};
  }

  TubeSettings settings_;
  SpotModel spot_;
  std::vector<Place> landings_;  // of every step, output pixels
};

/// The largest difference from the reference, white being 1, over a sample of pixels.
double largest_difference(const TubeSettings& settings) {
  const std::vector<LayerLight> light = random_light(SpotModel(settings.spot), 7);
  Faceplate faceplate(settings, kLayers, kWidth, kHeight);
  Workers workers(2);
  Image<LinearRgb> picture;
  faceplate.show(light, workers, picture);
  double largest = 0;
  for (int gun = 0; gun < 3; ++gun) {
    const StepReference reference(settings, gun);
    for (int y = 1; y < kHeight; y += 8) {
      for (int x = 1; x < kWidth; x += 5) {
        const LinearRgb p = picture.at(x, y);
        const double got = static_cast<double>(gun == 0 ? p.r : gun == 1 ? p.g : p.b);
        const double want = reference.light(light[static_cast<std::size_t>(gun)], x + 0.5, y + 0.5);
        largest = std::max(largest, std::abs(got - want));
      }
    }
  }
  return largest;
}

TEST(Faceplate, StraightRasterAgreesWithSteps) {
  TubeSettings settings = small_tube();
  EXPECT_LT(largest_difference(settings), 0.01);
  settings.deflection.width = 0.9;
  settings.deflection.shift_y = 0.05;
  settings.deflection.convergence[0].x_mm = 0.3;
  settings.deflection.convergence[2].y_mm = -0.2;
  EXPECT_LT(largest_difference(settings), 0.012);
}

TEST(Faceplate, CurvedRasterAgreesWithSteps) {
  TubeSettings settings = small_tube();
  settings.deflection.pincushion_x = 0.03;
  settings.deflection.pincushion_y = 0.02;
  EXPECT_LT(largest_difference(settings), 0.02);
  settings.deflection.convergence[0].edge_x_mm = 0.1;
  settings.deflection.convergence[2].edge_y_mm = 0.1;
  EXPECT_LT(largest_difference(settings), 0.02);
  settings.glass.curvature_mm = 60;
  settings.glass.distance_mm = 60;
  EXPECT_LT(largest_difference(settings), 0.03);
}

TEST(Faceplate, ACurvedRasterOutOfFocusAgreesWithSteps) {
  for (const double focus : {1.7, 2.2, 4.0}) {  // a half to more than a line wide
    TubeSettings settings = small_tube();
    settings.spot.focus = focus;
    settings.deflection.rotation_deg = 1e-6;  // as good as straight
    EXPECT_LT(largest_difference(settings), 0.01) << focus;
    settings.deflection.pincushion_x = 0.03;
    settings.deflection.pincushion_y = 0.02;
    settings.deflection.convergence[0].edge_x_mm = 0.1;
    EXPECT_LT(largest_difference(settings), 0.01) << focus;
  }
}

TEST(Faceplate, PhotographsAreTheEncodedLight) {
  TubeSettings settings = small_tube();
  settings.glass.halation = 0.1;
  settings.glass.halation_mm = 1;
  settings.glass.ambient = 0.01;
  settings.mask.kind = MaskKind::kGrille;
  settings.mask.pitch_mm = 1;
  const std::vector<LayerLight> light = random_light(SpotModel(settings.spot), 3);
  Faceplate faceplate(settings, kLayers, kWidth, kHeight);
  Workers workers(1);
  Image<LinearRgb> picture;
  faceplate.show(light, workers, picture);
  Image<Srgb8> photograph(kWidth + 7, kHeight + 5);
  faceplate.photograph(light, workers, 0.7f, photograph, 4, 3);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const LinearRgb p = picture.at(x, y);
      const Srgb8 got = photograph.at(x + 4, y + 3);
      const auto code = [](float v) {
        return static_cast<int>(encode_srgb8(LinearRgb{0.7f * v, 0, 0}).r);
      };
      ASSERT_NEAR(got.r, code(p.r), 1);
      ASSERT_NEAR(got.g, code(p.g), 1);
      ASSERT_NEAR(got.b, code(p.b), 1);
      ASSERT_EQ(got.a, 255);
    }
  }
  EXPECT_EQ(photograph.at(3, 3), Srgb8{});
}

TEST(Faceplate, HalationTakesFromALightAndGivesToItsSurroundings) {
  TubeSettings settings = small_tube();
  settings.glass.halation_mm = 1.5;
  std::vector<LayerLight> light;
  for (int gun = 0; gun < 3; ++gun) light.push_back({{kCells, kLines}, {kCells, kLines}});
  for (int line = 16; line < 20; ++line) {
    for (int cell = 20; cell < 28; ++cell) light[1].narrow.line(line)[cell] = 1;
  }
  Workers workers(2);
  const auto sum_and_corner = [&](double share) {
    settings.glass.halation = share;
    Faceplate faceplate(settings, kLayers, kWidth, kHeight);
    Image<LinearRgb> picture;
    faceplate.show(light, workers, picture);
    double sum = 0;
    for (const LinearRgb& p : picture.pixels()) sum += static_cast<double>(p.g);
    return std::pair(sum, static_cast<double>(picture.at(84, 42).g));  // 14 pixels above the light
  };
  const auto [plain, dark] = sum_and_corner(0);
  const auto [glowing, lit] = sum_and_corner(0.2);
  EXPECT_NEAR(glowing, plain, 0.02 * plain);
  EXPECT_LT(dark, 1e-6);
  EXPECT_GT(lit, 1e-3);
}

/// The picture of one lit cell: how much light, and where its middle lies, output pixels.
struct Blob {
  double light = 0, x = 0;
};
Blob blob_of_cell(const TubeSettings& settings, int cell, int width, int height) {
  std::vector<LayerLight> light;
  for (int gun = 0; gun < 3; ++gun) {
    light.push_back({{kCells, kLines}, {kCells, kLines}});
    light.back().narrow.line(kLines / 2)[cell] = 1;
  }
  Workers workers(1);
  Image<LinearRgb> picture;
  Faceplate(settings, kLayers, width, height).show(light, workers, picture);
  Blob blob;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      blob.light += static_cast<double>(picture.at(x, y).g);
      blob.x += static_cast<double>(picture.at(x, y).g) * (x + 0.5);
    }
  }
  blob.x /= blob.light;
  return blob;
}

TEST(Faceplate, ACurvedPictureWithFewerPixelsThanTheLineHasCellsLosesNone) {
  TubeSettings settings = small_tube();
  settings.deflection.rotation_deg = 1e-6;  // as good as straight
  for (const int width : {44, 40, 32, 24}) {
    for (int cell = 4; cell < kCells - 4; ++cell) {
      const Blob blob = blob_of_cell(settings, cell, width, kHeight);
      const double pixels = static_cast<double>(width * kHeight) / (kCells * kLines);
      EXPECT_NEAR(blob.light, pixels, 0.1 * pixels) << width << " " << cell;
      EXPECT_NEAR(blob.x, (cell + 0.5) * width / kCells, 0.15) << width << " " << cell;
    }
  }
}

}  // namespace
}  // namespace kinescope
