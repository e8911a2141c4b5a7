// What a beam that is not scanned draws.
#pragma once

namespace kinescope {

/// A straight stroke of the beam (raster/path/stroke.h has a Segment of pixels), in the device
/// units of the drawing or tube that holds it: x to the right, y upwards. Both ends are lit; equal
/// ends are a point. Intensity: 0 is dark, 1 the usual beam.
struct VectorSegment {
  float x1 = 0, y1 = 0, x2 = 0, y2 = 0, intensity = 1;
  bool operator==(const VectorSegment&) const = default;
};

}  // namespace kinescope
