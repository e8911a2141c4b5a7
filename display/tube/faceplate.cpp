#include "display/tube/faceplate.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <utility>
#include <variant>

#include "display/tube/deflection.h"
#include "display/tube/finish_kernels.h"
#include "display/tube/free_sweep.h"
#include "display/tube/halation.h"
#include "display/tube/raster_spread.h"
#include "display/tube/shadow_mask.h"
#include "display/tube_kernels.h"

namespace kinescope {

using Raster = std::variant<StraightRaster, CurvedRaster>;

struct GunRasters {
  std::vector<Raster> of_gun;
  std::vector<std::size_t> alike;  // of each gun, the first one whose raster is the same
};

namespace {

constexpr int kTileRows = 270;

/// Work space of one worker.
struct Scratch {
  std::array<SpreadRing, kMostLayers> ring;
  std::array<AlignedVector<float>, kMostLayers> row;
};

using Finish = std::function<void(FinishRow&, int x, int y, int n)>;

/// Whether the camera sees the same glass.
bool one_shape(const GlassSettings& a, const GlassSettings& b) {
  return a.diagonal_mm == b.diagonal_mm && a.aspect == b.aspect &&
         a.curvature_mm == b.curvature_mm && a.distance_mm == b.distance_mm;
}
bool one_mask(const TubeSettings& a, const TubeSettings& b) {
  return one_shape(a.glass, b.glass) && a.mask == b.mask;
}
bool one_raster(const TubeSettings& a, const TubeSettings& b) {
  return one_shape(a.glass, b.glass) && a.mode == b.mode && a.spot == b.spot &&
         a.deflection == b.deflection && is_free(a) == is_free(b);
}

/// Lines of cells: of a free raster, of one sweep.
int lines_of(const TubeSettings& s) {
  return is_free(s) ? field_lines(s.mode) : s.mode.vertical.active;
}

/// Of a free raster, those of a sweep that lies where it should.
std::shared_ptr<const GunRasters> make_rasters(const TubeSettings& s, int guns, bool straight,
                                               int width, int height) {
  const RasterExtent extent{s.mode.horizontal.active, lines_of(s), width, height};
  const SpotModel spot(s.spot);
  GunRasters rasters;
  for (int gun = 0; gun < guns; ++gun) {
    if (straight) {
      rasters.of_gun.emplace_back(std::in_place_type<StraightRaster>, s, spot, gun, extent);
    } else {
      rasters.of_gun.emplace_back(std::in_place_type<CurvedRaster>, s, spot, gun, extent);
    }
    const auto& errors = s.deflection.convergence;
    const auto first =
        std::find(errors.begin(), errors.begin() + gun, errors[static_cast<std::size_t>(gun)]);
    rasters.alike.push_back(static_cast<std::size_t>(first - errors.begin()));
  }
  if (!straight) {
    // Guns whose lines lie alike are summed from rings of one size.
    for (Raster& a : rasters.of_gun) {
      for (const Raster& b : rasters.of_gun) {
        std::get<CurvedRaster>(a).widen_ring(std::get<CurvedRaster>(b));
      }
    }
  }
  return std::make_shared<const GunRasters>(std::move(rasters));
}

bool have_lines_alike(const std::vector<Raster>& rasters) {
  const auto* first = std::get_if<CurvedRaster>(&rasters.front());
  return first && std::all_of(rasters.begin(), rasters.end(), [&](const Raster& r) {
           return first->shares_lines_with(std::get<CurvedRaster>(r));
         });
}

}  // namespace

struct Faceplate::State {
  State(const TubeSettings& s, std::span<const FaceplateLayer> its_layers, int w, int h,
        const State* like);
  double draw(std::span<const LayerLight> light, Workers& workers, float gain,
              const Finish& finish);
  std::span<const LayerLight> blurred(std::span<const LayerLight> light, Workers& workers);
  void draw_tile(std::span<const LayerLight> light, Scratch& s, int x, int top, float gain,
                 const Finish& finish) const;
  void spread_row(std::span<const LayerLight> light, Scratch& s, int y) const;
  void add_overlay(Scratch& s, std::size_t layer, int x, int y, int n, bool alone) const;
  void spread(const Raster& raster, std::span<const Spread> lights, Workers& workers) const;
  void spread_tile(const Raster& raster, std::span<const Spread> lights, Scratch& s, int x,
                   int top) const;
  FinishRow finish_row(float gain) const;
  void set_row(FinishRow& row, const Scratch& s, int x, int y) const;
  const Raster& raster_of(std::size_t layer) const {
    return rasters->of_gun[rasters->alike[static_cast<std::size_t>(layers[layer].gun)]];
  }

