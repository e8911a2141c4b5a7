// Light still to come from places of the glass that no cell of the raster lies on any more: what a
// raster leaves behind when it moves. Kept by decaying term, a plane of the output's size each.
#pragma once

#include <list>
#include <vector>

#include "display/tube/beam_flight.h"
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

  /// A plane to which the caller adds more light to come, white over one refresh being 1, before
  /// time goes on: `scale` times it here, and `seen` times it to the layer's sum, so that what is
  /// gathered at the end is right for it too.
  struct Opened {
    std::vector<float>& to_come;
    float scale, seen;
  };
  Opened open(std::size_t layer, std::size_t term);
  /// Time goes on. What is added to `sum`, a plane for each layer, is right once it is gathered.
  void pass(Seconds length, LightOverlay& sum, Workers& workers);
  /// The light since the last call, added to `sum`.
  void gather(LightOverlay& sum, Workers& workers);

 private:
  struct Plane {
    std::size_t layer, term;
    double kept = 1;              // of what to_come says
    double owed = 0;              // of it, what came since it was gathered
    double kept_when_opened = 1;  // last
    std::vector<float> to_come;
  };
  void gather(const std::vector<Plane*>& planes, LightOverlay& sum, Workers& workers);

  std::vector<std::vector<Seconds>> taus_;
  int width_, height_;
  std::list<Plane> planes_;  // opened ones keep their place
};

}  // namespace kinescope
