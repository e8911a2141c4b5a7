// A model before a camera that frames it, follows the user's wishes, and can walk around it.
#pragma once

#include "demos/options.h"
#include "engine/framing.h"
#include "engine/renderer.h"

namespace kinescope {

class ModelView {
 public:
  /// @param aspect width over height of the picture
  /// @throws Error (usage) if eye and look, or up, make no view
  ModelView(Scene scene, const RenderOptions& options, double aspect, Workers& workers);

  /// Draws with the camera walked around the model by `turn_rad` about the vertical. Lights of our
  /// own (where the model brings none) walk along; the model's stay with it.
  RenderStats draw(double turn_rad, RenderTarget& target, bool want_visibility_hash);

  const Scene& scene() const { return scene_; }

 private:
  Camera first_camera(const RenderOptions& options, double aspect) const;
  void fit_depth(Camera& camera) const;

  Scene scene_;
  Bounds bounds_;
  Camera camera_;
  RenderSettings settings_;
  bool own_lights_;
  Renderer renderer_;
};

}  // namespace kinescope