  TubeSettings settings;
  std::vector<FaceplateLayer> layers;
  int width, height;
  int tile_columns;
  std::shared_ptr<const GunRasters> rasters;
  bool lines_alike = false;  // of all guns
  const std::vector<std::vector<float>>* overlay = nullptr;
  double refreshes = 1;
  std::shared_ptr<const ShadowMask> mask;
  Halation halation;
  std::vector<Scratch> scratch;
  std::vector<LayerLight> blurred_light;
};

Faceplate::State::State(const TubeSettings& s, std::span<const FaceplateLayer> its_layers, int w,
                        int h, const State* like)
    : settings(s), layers(its_layers.begin(), its_layers.end()), width(w), height(h) {
  int guns = 0;
  for (const FaceplateLayer& layer : layers) guns = std::max(guns, layer.gun + 1);
  const bool alike = like != nullptr && like->width == w && like->height == h &&
                     like->rasters->of_gun.size() == static_cast<std::size_t>(guns);
  const bool straight = is_separable(s) && !is_free(s);
  tile_columns = straight ? StraightRaster::kTileColumns : CurvedRaster::kTileColumns;
  rasters = alike && one_raster(like->settings, s) ? like->rasters
                                                   : make_rasters(s, guns, straight, w, h);
  lines_alike = have_lines_alike(rasters->of_gun);
  mask = alike && one_mask(like->settings, s)
             ? like->mask
             : std::make_shared<ShadowMask>(guns == 3 ? ShadowMask(s.mask, s.glass, w, h)
                                                      : ShadowMask());
  halation = Halation(s, w, h);
}

/// What all rows have in common.
FinishRow Faceplate::State::finish_row(float gain) const {
  FinishRow row;
  row.layers = static_cast<int>(layers.size());
  const float kept = (1 - halation.share()) * gain / mask->one();
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    for (std::size_t c = 0; c < 3; ++c) {
      row.colour[layer][c] =
          layers[layer].colour[c] * kept * static_cast<float>(settings.glass.tint[c]);
    }
  }
  for (float& a : row.ambient) a = gain * static_cast<float>(settings.glass.ambient * refreshes);
  return row;
}

void Faceplate::State::set_row(FinishRow& row, const Scratch& s, int x, int y) const {
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    row.light[layer] = s.row[layer].data();
    row.mask[layer] = mask->row(layers[layer].gun, y, x);
    row.mask_below[layer] = mask->row(layers[layer].gun, std::min(y + 1, height - 1), x);
    row.glow_share = halation.rows(layer, y, x, row.glow_above[layer], row.glow_below[layer]);
  }
}

void Faceplate::State::draw_tile(std::span<const LayerLight> light, Scratch& s, int x, int top,
                                 float gain, const Finish& finish) const {
  const int n = std::min(tile_columns, width - x), groups = (n + kGroup - 1) / kGroup;
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    s.row[layer].assign(static_cast<std::size_t>(tile_columns), 0.0f);
    if (light.empty()) continue;
    std::visit([&](const auto& raster) { raster.begin_tile(s.ring[layer], x, groups); },
               raster_of(layer));
  }
  FinishRow row = finish_row(gain);
  for (int y = top; y < std::min(height, top + kTileRows); ++y) {
    if (!light.empty()) spread_row(light, s, y);
    for (std::size_t layer = 0; overlay && layer < layers.size(); ++layer) {
      add_overlay(s, layer, x, y, n, light.empty());
    }
    set_row(row, s, x, y);
    finish(row, x, y, n);
  }
}

