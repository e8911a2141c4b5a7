#include "engine/clip/weiler_atherton.h"

#include <algorithm>

namespace kinescope {
namespace {

void rank(const std::vector<std::vector<std::size_t>>& along, std::vector<std::size_t>& ranks) {
  for (const auto& list : along) {
    for (std::size_t i = 0; i < list.size(); ++i) ranks[list[i]] = i;
  }
}

/// Corners passed on the way from one place of a contour on to another.
std::size_t corners_between(const ContourPlace& from, const ContourPlace& to, std::size_t corners,
                            bool around) {
  if (from.edge == to.edge) return around ? corners : 0;
  return (to.edge + corners - from.edge) % corners;
}

}  // namespace

WeilerAtherton::WeilerAtherton(const Region& subject, const Region& clip, Keep keep)
    : subject_(oriented(subject)), clip_(oriented(clip)), keep_(keep) {
  if (keep == Keep::kOutside) {
    for (Contour& contour : clip_) std::reverse(contour.begin(), contour.end());
  }
  lists_ = contour_crossings(subject_, clip_, keep == Keep::kInside);
  const std::size_t n = lists_.crossings.size();
  subject_rank_.resize(n);
  clip_rank_.resize(n);
  used_.resize(n);
  rank(lists_.along_subject, subject_rank_);
  rank(lists_.along_clip, clip_rank_);
}

void WeilerAtherton::add(const glm::dvec2& p) {
  if (piece.empty() || piece.back() != p) piece.push_back(p);
}

bool WeilerAtherton::take_whole_contours() {
  if (whole_done_) return false;
  whole_done_ = true;
  for (std::size_t i = 0; i < subject_.size(); ++i) {
    if (!lists_.along_subject[i].empty()) continue;
    if (subject_point_in_clip(subject_[i][0], clip_) == (keep_ == Keep::kInside)) {
      pieces.push_back(subject_[i]);
    }
  }
  for (std::size_t i = 0; i < clip_.size(); ++i) {
    if (!lists_.along_clip[i].empty()) continue;
    if (clip_point_in_subject(clip_[i][0], subject_)) pieces.push_back(clip_[i]);
  }
  return true;
}

bool WeilerAtherton::begin_piece() {
  while (sought_ < used_.size() && (used_[sought_] || !lists_.crossings[sought_].entering)) {
    ++sought_;
  }
  if (sought_ == used_.size()) return false;
  first_ = from_ = sought_;
  on_clip = true;  // so that the run that arrives here turns into the subject
  corners_left_ = 0;
  piece.clear();
  return true;
}

bool WeilerAtherton::next() {
  if (piece.empty() && !begin_piece()) return take_whole_contours();
  if (!piece.empty() && corners_left_ > 0) {
    const Region& region = on_clip ? clip_ : subject_;
    const ContourCrossing& x = lists_.crossings[from_];
    const Contour& contour = region[on_clip ? x.on_clip.contour : x.on_subject.contour];
    add(contour[corner_]);
    corner_ = (corner_ + 1) % contour.size();
    --corners_left_;
    return true;
  }
  // At a crossing: the one after it on this contour, or the very first.
  if (!piece.empty()) {
    const ContourCrossing& x = lists_.crossings[from_];
    const auto& list =
        on_clip ? lists_.along_clip[x.on_clip.contour] : lists_.along_subject[x.on_subject.contour];
    const std::size_t at = on_clip ? clip_rank_[from_] : subject_rank_[from_];
    from_ = list[(at + 1) % list.size()];
    if (on_clip && from_ == first_) {
      while (piece.size() > 1 && piece.front() == piece.back()) piece.pop_back();
      if (piece.size() >= 3 && signed_area(piece) != 0.0) pieces.push_back(piece);
      piece.clear();
      return true;
    }
  }
  on_clip = !on_clip;
  used_[from_] = true;
  const ContourCrossing& x = lists_.crossings[from_];
  add(x.point);
  const auto& list =
      on_clip ? lists_.along_clip[x.on_clip.contour] : lists_.along_subject[x.on_subject.contour];
  const std::size_t at = on_clip ? clip_rank_[from_] : subject_rank_[from_];
  const bool around = at + 1 == list.size();
  const ContourCrossing& to = lists_.crossings[list[(at + 1) % list.size()]];
  const ContourPlace &here = on_clip ? x.on_clip : x.on_subject,
                     &there = on_clip ? to.on_clip : to.on_subject;
  const std::size_t corners = (on_clip ? clip_ : subject_)[here.contour].size();
  corners_left_ = corners_between(here, there, corners, around);
  corner_ = (here.edge + 1) % corners;
  return true;
}

Region clip_weiler_atherton(const Region& subject, const Region& clip, Keep keep) {
  WeilerAtherton following(subject, clip, keep);
  while (following.next()) {
  }
  return following.pieces;
}

}  // namespace kinescope
