// Light still to come from places of the glass that no cell of the raster lies on any more: what a
// raster leaves behind when it moves. Kept by decaying term, a plane of the output's size each.
#pragma once

#include <vector>

#include "display/tube/retrace_light.h"
#include "raster/base/units.h"
#include "raster/base/workers.h"

namespace kinescope {

class Afterglow {
 public:
  /// @param taus of the terms of each layer
  Afterglow(std::vector<std::vector<Seconds>> taus, int width, int height);

  bool empty() const { return planes_.empty(); }
  void darken() { planes_.clear(); }
  /// The picture's size in output pixels changes; the light stays where it is on the glass.
  void resize(int width, int height);

  /// Light still to come, of white over one refresh being 1, to which the caller adds more of it
  /// before anything else is called.
  std::vector<float>& open(std::size_t layer, std::size_t term);
  /// The light of the next `length`, added to a plane for each layer.
  void pass(Seconds length, LightOverlay& sum, Workers& workers);

 private:
  struct Plane {
    std::size_t layer, term;
    double kept = 1;  // of what to_come says
    bool opened = true;
    float largest = 0;
    std::vector<float> to_come;
  };
  void close(Plane& plane) const;

  std::vector<std::vector<Seconds>> taus_;
  int width_, height_;
  std::vector<Plane> planes_;
};

}  // namespace kinescope
