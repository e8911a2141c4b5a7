// What a batch is made in: its arrays, and the planes of its triangles.
#pragma once

#include <array>
#include <cstdint>

#include "raster/batch.h"
#include "raster/draw_call.h"

namespace kinescope {

/// Of each run of fragments of one triangle: the weights of its second and third vertex as planes
/// on the screen, each times 1/w of its vertex, and the sum of all three weights. Structure of
/// arrays.
struct WeightPlanes {
  template <typename T>
  using Runs = std::array<T, Batch::kMaxSize + 16>;

  alignas(64) Runs<std::uint32_t> triangle{};
  alignas(64) Runs<float> x_px{}, y_px{};  ///< anchor: the first vertex
  alignas(64) Runs<float> w0{};            ///< the sum there: 1/w of that vertex
  alignas(64) Runs<float> dx1{}, dy1{}, dx2{}, dy2{}, dx_sum{}, dy_sum{};  ///< a pixel
  alignas(64) Runs<float> facing{};                                        ///< as Batch::facing
  alignas(64) std::array<Runs<std::uint32_t>, 3> vertex{};
  /// Vertex attributes: the first vertex's, and how much more the second's and third's are.
  using Attributes = std::array<Runs<float>, Batch::kMaxAttributes>;
  alignas(64) std::array<Attributes, 3> attribute{};
  /// Numerators of du_dx, dv_dx, du_dy, dv_dy where the texture coordinates are 0.
  alignas(64) std::array<Runs<float>, 4> gradient{};

  /// Of each vector of the batch's fragments: the run of its first one, and a bit for each fragment
  /// that is its run's last.
  alignas(64) Runs<std::int32_t> first_run{};
  Runs<std::uint8_t> run_ends{};
  std::array<std::uint16_t, 256> place{};  ///< where triangles were put, by their last eight bits
  Runs<std::int32_t> joined{};  ///< of each run as found, where several were joined: the one left
};

/// The arrays that a Batch points to.
struct BatchStorage {
  /// A vector may begin at any fragment, and so end beyond the last.
  static constexpr int kMax = Batch::kMaxSize + 16;
  alignas(64) std::array<std::uint16_t, kMax> x{};
  alignas(64) std::array<std::uint16_t, kMax> y{};
  alignas(64) std::array<std::uint32_t, kMax> triangle{};   ///< in the draw call
  alignas(64) std::array<std::uint32_t, kMax> primitive{};  ///< in its source
  WeightPlanes planes;
  alignas(64) std::array<float, kMax> facing{};  ///< filled where a call culls nothing
  alignas(64) std::array<std::array<float, kMax>, Batch::kMaxAttributes> attribute{};
  alignas(64) std::array<std::array<float, kMax>, 4> gradient{};  ///< du_dx, dv_dx, du_dy, dv_dy
};

/// The shader's view of the first `size` fragments, whose x, y and triangle are there.
Batch batch_of(const DrawCall& draw, BatchStorage& storage, int size);

}  // namespace kinescope
