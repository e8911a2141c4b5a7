#include "display/tube/screen.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "display/tube/axis_weights.h"
#include "display/tube/beam_map.h"
#include "display/tube/deflection.h"
#include "display/tube/halation.h"
#include "display/tube/shadow_mask.h"
#include "display/tube/spot.h"

namespace kinescope {
namespace {

constexpr int kTileColumns = 240, kTileRows = 270;
constexpr int kCurvedTileColumns = 96;
constexpr double kPixelVariance = 1.0 / 12;  // of an output pixel's own width
constexpr int kMostLayers = 3;

/// How one gun's raster lies under the output's pixels, where its axes are apart.
struct StraightRaster {
  AxisWeights across, down;
  bool close = false;
};

bool starts_are_close(const AxisWeights& across) {
  for (std::size_t x = 0; x + kGroup <= across.start.size(); x += kGroup) {
    if (across.start[x + kGroup - 1] - across.start[x] >= kGroup) return false;
  }
  return true;
}

/// Tells where a picture's pixels begin and end along one axis of the sweep, in cells.
std::vector<double> pixel_edges(int pixels, int cells, const std::function<double(double)>& sweep) {
  std::vector<double> edges;
  for (int i = 0; i <= pixels; ++i)
    edges.push_back(0.5 * (sweep(2.0 * i / pixels - 1) + 1) * cells);
  return edges;
}

/// Work space of one worker: lines spread over a tile's columns, in rings, and rows on their way.
struct Scratch {
  std::array<std::vector<float>, kMostLayers> narrow, wide, row;
  std::array<int, kMostLayers> next_line{};
  std::vector<float> line_at, pitch;
  std::vector<const float*> narrow_rows, wide_rows;
  std::vector<float> narrow_weight, wide_weight;
};

}  // namespace

struct Screen::State {
  State(const TubeSettings& s, std::span<const ScreenLayer> its_layers, int w, int h);

  void lay_straight(int gun);
  void draw(std::span<const LayerLight> light, Workers& workers,
            const std::function<void(const FinishRow&, int x, int y, int n)>& finish);
  void begin_tile(Scratch& s, int groups) const;
  void spread_row(std::span<const LayerLight> light, std::size_t layer, Scratch& s, int x, int y,
                  int groups) const;
  void spread_straight_row(const LayerLight& light, std::size_t layer, Scratch& s, int x, int y,
                           int groups) const;
  void spread_curved_row(const LayerLight& light, std::size_t layer, Scratch& s, int x, int y,
                         int groups) const;
  FinishRow finish_row(const Scratch& s, int x, int y) const;

  const StraightRaster& straight_of(std::size_t layer) const {
    return straight[static_cast<std::size_t>(layers[layer].gun)];
  }
  const BeamMap& map_of(std::size_t layer) const {
    return maps[static_cast<std::size_t>(layers[layer].gun)];
  }
  int ring_lines(std::size_t layer) const {
    return curved ? map_of(layer).ring_lines : straight_ring;
  }