void Faceplate::State::spread_row(std::span<const LayerLight> light, Scratch& s, int y) const {
  if (!lines_alike) {
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
      std::visit(
          [&](const auto& raster) {
            raster.spread_row(light[layer], s.ring[layer], y, s.row[layer].data());
          },
          raster_of(layer));
    }
    return;
  }
  std::array<LineRows, kMostLayers> rows;
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    const CurvedRaster& raster = std::get<CurvedRaster>(raster_of(layer));
    SpreadRing& ring = s.ring[layer];
    raster.spread_lines(light[layer], ring, y);
    rows[layer] = {ring.narrow.data(), ring.wide.data(), s.row[layer].data()};
  }
  std::get<CurvedRaster>(raster_of(0)).lines_down(s.ring[0], y, {rows.data(), layers.size()});
}

/// @param alone whether no raster's light lies below it
void Faceplate::State::add_overlay(Scratch& s, std::size_t layer, int x, int y, int n,
                                   bool alone) const {
  const float* const over = (*overlay)[layer].data() + static_cast<std::ptrdiff_t>(y) * width + x;
  float* const row = s.row[layer].data();
  if (alone) std::fill_n(row, n, 0.0f);
  add_scaled(n, 1, over, row);
}

/// One row of a tile, of rasters that lie alike.
void spread_alike(const StraightRaster& raster, std::span<const Faceplate::Spread> lights, int y,
                  Scratch& s) {
  for (std::size_t i = 0; i < lights.size(); ++i) {
    raster.spread_row(*lights[i].light, s.ring[i], y, s.row[i].data());
  }
}
void spread_alike(const CurvedRaster& raster, std::span<const Faceplate::Spread> lights, int y,
                  Scratch& s) {
  std::array<LineRows, kMostLayers> rows;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    raster.spread_lines(*lights[i].light, s.ring[i], y);
    rows[i] = {s.ring[i].narrow.data(), s.ring[i].wide.data(), s.row[i].data()};
  }
  raster.lines_down(s.ring[0], y, {rows.data(), lights.size()});
}

void Faceplate::State::spread_tile(const Raster& of_gun, std::span<const Spread> lights, Scratch& s,
                                   int x, int top) const {
  const int n = std::min(tile_columns, width - x), groups = (n + kGroup - 1) / kGroup;
  int lit_begin = Spread::kEveryLine, lit_end = 0;
  for (const Spread& light : lights) {
    lit_begin = std::min(lit_begin, light.lit_begin);
    lit_end = std::max(lit_end, light.lit_end);
  }
  std::visit(
      [&](const auto& raster) {
        for (std::size_t i = 0; i < lights.size(); ++i) {
          s.row[i].resize(static_cast<std::size_t>(tile_columns));
          raster.begin_tile(s.ring[i], x, groups);
        }
        for (int y = top; y < std::min(height, top + kTileRows); ++y) {
          if (!raster.sees_lines(s.ring[0], y, lit_begin, lit_end)) continue;
          spread_alike(raster, lights, y, s);
          const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(y) * width + x;
          for (std::size_t i = 0; i < lights.size(); ++i) {
            for (const Spread::Share& share : lights[i].to) {
              if (!share.plane || share.scale == 0) continue;
              add_scaled(n, share.scale, s.row[i].data(), share.plane->data() + at);
              // The next row lies far away in memory: asked for ahead.
              const float* const below = share.plane->data() + at + (y + 1 < height ? width : 0);
              for (int ahead = 0; ahead < n; ahead += 16) __builtin_prefetch(below + ahead, 1);
            }
          }
        }
      },
      of_gun);
}

void Faceplate::State::spread(const Raster& raster, std::span<const Spread> any_lights,
                              Workers& workers) const {
  std::vector<Spread> lights(any_lights.begin(), any_lights.end());
  std::vector<LayerLight> blurred;
  const auto* curved = std::get_if<CurvedRaster>(&raster);
  if (curved && !curved->blur().empty()) {
    const int cells = settings.mode.horizontal.active, lines = lines_of(settings);
    blurred.resize(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
      curved->blur().blur(*lights[i].light, cells, lines, blurred[i], workers);
      lights[i].light = &blurred[i];
      lights[i].lit_begin = 0;
      lights[i].lit_end = Spread::kEveryLine;
    }
  }
  std::vector<Scratch> its_scratch(static_cast<std::size_t>(workers.count()));
  const int across = (width + tile_columns - 1) / tile_columns;
  const int down = (height + kTileRows - 1) / kTileRows;
  workers.run(across * down, [&](int task, int worker) {
    Scratch& s = its_scratch[static_cast<std::size_t>(worker)];
    for (std::size_t i = 0; i < lights.size(); i += kMostLayers) {
      const std::size_t count = std::min<std::size_t>(kMostLayers, lights.size() - i);
      spread_tile(raster, std::span<const Spread>(lights).subspan(i, count), s,
                  task % across * tile_columns, task / across * kTileRows);
    }
  });
}

