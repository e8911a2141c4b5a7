// A scene through a camera into a render target, or into device-space segments.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "engine/scene.h"
#include "raster/rasterizer.h"
#include "shading/surface.h"

namespace kinescope {

struct RenderSettings {
  ShadingModel shading = ShadingModel::kPhong;
  bool wireframe = false;    ///< edges only, as lines of wire_width_px
  bool points = false;       ///< vertices only, as squares of point_size_px
  bool hidden_wire = false;  ///< wireframe: hide what lies behind surfaces
  bool textures = true;
  float wire_width_px = 1.0f;
  float point_size_px = 3.0f;
};

/// Figures of one rendered frame.
struct RenderStats {
  RasterStats raster;
  std::uint64_t vertices = 0;
  std::uint64_t clipped = 0;  ///< triangles that left the guard band and were cut
};

/// Draws scenes. Keeps its buffers (world-space vertices among them) between frames.
class Renderer {
 public:
  explicit Renderer(Workers& workers, RasterizerOptions options = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  RenderStats render(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                     RenderTarget& target, bool want_visibility_hash = false);
  /// Forgets cached vertices; call after changing a mesh in place (moving a node needs no call).
  void invalidate();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kinescope