  TubeSettings settings;
  std::vector<ScreenLayer> layers;
  int width, height, cells, lines;
  bool curved;
  SpotModel spot;
  double pixels_a_mm_x, pixels_a_mm_y;
  std::vector<StraightRaster> straight;  // a gun each
  std::vector<BeamMap> maps;
  int straight_ring = 0;
  ShadowMask mask;
  Halation halation;
  std::vector<Scratch> scratch;
};

Screen::State::State(const TubeSettings& s, std::span<const ScreenLayer> its_layers, int w, int h)
    : settings(s),
      layers(its_layers.begin(), its_layers.end()),
      width(w),
      height(h),
      cells(s.mode.horizontal.active),
      lines(s.mode.vertical.active),
      curved(!is_separable(s)),
      spot(s.spot) {
  const double height_mm = s.glass.diagonal_mm / std::hypot(s.glass.aspect, 1.0);
  pixels_a_mm_x = w / (height_mm * s.glass.aspect);
  pixels_a_mm_y = h / height_mm;
  int guns = 0;
  for (const ScreenLayer& layer : layers) guns = std::max(guns, layer.gun + 1);
  for (int gun = 0; gun < guns; ++gun) {
    if (curved) {
      maps.push_back(beam_map(s, gun, cells, lines, w, h, kCurvedTileColumns));
    } else {
      lay_straight(gun);
    }
  }
  if (guns == 3) mask = ShadowMask(s.mask, s.glass, w, h);
  halation = Halation(s, w, h);
}

void Screen::State::lay_straight(int gun) {
  const Deflection deflection(settings.deflection, settings.glass, gun);
  StraightRaster raster;
  const auto across = [&](double x) { return deflection.sweep_of_glass({x, 0}).x; };
  const auto down = [&](double y) { return deflection.sweep_of_glass({0, y}).y; };
  const double sigma[2] = {spot.narrow_mm(), spot.wide_mm()};
  const double x = pixels_a_mm_x * spot.astigmatism(), y = pixels_a_mm_y;
  raster.across = axis_weights(pixel_edges(width, cells, across), {sigma[0] * x, sigma[1] * x},
                               cells / (width * settings.deflection.width), true);
  raster.down = axis_weights(pixel_edges(height, lines, down), {sigma[0] * y, sigma[1] * y},
                             lines / (height * settings.deflection.height), false);
  // Rows far from the raster look at the dark cells beside it.
  for (int& start : raster.across.start) {
    start = std::clamp(start, -kCellPad, cells + kCellPad - kGroup - raster.across.taps);
  }
  raster.close = starts_are_close(raster.across);
  straight_ring = std::max(straight_ring, raster.down.taps);
  straight.push_back(std::move(raster));
}

void Screen::State::begin_tile(Scratch& s, int groups) const {
  const std::size_t columns = static_cast<std::size_t>(groups * kGroup);
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    const std::size_t ring = columns * static_cast<std::size_t>(ring_lines(layer));
    s.narrow[layer].resize(std::max(s.narrow[layer].size(), ring));
    s.wide[layer].resize(std::max(s.wide[layer].size(), ring));
    s.row[layer].resize(std::max(s.row[layer].size(), columns));
    s.next_line[layer] = -lines;
  }
}

/// Each line that the row needs is spread across once, into a ring of lines.
void Screen::State::spread_straight_row(const LayerLight& light, std::size_t layer, Scratch& s,
                                        int x, int y, int groups) const {
  const StraightRaster& raster = straight_of(layer);
  const int taps = raster.down.taps, columns = groups * kGroup;
  const int first = raster.down.start[static_cast<std::size_t>(y)];
  const auto ring_at = [&](int line) {
    return ((line % taps) + taps) % taps * static_cast<std::ptrdiff_t>(columns);
  };
  int& next = s.next_line[layer];
  for (next = std::max(next, first); next < first + taps; ++next) {
    float* const narrow = s.narrow[layer].data() + ring_at(next);
    float* const wide = s.wide[layer].data() + ring_at(next);
    if (next < 0 || next >= lines) {
      std::fill_n(narrow, columns, 0.0f);
      std::fill_n(wide, columns, 0.0f);
      continue;
    }
    const AxisWeights& across = raster.across;
    spread_across({across.start.data() + x, across.weight[0].data() + x,
                   across.weight[1].data() + x, across.taps, across.pitch, groups, raster.close},
                  {light.narrow.line(next), light.wide.line(next)}, {narrow, wide});
  }
  s.narrow_rows.clear();
  s.wide_rows.clear();
  s.narrow_weight.clear();
  s.wide_weight.clear();
  for (int t = 0; t < taps; ++t) {
    s.narrow_rows.push_back(s.narrow[layer].data() + ring_at(first + t));
    s.wide_rows.push_back(s.wide[layer].data() + ring_at(first + t));
    s.narrow_weight.push_back(raster.down.at(0, y, t));
    s.wide_weight.push_back(raster.down.at(1, y, t));
  }
  spread_down(groups, taps, s.narrow_rows.data(), s.wide_rows.data(), s.narrow_weight.data(),
              s.wide_weight.data(), s.row[layer].data());
}

