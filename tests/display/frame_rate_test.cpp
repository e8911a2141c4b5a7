// Any frame rate before an eye and before a camera: whole refreshes show neither band nor seam,
// shutters of another length show both.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/display/tube_fixtures.h"

namespace kinescope {
namespace {

constexpr int kWidth = 40, kHeight = 240, kMargin = 12;  // rows that the spot's edge reaches

struct Case {
  std::string mode, phosphor;
};

class FrameRate : public ::testing::TestWithParam<Case> {
 protected:
  FrameRate() : mode_(parse_mode(GetParam().mode)) {}

  /// A steady white tube, whose lines run into each other.
  RasterTube white_tube() {
    TubeSettings settings{mode_, GetParam().phosphor};
    settings.spot.sigma_mm = 0.9 * 198 / mode_.vertical.active;
    fill(buffer_, 0, kWhite);
    RasterTube tube(settings, kWidth, kHeight);
    now_ = std::ceil(0.4 / mode_.frame_period().count()) * mode_.frame_period();
    tube.expose(buffer_, now_, workers_);
    return tube;
  }
  /// Mean green light of each row between the margins, in the shutter's time average.
  std::vector<double> rows(RasterTube& tube, Seconds shutter) {
    now_ += shutter;
    const Image<LinearRgb>& light = tube.expose(buffer_, now_, workers_);
    std::vector<double> rows;
    for (int y = kMargin; y < kHeight - kMargin; ++y) {
      double sum = 0;
      for (int x = 10; x < 30; ++x) {
        const LinearRgb c = light.at(x, y);
        sum += static_cast<double>(c.g);
      }
      rows.push_back(sum / 20 / (shutter / mode_.frame_period()));
    }
    return rows;
  }
  void wait(RasterTube& tube, Seconds length) {
    now_ += length;
    tube.expose(buffer_, now_, workers_);
  }

  VideoMode mode_;
  FrameBuffer buffer_ = buffer_for(mode_, 1);
  Workers workers_{2};
  Seconds now_{0};
};

/// Brightest row over the darkest.
double band(const std::vector<double>& rows) {
  const auto [least, most] = std::minmax_element(rows.begin(), rows.end());
  return *most / std::max(*least, 1e-9);
}
/// The largest change of light over five rows, as a share of the mean.
double seam(const std::vector<double>& rows) {
  double largest = 0, sum = 0;
  for (const double row : rows) sum += row;
  for (std::size_t i = 5; i < rows.size(); ++i) {
    largest = std::max(largest, std::abs(rows[i] - rows[i - 5]));
  }
  return largest / (sum / static_cast<double>(rows.size()));
}

TEST_P(FrameRate, AnEyeSeesNeitherBandNorSeam) {
  RasterTube tube = white_tube();
  // Wherever in the refresh it begins.
  for (const double phase : {0.0, 0.31, 0.5, 0.77, 0.999}) {
    wait(tube, phase * mode_.frame_period());
    const std::vector<double> seen = rows(tube, mode_.frame_period());
    EXPECT_LT(band(seen), 1.002) << phase;
    EXPECT_LT(seam(seen), 0.001) << phase;
    if (GetParam().phosphor == "P22") {
      EXPECT_NEAR(seen.front(), 1, 0.01) << phase;
    }
  }
}

TEST_P(FrameRate, ACamerasShutterShowsBandAndSeam) {
  RasterTube tube = white_tube();
  for (const double refreshes : {0.6, 1.4}) {
    const std::vector<double> seen = rows(tube, refreshes * mode_.frame_period());
    EXPECT_GT(band(seen), 1.25) << refreshes;
    EXPECT_GT(seam(seen), 0.1) << refreshes;
  }
}

/// The row at which light rises most.
int seam_row(const std::vector<double>& rows) {
  int at = 0;
  double most = 0;
  for (std::size_t i = 5; i < rows.size(); ++i) {
    const double rise = std::abs(rows[i] - rows[i - 5]);
    if (rise > most) most = rise, at = static_cast<int>(i) - 2;
  }
  return at + kMargin;
}

TEST_P(FrameRate, SeamsLieWhereTheBeamWasAsTheShutterMoved) {
  RasterTube tube = white_tube();
  int seen = 0;
  // A camera of another rate: each picture begins a seventh of a sweep later in the tube's.
  for (int picture = 0; picture < 7; ++picture) {
    const BeamPosition opened = tube.scan().at(now_);
    const int at = seam_row(rows(tube, 0.5 * mode_.field_period()));
    const BeamPosition closed = tube.scan().at(now_);
    wait(tube, (0.5 + 1.0 / 7) * mode_.field_period());
    if (opened.vertical != ScanPhase::kActive && closed.vertical != ScanPhase::kActive) continue;
    const double off =
        std::min(std::abs(at - opened.y * kHeight), std::abs(at - closed.y * kHeight));
    EXPECT_LT(off, 4) << picture << ": " << at;
    ++seen;
  }
  EXPECT_GT(seen, 4);
}

INSTANTIATE_TEST_SUITE_P(
    Rates, FrameRate,
    ::testing::Values(Case{"cvt:320x240@48", "P22"}, Case{"cvt:320x240@50", "P22"},
                      Case{"ntsc", "P22"}, Case{"pal", "P22"}, Case{"640x480@60", "P22"},
                      Case{"240p", "P4"}, Case{"cvt:320x240@60", "P31"},
                      Case{"gtf:640x480@75", "P22"}, Case{"cvtrb:320x240@100", "P22"},
                      Case{"cvt:320x240@120", "P22"}, Case{"cvt:320x240@240", "P22"},
                      Case{"cvt:320x240@240", "P31"},
                      Case{"Modeline \"odd\" 3.1 200 211 239 263 150 157 159 181", "P22"}),
    [](const auto& rate) {
      std::string name = rate.param.mode + rate.param.phosphor;
      std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
      return name;
    });

}  // namespace
}  // namespace kinescope
