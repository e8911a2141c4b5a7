// The vector tube: what a beam's moves leave on a phosphor, and exposures of its light.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "display/vector/beam_cutter.h"
#include "display/vector/beam_dynamics.h"
#include "display/vector/beam_move.h"
#include "display/vector/beam_painter.h"
#include "display/vector/beam_span.h"
#include "display/vector/dose_light.h"
#include "display/vector/machine.h"
#include "display/vector/repeated_moves.h"
#include "raster/base/workers.h"
#include "raster/image/image.h"

namespace kinescope {

/// The light of [now, end) of each exposure, which must follow each other without gaps. 1 is what a
/// full current leaves in the middle of a line that it draws once, at the machine's usual speed.
/// Modelled: the beam's dynamics, its spot, the phosphor's decay, colour.
class VectorTube {
 public:
  /// @param width, height of the picture, pixels; the machine's points lie in its middle, squares
  VectorTube(const VectorMachine& machine, int width, int height);

  Seconds now() const { return now_; }
  /// Nothing glows, and nothing that was given lies ahead: until moves come, pictures are black.
  bool dark() const;
  /// @param moves those that begin before `end` and were not yet given; what lasts longer is kept
  /// @return valid until the next call
  const Image<LinearRgb>& expose(std::span<const BeamMove> moves, Seconds end, Workers& workers);
  /// Whether the last exposure differs from the one before it. Of a list that is refreshed in step
  /// with the exposures and does not change, the light is drawn once and added again; once the
  /// phosphor is in balance, an exposure costs nothing.
  bool changed() const { return changed_; }

 private:
  bool all_unlit() const;
  void fade(int tile, Seconds length);
  void add_marks(const BeamSpan& span, Seconds until, std::vector<BeamPiece>& pieces,
                 BeamMarks& marks) const;
  void add_even(const BeamSpan& span, const BeamPiece& piece, Seconds until,
                BeamMarks& marks) const;
  void add_spots(const BeamSpan& span, const BeamPiece& piece, Seconds until,
                 BeamMarks& marks) const;
  std::array<float, 3> guns_of(const BeamSpan& span) const;
  double dose_of(double seconds, float current) const;
  void compose(int tile);
  bool draw_spans(Seconds until, TiledLight& light, Workers& workers);
  bool draw_moves(std::span<const BeamMove> moves, Seconds end, TiledLight& light,
                  Workers& workers);
  void draw_cycle(std::span<const BeamMove> moves, Seconds end, Workers& workers);
  void repeat(Seconds length);
  bool carries_since(Seconds time) const;
  int exposures_to_balance(Seconds length) const;

  bool guns_;  // a move's colour has a share for each layer
  DoseLight dose_light_;
  double scale_, left_, bottom_;  // pixels a device unit; where (0, 0) lies, pixels
  float sigma_px_;
  double gain_;  // light a second of full current
  Seconds now_{0};
  BeamDynamics dynamics_;
  BeamCutter cutter_;
  TiledLight light_;
  BeamPainter painter_;
  std::vector<BeamSpan> spans_;    // to be drawn next
  std::vector<BeamSpan> lasting_;  // those that had not ended by now
  std::vector<BeamMarks> marks_;   // of each chunk of them
  Image<LinearRgb> picture_;
  bool black_ = true;  // the picture
  bool changed_ = true;
  RepeatedMoves repeated_;
  TiledLight
      cycle_;  // what the strokes of one exposure add to light_, if they are the same in each
  bool has_cycle_ = false;
};

}  // namespace kinescope
