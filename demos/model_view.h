// A model before a camera that frames it, follows the user's wishes, and can walk around it.
#pragma once

#include "demos/options.h"
#include "engine/framing.h"
#include "engine/renderer.h"

namespace kinescope {

/// The scene with what the user calls up along +y, and the camera as the user wishes; by itself it
/// sees the whole scene from anywhere on its way around.
/// @param turns whether the camera will be walked around the model
/// @throws Error (usage) if eye and look, or up, make no view
Scene upright_scene(Scene scene, const RenderOptions& options);
Camera model_camera(const Scene& upright, const RenderOptions& options, double aspect, bool turns);

/// Depth planes about the whole scene, for a camera that was moved.
void fit_depth(Camera& camera, const Bounds& bounds);
/// Moves a camera round what it looks at, about the vertical.
void walk_around(Camera& camera, double turn_rad, const Bounds& bounds);

class ModelView {
 public:
  ModelView(Scene scene, const RenderOptions& options, double aspect, bool turns, Workers& workers);

  /// Draws with the camera walked around the model by `turn_rad` about the vertical. Lights of our
  /// own (where the model brings none) walk along; the model's stay with it.
  RenderStats draw(double turn_rad, RenderTarget& target, bool want_visibility_hash);

  const Scene& scene() const { return scene_; }

 private:
  Scene scene_;
  Bounds bounds_;
  Camera camera_;
  RenderSettings settings_;
  bool own_lights_;
  Renderer renderer_;
};

}  // namespace kinescope