/// Of a spot wider than taps reach, what they are to spread.
std::span<const LayerLight> Faceplate::State::blurred(std::span<const LayerLight> light,
                                                      Workers& workers) {
  const auto* curved = std::get_if<CurvedRaster>(&rasters->of_gun.front());
  if (light.empty() || !curved || curved->blur().empty()) return light;
  const int cells = settings.mode.horizontal.active, lines = lines_of(settings);
  blurred_light.resize(light.size());
  for (std::size_t i = 0; i < light.size(); ++i) {
    curved->blur().blur(light[i], cells, lines, blurred_light[i], workers);
  }
  return blurred_light;
}

double Faceplate::State::draw(std::span<const LayerLight> light, Workers& workers, float gain,
                              const Finish& finish) {
  scratch.resize(static_cast<std::size_t>(workers.count()));
  const auto began = std::chrono::steady_clock::now();
  halation.gather(light, overlay, mask->one(), workers);
  const std::chrono::duration<double, std::milli> glow = std::chrono::steady_clock::now() - began;
  const std::span<const LayerLight> spread = blurred(light, workers);
  const int across = (width + tile_columns - 1) / tile_columns;
  const int down = (height + kTileRows - 1) / kTileRows;
  workers.run(across * down, [&](int task, int worker) {
    draw_tile(spread, scratch[static_cast<std::size_t>(worker)], task % across * tile_columns,
              task / across * kTileRows, gain, finish);
  });
  return glow.count();
}

Faceplate::Faceplate(const TubeSettings& settings, std::span<const FaceplateLayer> layers,
                     int width, int height, const Faceplate* like)
    : state_(std::make_unique<State>(settings, layers, width, height,
                                     like == nullptr ? nullptr : like->state_.get())) {}
Faceplate::~Faceplate() = default;
Faceplate::Faceplate(Faceplate&&) noexcept = default;
Faceplate& Faceplate::operator=(Faceplate&&) noexcept = default;

void Faceplate::set_overlay(const std::vector<std::vector<float>>* overlay) {
  state_->overlay = overlay && !overlay->empty() ? overlay : nullptr;
}

void Faceplate::set_length(double refreshes) { state_->refreshes = refreshes; }

double Faceplate::show(std::span<const LayerLight> light, Workers& workers, Image<LinearRgb>& out) {
  if (out.width() != state_->width || out.height() != state_->height) {
    out = Image<LinearRgb>(state_->width, state_->height);
  }
  return state_->draw(light, workers, 1, [&](const FinishRow& row, int x, int y, int n) {
    finish_light(row, n, out.row(y) + x);
  });
}

double Faceplate::photograph(std::span<const LayerLight> light, Workers& workers, float gain,
                             Image<Srgb8>& out, int left, int top) {
  return state_->draw(light, workers, gain, [&](FinishRow& row, int x, int y, int n) {
    row.out_below = out.row(top + std::min(y + 1, state_->height - 1)) + left + x;
    finish_encoded(row, n, out.row(top + y) + left + x);
  });
}

const GunRasters& Faceplate::rasters() const { return *state_->rasters; }

std::shared_ptr<const GunRasters> Faceplate::bent(const SweepWarp& warp) const {
  auto bent = std::make_shared<GunRasters>();
  for (const Raster& raster : state_->rasters->of_gun) {
    bent->of_gun.emplace_back(std::get<CurvedRaster>(raster).bent(warp));
  }
  return bent;
}

void Faceplate::spread(const GunRasters& rasters, std::size_t layer, std::span<const Spread> lights,
                       Workers& workers) const {
  const int gun = state_->layers[layer].gun;
  state_->spread(rasters.of_gun[static_cast<std::size_t>(gun)], lights, workers);
}

}  // namespace kinescope
