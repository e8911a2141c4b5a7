// A layer: a small picture with alpha that is laid over the frame, drawn anew only when it changes.
#pragma once

#include "demos/ui/canvas.h"
#include "raster/image/image.h"

namespace kinescope {

struct Layer {
  Image<Srgb8> image;
  int x = 0, y = 0;  ///< of its top left corner in the frame
};

/// An empty panel to draw on: opaque while it is drawn, so that text blends as on the screen.
Layer begin_layer(int width, int height);
/// Makes the untouched background translucent and rounds the corners.
void finish_layer(Layer& layer, float radius);

/// Lays the layer over the frame, clipped to it.
void composite(const Layer& layer, Image<Srgb8>& frame);

}  // namespace kinescope
