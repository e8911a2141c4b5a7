// What Sutherland-Hodgman's and Weiler-Atherton's clippers did, step by step, for a demo to show.
#pragma once

#include <string>
#include <vector>

#include "demos/lesson/lesson.h"
#include "engine/clip/sutherland_hodgman.h"
#include "engine/clip/weiler_atherton.h"

namespace kinescope {

/// A step: one edge at one clipper.
struct HodgmanStep {
  int stage = 0;
  Segment2 side;
  ClippedEdge edge;
  Contour in, out;  ///< the polygon that went in, and the corners handed on so far
};
struct HodgmanCourse {
  std::vector<HodgmanStep> steps;
  Contour polygon;  ///< what is left
};

/// A step: one corner or crossing more.
struct AthertonStep {
  bool on_clip = false;
  Contour piece;
  std::size_t pieces = 0;  ///< closed ones
};
struct AthertonCourse {
  std::vector<AthertonStep> steps;
  CrossingLists lists;
  Region pieces;
};

/// Polygons to clip to, in shares of a rectangle.
enum class ClipShape { kWindow, kConvex, kConcave };
const Contour& clip_shape(ClipShape shape);

HodgmanCourse hodgman_course(SutherlandHodgman clip, const Contour& subject);
AthertonCourse atherton_course(const Contour& subject, const Contour& clip);

/// Corners are in the world's names. The last step but one plots what is left; the last, nothing.
Track hodgman_track(const HodgmanCourse& course, const World& world, int pane);
Track atherton_track(const AthertonCourse& course, const World& world, int pane);

/// The state after so many steps.
void paint(const HodgmanCourse& course, std::size_t shown, const World& world, Image<Srgb8>& paper);
void paint(const AthertonCourse& course, std::size_t shown, const World& world,
           Image<Srgb8>& paper);
void add_overlay(Overlay& over, const HodgmanCourse& course, std::size_t shown, const World& world,
                 int pane);
void add_overlay(Overlay& over, const AthertonCourse& course, std::size_t shown, const World& world,
                 int pane);
/// @param pane -1: all
void add_outline(Overlay& over, const World& world, const Contour& contour, Srgb8 colour,
                 int pane = -1);

}  // namespace kinescope
