// The tube against a brute-force one that steps every pixel through time on its own.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "display/layer_colours.h"
#include "tests/display/tube_fixtures.h"

namespace kinescope {
namespace {

constexpr int kStepsAClock = 16;  // windows begin and end on these
constexpr int kSubsteps = 8;      // of each, for terms that fade within one

/// 5x3 pixels in 9x5 clocks, 240 frames a second; its second field has one line.
VideoMode speck_mode(bool interlaced) {
  VideoMode mode;
  mode.name = "speck";
  mode.horizontal = {5, 1, 2, 1};
  mode.vertical = {3, 1, 1, 0};
  mode.interlaced = interlaced;
  mode.pixel_clock_hz = 9 * 5 * 240;
  return mode;
}

/// One cell of one phosphor: what each term holds, moved on in small steps.
class SteppedCell {
 public:
  SteppedCell(const Phosphor& phosphor, double step_s) {
    for (const DecayTerm& term : phosphor.terms) {
      terms_.push_back({term.share, std::exp(-step_s / term.tau.count()),
                        std::exp(-0.5 * step_s / term.tau.count()), 0});
    }
  }
  /// Light of kSubsteps steps in which `dose` falls on the cell, a part in the middle of each.
  double step(double dose) {
    double light = 0;
    for (int i = 0; i < kSubsteps; ++i) light += substep(dose / kSubsteps);
    return light;
  }

 private:
  double substep(double dose) {
    double light = 0;
    for (Term& term : terms_) {
      const double fresh = dose * term.share;
      light += term.held * (1 - term.decay) + fresh * (1 - term.half_decay);
      term.held = term.held * term.decay + fresh * term.half_decay;
    }
    return light;
  }

  struct Term {
    double share, decay, half_decay, held;
  };
  std::vector<Term> terms_;
};

/// The clock of a frame at which a cell's dwell begins, from the scan's definition alone.
int start_clock(const VideoMode& mode, int x, int y) {
  const int field_lines = (mode.vertical.total() + 1) / 2;
  const int line = mode.interlaced ? y / 2 + (y % 2) * field_lines : y;
  return line * mode.horizontal.total() + x;
}

class SteppedTube {
 public:
  SteppedTube(const VideoMode& mode, const std::string& name)
      : mode_(mode), type_(find_phosphor(name)), layers_(type_.layers) {
    const double step_s = 1 / mode.pixel_clock_hz / kStepsAClock / kSubsteps;
    for (int i = 0; i < mode.horizontal.active * mode.vertical.active; ++i) {
      for (const Phosphor& phosphor : layers_) cells_.emplace_back(phosphor, step_s);
    }
    latched_.resize(cells_.size());
  }

  /// Each layer's light a cell in [now, end), in steps.
  std::vector<double> expose(const FrameBuffer& buffer, int end_step) {
    std::vector<double> light(cells_.size(), 0.0);
    const int frame_steps = mode_.horizontal.total() * mode_.vertical.total() * kStepsAClock;
    for (; now_ < end_step; ++now_) {
      std::size_t i = 0;
      for (int y = 0; y < mode_.vertical.active; ++y) {
        for (int x = 0; x < mode_.horizontal.active; ++x) {
          const int since = now_ % frame_steps - start_clock(mode_, x, y) * kStepsAClock;
          const bool beam = since >= 0 && since < kStepsAClock;
          const std::uint32_t colour = buffer.pixel(0, x, y);
          for (std::size_t layer = 0; layer < layers_.size(); ++layer, ++i) {
            // The controller holds a pixel once it has read it.
            if (since == 0) latched_[i] = dose(colour, layer);
            light[i] += cells_[i].step(beam ? latched_[i] / kStepsAClock : 0);
          }
        }
      }
    }
    return light;
  }
  std::size_t layers() const { return layers_.size(); }
  const PhosphorType& type() const { return type_; }

 private:
  double dose(std::uint32_t colour, std::size_t layer) const {
    const auto gun = [&](std::uint32_t shift) {
      return static_cast<double>(colour >> shift & 255);
    };
    const double drive = type_.colour
                             ? gun(layer == 0   ? 16
                                   : layer == 1 ? 8
                                                : 0)
                             : std::floor((77 * gun(16) + 150 * gun(8) + 29 * gun(0) + 128) / 256);
    return std::pow(drive / 255, 2.35);
  }

  VideoMode mode_;
  const PhosphorType& type_;
  std::span<const Phosphor> layers_;
  std::vector<SteppedCell> cells_;
  std::vector<double> latched_;  // doses
  int now_ = 0;
};

/// The largest channel-wise difference, as a share of what the reference has (of white, where it
/// has less than a thousandth of that).
double largest_difference(const Image<LinearRgb>& picture, const SteppedTube& stepped,
                          const std::vector<double>& light, double white) {
  const auto colours = layer_colours(stepped.type());
  double largest = 0;
  for (std::size_t cell = 0; cell < picture.pixels().size(); ++cell) {
    double want[3] = {}, scale[3] = {};
    for (std::size_t layer = 0; layer < stepped.layers(); ++layer) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double part = light[cell * stepped.layers() + layer] * colours[layer][c];
        want[c] += part;
        scale[c] += std::abs(part);
      }
    }
    const LinearRgb p = picture.pixels()[cell];
    const double got[3] = {p.r, p.g, p.b};
    for (int c = 0; c < 3; ++c) {
      largest = std::max(largest, std::abs(got[c] - want[c]) / std::max(scale[c], 1e-3 * white));
    }
  }
  return largest;
}

class TubeReference : public ::testing::TestWithParam<std::pair<const char*, bool>> {};

TEST_P(TubeReference, LightOfEveryCellAgreesInAnyWindow) {
  const auto [phosphor, interlaced] = GetParam();
  const VideoMode mode = speck_mode(interlaced);
  FrameBuffer buffer = buffer_for(mode);
  fill_random(buffer, 0, 9);
  RasterTube tube = cell_tube(mode, phosphor);
  SteppedTube stepped(mode, phosphor);
  Workers workers(1);
  const int frame_steps = 45 * kStepsAClock;
  // Whole frames, parts of a line and of a pixel, across lines, across frames.
  int end = 0;
  for (const int length :
       {3 * frame_steps, 16 * 17 + 5, 3, 1, 9, 16 * 3, 16 * 9 + 2, frame_steps - 7, frame_steps,
        16 * 20 + 8, 5 * frame_steps + 16 * 13 + 4, 16 * 11}) {
    end += length;
    const Image<LinearRgb>& picture = tube.expose(
        buffer, Seconds(static_cast<double>(end) / kStepsAClock / mode.pixel_clock_hz), workers);
    const std::vector<double> light = stepped.expose(buffer, end);
    const double white = static_cast<double>(length) / frame_steps;
    ASSERT_LT(largest_difference(picture, stepped, light, white), 1e-3)
        << phosphor << " to step " << end << " of " << kStepsAClock << " a clock";
    if (length > 16) buffer.set_pixel(0, end % 5, end % 3, 0xffffff);
  }
}

INSTANTIATE_TEST_SUITE_P(Tubes, TubeReference,
                         ::testing::Values(std::pair{"P22", false}, std::pair{"P22", true},
                                           std::pair{"P1", false}, std::pair{"P31", true},
                                           std::pair{"P4", false}, std::pair{"P7", false},
                                           std::pair{"P14", true}));

}  // namespace
}  // namespace kinescope
