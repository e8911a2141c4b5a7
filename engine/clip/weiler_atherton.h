// Concave polygons with holes clipped to concave polygons with holes.
// Source: Weiler and Atherton, "Hidden Surface Removal Using Polygon Area Sorting", 1977.
#pragma once

#include <vector>

#include "engine/clip/contour_crossings.h"

namespace kinescope {

enum class Keep { kInside, kOutside };

/// Follows the subject from where it enters the clip region to where it leaves, then the clip to
/// where the subject enters again, until a piece closes.
class WeilerAtherton {
 public:
  /// @throws Error (bad input) for corners that are not finite, or contours that cross themselves
  ///         where that would leave no order to follow
  WeilerAtherton(const Region& subject, const Region& clip, Keep keep = Keep::kInside);

  /// Adds one corner or crossing to the piece, or closes it; false when all are done.
  bool next();

  const CrossingLists& crossings() const { return lists_; }
  const Region& subject() const { return subject_; }
  const Region& clip() const { return clip_; }
  bool on_clip = false;  ///< which of the two is being followed
  Contour piece;         ///< what has been followed so far
  Region pieces;         ///< closed ones: outer contours counter-clockwise, holes clockwise

 private:
  void add(const glm::dvec2& p);
  bool begin_piece();
  bool take_whole_contours();

  Region subject_, clip_;
  Keep keep_;
  CrossingLists lists_;
  std::vector<std::size_t> subject_rank_, clip_rank_;  // place of each crossing in its list
  std::vector<bool> used_;
  std::size_t first_ = 0, from_ = 0;  // crossings: where the piece began, where this run did
  std::size_t corners_left_ = 0, corner_ = 0;
  std::size_t sought_ = 0;
  bool whole_done_ = false;
};

Region clip_weiler_atherton(const Region& subject, const Region& clip, Keep keep = Keep::kInside);

}  // namespace kinescope