void Screen::State::spread_curved_row(const LayerLight& light, std::size_t layer, Scratch& s, int x,
                                      int y, int groups) const {
  const BeamMap& map = map_of(layer);
  const int first_node = x / kGroup, columns = groups * kGroup;
  s.line_at.resize(static_cast<std::size_t>(groups + 1));
  s.pitch.resize(static_cast<std::size_t>(groups));
  map.at_row(y, first_node, groups + 1, s.line_at.data(), s.pitch.data());
  const auto [low, high] = std::minmax_element(s.line_at.begin(), s.line_at.end());
  const int first = static_cast<int>(std::floor(*low)) - kLineTaps / 2;
  const int last = static_cast<int>(std::floor(*high)) + kLineTaps / 2 + 1;
  const double variance_x = kPixelVariance,
               lines_a_pixel = lines / (height * settings.deflection.height);
  const auto pixels = [&](double mm, double pixels_a_mm, double variance) {
    return static_cast<float>(std::sqrt(mm * pixels_a_mm * mm * pixels_a_mm + variance));
  };
  const double variance_y =
      kPixelVariance + line_blur_variance(lines_a_pixel) / (lines_a_pixel * lines_a_pixel);
  const double across = pixels_a_mm_x * spot.astigmatism();
  int& next = s.next_line[layer];
  for (next = std::max(next, first); next <= last; ++next) {
    const std::ptrdiff_t at = (next & (map.ring_lines - 1)) * static_cast<std::ptrdiff_t>(columns);
    float* const narrow = s.narrow[layer].data() + at;
    float* const wide = s.wide[layer].data() + at;
    if (next < 0 || next >= lines) {
      std::fill_n(narrow, columns, 0.0f);
      std::fill_n(wide, columns, 0.0f);
      continue;
    }
    spread_across_curve(
        {map.cells_of(next) + first_node, groups, cells,
         static_cast<float>(cells / (width * settings.deflection.width)),
         pixels(spot.narrow_mm(), across, variance_x), pixels(spot.wide_mm(), across, variance_x)},
        {light.narrow.line(next), light.wide.line(next)}, {narrow, wide});
  }
  spread_down_curve({s.line_at.data(), s.pitch.data(), groups, static_cast<float>(lines_a_pixel),
                     pixels(spot.narrow_mm(), pixels_a_mm_y, variance_y),
                     pixels(spot.wide_mm(), pixels_a_mm_y, variance_y), s.narrow[layer].data(),
                     s.wide[layer].data(), map.ring_lines - 1, columns},
                    s.row[layer].data());
}

FinishRow Screen::State::finish_row(const Scratch& s, int x, int y) const {
  FinishRow row{};
  row.guns = static_cast<int>(layers.size());
  const float kept = 1 - halation.share();
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    row.light[layer] = s.row[layer].data();
    row.mask[layer] = mask.row(layers[layer].gun, y, x);
    halation.rows(layer, y, x, row.glow[layer], row.glow_below[layer], row.glow_share);
    for (std::size_t c = 0; c < 3; ++c) {
      row.colour[layer][c] =
          layers[layer].colour[c] * kept * static_cast<float>(settings.glass.tint[c]);
    }
  }
  for (float& a : row.ambient) a = static_cast<float>(settings.glass.ambient);
  return row;
}

void Screen::State::draw(std::span<const LayerLight> light, Workers& workers,
                         const std::function<void(const FinishRow&, int x, int y, int n)>& finish) {
  scratch.resize(static_cast<std::size_t>(workers.count()));
  halation.gather(light, workers);
  const int tile_columns = curved ? kCurvedTileColumns : kTileColumns;
  const int across = (width + tile_columns - 1) / tile_columns;
  const int down = (height + kTileRows - 1) / kTileRows;
  workers.run(across * down, [&](int task, int worker) {
    Scratch& s = scratch[static_cast<std::size_t>(worker)];
    const int x = task % across * tile_columns, top = task / across * kTileRows;
    const int n = std::min(tile_columns, width - x);
    const int groups = (n + kGroup - 1) / kGroup;
    begin_tile(s, groups);
    for (int y = top; y < std::min(height, top + kTileRows); ++y) {
      for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        if (curved) {
          spread_curved_row(light[layer], layer, s, x, y, groups);
        } else {
          spread_straight_row(light[layer], layer, s, x, y, groups);
        }
      }
      finish(finish_row(s, x, y), x, y, n);
    }
  });
}

Screen::Screen(const TubeSettings& settings, std::span<const ScreenLayer> layers, int width,
               int height)
    : state_(std::make_unique<State>(settings, layers, width, height)) {}
Screen::~Screen() = default;
Screen::Screen(Screen&&) noexcept = default;
Screen& Screen::operator=(Screen&&) noexcept = default;

void Screen::show(std::span<const LayerLight> light, Workers& workers, bool add,
                  Image<LinearRgb>& out) {
  if (out.width() != state_->width || out.height() != state_->height) {
    out = Image<LinearRgb>(state_->width, state_->height);
  }
  state_->draw(light, workers, [&](const FinishRow& row, int x, int y, int n) {
    finish_light(row, n, add, out.row(y) + x);
  });
}

void Screen::photograph(std::span<const LayerLight> light, Workers& workers, float gain,
                        Image<Srgb8>& out, int left, int top) {
  state_->draw(light, workers, [&](const FinishRow& row, int x, int y, int n) {
    finish_encoded(row, n, gain, out.row(top + y) + left + x);
  });
}

}  // namespace kinescope
