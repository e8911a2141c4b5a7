// The direct-view storage tube: what its beam has written glows until the screen is erased, kept
// alight by a flood of slow electrons. A picture that stands still costs nothing.
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <vector>

#include "display/vector/beam_move.h"
#include "display/vector/beam_painter.h"
#include "display/vector/input/drawing.h"
#include "display/vector/storage_tube_type.h"
#include "display/vector/tiled_light.h"
#include "display/vector/vector_tube.h"
#include "raster/base/workers.h"
#include "raster/image/image.h"

namespace kinescope {

/// Modelled: a bistable target (a spot is stored where its dose passes a threshold, so lines
/// have one brightness and a limit of resolution), the light of the passing beam, write-through,
/// erasure of the whole screen with its flash, contrast that fades over minutes. Not: dots of
/// the target's own structure, halos where much was written, write-through that stores in the end.
/// Light: 1 is what a stored line gives in 1/60 s.
class StorageTube {
 public:
  /// @param width, height of the picture, pixels; the tube's screen lies in its middle
  StorageTube(const StorageTubeType& type, int width, int height);

  const StorageTubeType& type() const { return type_; }
  Seconds now() const { return now_; }

  /// Draws a drawing, its texts, and erases where it does; from now on, or once what was asked for
  /// before is done. Strokes of write-through pens are seen while the beam passes, and not kept.
  void draw(const VectorDrawing& drawing);
  /// Erases the screen, once what was asked for before is done. Drawing goes on after it.
  void erase();
  /// When everything that was asked for will be done; now(), if it is.
  Seconds busy_until() const { return std::max(now_, free_); }
  bool erasing() const { return now_ < erasure_ + type_.erase; }

  /// The light of [now, end): exposures follow each other without gaps.
  /// @return valid until the next call
  const Image<LinearRgb>& expose(Seconds end, Workers& workers);
  /// Whether the last exposure differs from the one before it: if not, its picture is the same to
  /// the last bit, and cost nothing.
  bool changed() const { return changed_; }
  /// Nothing lies ahead but fading over minutes: a window may sleep until it is asked to draw.
  bool still() const { return still_; }

  /// What is stored, as a copier that scans the target puts it on paper: dark lines on white. Takes
  /// none of the tube's time.
  Image<Srgb8> hard_copy() const;

 private:
  struct Stroke {
    BeamMove move;
    bool stored = true;
  };
  struct Job {
    bool erases = false;  // else writes
    Seconds begin{0}, end{0};
    std::vector<Stroke> strokes;
    std::size_t next = 0, passed = 0;  // not yet stored; whose light the beam does not yet have
  };

  void write(const VectorDrawing& strokes);
  void pass_beam(Seconds end, Workers& workers);
  void run_target(Seconds end, Workers& workers);
  void store(Job& job, Seconds time, Workers& workers);
  void add_dose(const BeamMove& move);
  void start_erasure(Seconds begin);
  void gather(int tile, Seconds time);
  double flood_light(Seconds begin, Seconds end) const;
  double background_light(Seconds begin, Seconds end) const;
  void compose(Workers& workers);
  void compose_tile(int tile, float flood, float background);

  StorageTubeType type_;
  VectorMachine machine_;  // the writing beam's
  VectorTube beam_;        // its own light
  std::array<float, 3> colour_;
  double scale_, left_, bottom_;  // pixels a point; where (0, 0) lies, pixels
  TiledLight dose_;               // of strokes that are being stored
  TiledLight target_;             // planes: charge, what is stored, light gathered in this exposure
  struct TileTime {
    bool gathers = false;  // its stored picture changed within this exposure
    Seconds until{0};      // up to which its light is gathered
  };
  std::vector<TileTime> times_;
  BeamPainter painter_;
  std::deque<Job> jobs_;
  std::vector<BeamMove> moves_;
  std::vector<BeamStroke> strokes_;
  std::vector<float> weights_;
  Seconds begin_{0}, now_{0};  // of the exposure; where it ended
  Seconds free_{0};            // when all jobs are done
  Seconds erasure_;            // when the last began
  double gathered_background_ = 0;
  Seconds background_until_{0};
  const Image<LinearRgb>* beam_light_ = nullptr;
  Image<LinearRgb> picture_;
  bool changed_ = true, still_ = true;
  bool moves_on_ = true;  // this exposure's picture is not the one that stays
  double shown_flood_ = -1, shown_background_ = -1;
};

}  // namespace kinescope
