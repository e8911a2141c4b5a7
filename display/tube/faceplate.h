// The front of the tube: from the light of the raster's cells to the picture that a camera before
// the glass sees. Linear in the light.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "display/tube/light_planes.h"
#include "display/tube/settings.h"
#include "raster/base/workers.h"
#include "raster/image/image.h"

namespace kinescope {

struct GunRasters;
struct SweepWarp;

/// One phosphor layer as the faceplate needs it.
struct FaceplateLayer {
  int gun = 0;                    ///< whose beam writes it: 0 red, 1 green, 2 blue
  std::array<float, 3> colour{};  ///< linear sRGB of its light
};

class Faceplate {
 public:
  /// @param layers one to three
  /// @param like what follows from the same settings and size is shared with it
  Faceplate(const TubeSettings& settings, std::span<const FaceplateLayer> layers, int width,
            int height, const Faceplate* like = nullptr);
  ~Faceplate();
  Faceplate(Faceplate&&) noexcept;
  Faceplate& operator=(Faceplate&&) noexcept;

  /// The light of every output pixel; white over one refresh is 1.
  /// How long the next exposures last, in refreshes: so much of the room's light comes in.
  void set_length(double refreshes);
  /// Light that lies over the raster's from now on, the faceplate's size for each layer; empty:
  /// none.
  void set_overlay(const std::vector<std::vector<float>>* overlay);
  /// @param out is given the faceplate's size
  /// @param light of each layer's raster; empty if all light lies over it
  /// @return ms of it that halation took
  double show(std::span<const LayerLight> light, Workers& workers, Image<LinearRgb>& out);
  /// The same times `gain`, encoded, into `out` with its upper left corner at (left, top).
  double photograph(std::span<const LayerLight> light, Workers& workers, float gain,
                    Image<Srgb8>& out, int left, int top);

  /// The guns' rasters as they lie, and as one sweep of a free raster has them.
  const GunRasters& rasters() const;
  std::shared_ptr<const GunRasters> bent(const SweepWarp& warp) const;
  /// Light of one layer's raster, and the planes of the faceplate's size to which it is added.
  struct Spread {
    const LayerLight* light = nullptr;
    struct Share {
      std::vector<float>* plane = nullptr;
      float scale = 1;
    };
    std::array<Share, 2> to{};
    int lit_begin = 0, lit_end = kEveryLine;  ///< lines outside are dark
    static constexpr int kEveryLine = 1 << 30;
  };
  /// Lays such light down as light that lies over the raster; together costs less than one by one.
  void spread(const GunRasters& rasters, std::size_t layer, std::span<const Spread> lights,
              Workers& workers) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kinescope
