#include "demos/twin_cubes.h"

namespace kinescope {
namespace {

constexpr Axonometric kFrom{30, 25};  // what the picture is seen from

Wire cube() { return wire_box(glm::dvec3(-1), glm::dvec3(1)); }

/// An edge is seen if one of the two faces that meet there faces the viewer.
bool is_seen(const std::array<std::size_t, 2>& edge, bool reversed) {
  const glm::dmat4 turned = picture_from_world(kFrom);
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t bit = std::size_t{1} << axis;
    if ((edge[0] ^ edge[1]) & bit) continue;
    const double outwards = edge[0] & bit ? 1 : -1;
    if (outwards * turned[axis].z * (reversed ? -1 : 1) > 1e-12) return true;
  }
  return false;
}

Track cube_track(const TwinCubes& twins, bool reversed) {
  const Srgb8 ink = reversed ? theme::kAccent : theme::kText;
  Track track(reversed ? "the same, depth reversed" : "a cube", {"x", "y"}, 1, ink);
  const SpacePane picture{twins.space.world, kFrom, {}, 2.2};
  const Wire wire = cube();
  for (const auto& edge : wire.edges) {
    const bool seen = is_seen(edge, reversed);
    const glm::dvec2 end = picture.place(wire.points[edge[1]]);
    if (seen || !twins.hides_lines) {
      ink_line(track, picture.world, picture.place(wire.points[edge[0]]), end, ink);
    }
    track.step({end.x, end.y}, seen ? "" : "hidden by the cube itself\n");
  }
  track.step({NAN, NAN});
  return track;
}

}  // namespace

Course twin_cubes_course(const TwinCubes& twins) {
  Course course;
  course.tracks = {cube_track(twins, false), cube_track(twins, true)};
  course.compare = true;
  course.remarks = {"Left: both solids, seen from elsewhere."};
  course.painter = [space = twins.space](std::size_t, int pane, Image<Srgb8>& paper) {
    if (pane != 0) return;
    PaperInk ink{paper};
    const glm::dmat4 turned = picture_from_world(kFrom);
    ink_wire(ink, space, cube(), translation({-2, 0, 0}) * turned, theme::kText);
    ink_wire(ink, space, cube(), translation({2, 0, 0}) * scaling({1, 1, -1}) * turned,
             theme::kAccent);
  };
  return course;
}

}  // namespace kinescope
