#include "demos/polygon_courses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "demos/lesson/ink_lines.h"
#include "raster/fill/scanline_fill.h"

namespace kinescope {
namespace {

constexpr Srgb8 kInside{36, 58, 52, 255};  // fill of what is left
constexpr std::size_t kLine = 37;          // letters in a line of a note

constexpr std::array kCases = {"stays: hands on its end", "leaves: hands on the crossing",
                               "is outside: hands on nothing", "enters: the crossing and its end"};
constexpr std::array kCaseInks = {theme::kGreen, theme::kAccent, theme::kRed, theme::kCool};

/// Words one after the other, in lines that fit the panel.
std::string in_lines(std::string line, const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    if (line.size() + word.size() + 1 > kLine) {
      text += line + '\n';
      line = "   ";
    }
    line += ' ' + word;
  }
  return text + line + '\n';
}

std::string corner_list(const char* name, const Contour& contour) {
  std::vector<std::string> words;
  for (const glm::dvec2& p : contour) words.push_back(fmt::format("{:.0f},{:.0f}", p.x, p.y));
  return in_lines(fmt::format("{} {}:", name, contour.size()), words);
}

/// In entering order of one contour; the one just reached in brackets.
std::string crossing_list(const char* name, const AthertonCourse& course,
                          const std::vector<std::vector<std::size_t>>& along,
                          const glm::dvec2* at) {
  std::vector<std::string> words;
  for (const auto& list : along) {
    for (const std::size_t i : list) {
      const ContourCrossing& x = course.lists.crossings[i];
      const std::string word = fmt::format("{}{}", i + 1, x.entering ? '+' : '-');
      words.push_back(at && *at == x.point ? '[' + word + ']' : word);
    }
  }
  return in_lines(name, words);
}

template <typename Ink>
void ink_contour(Ink& ink, const World& world, const Contour& contour, Srgb8 colour) {
  // Always from the same end, so that an edge has the same pixels whichever way it is followed.
  contour_edges(contour, [&](glm::dvec2 a, glm::dvec2 b) {
    if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) std::swap(a, b);
    ink_line(ink, world, world.middle_of(a), world.middle_of(b), colour);
  });
}

template <typename Ink>
void ink_chain(Ink& ink, const World& world, const Contour& chain, Srgb8 colour) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    ink_line(ink, world, world.middle_of(chain[i]), world.middle_of(chain[i + 1]), colour);
  }
}

void fill(const Region& region, const World& world, Image<Srgb8>& paper) {
  Polygon polygon;
  for (const Contour& contour : region) {
    polygon.emplace_back();
    for (const glm::dvec2& p : contour) polygon.back().push_back(world.middle_of(p));
  }
  scanline_fill(polygon, FillRule::kEvenOdd, world.window(), [&](const RowSpan& span) {
    std::fill_n(paper.row(span.y) + span.x_begin, span.length(), kInside);
  });
}

}  // namespace

const Contour& clip_shape(ClipShape shape) {
  static const std::array<Contour, 3> kShapes = {
      {{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
       {{0.25, 0}, {0.75, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}},
       {{0, 0}, {1, 0}, {1, 1}, {0.7, 1}, {0.5, 0.35}, {0.3, 1}, {0, 1}}}};
  return kShapes[static_cast<std::size_t>(shape)];
}

HodgmanCourse hodgman_course(SutherlandHodgman clip, const Contour& subject) {
  HodgmanCourse course;
  for (Contour in = subject; clip.stage() < clip.stages() && !in.empty();) {
    const int k = clip.stage();
    const std::vector<ClippedEdge> edges = clip.edges(k, in);
    clip.next();
    std::size_t count = 0;
    for (const ClippedEdge& edge : edges) {
      count += static_cast<std::size_t>(edge.handed_on);
      const Contour& out = clip.polygon();
      const auto end = out.begin() + static_cast<std::ptrdiff_t>(std::min(count, out.size()));
      course.steps.push_back({k, clip.side(k), edge, in, Contour(out.begin(), end)});
    }
    in = clip.polygon();
  }
  course.polygon = clip.polygon();
  return course;
}

AthertonCourse atherton_course(const Contour& subject, const Contour& clip) {
  AthertonCourse course;
  WeilerAtherton following({subject}, {clip});
  course.lists = following.crossings();
  while (following.next()) {
    course.steps.push_back({following.on_clip, following.piece, following.pieces.size()});
  }
  course.pieces = following.pieces;
  return course;
}

Track hodgman_track(const HodgmanCourse& course, const World& world, int pane) {
  Track track("Sutherland-Hodgman", {"side", "edge", "in", "out"}, pane);
  int edge = 0, stage = -1;
  for (const HodgmanStep& s : course.steps) {
    edge = s.stage == stage ? edge + 1 : 1;
    stage = s.stage;
    track.step({double(stage + 1), double(edge), double(s.in.size()), double(s.out.size())},
               fmt::format("side {}, edge {} {}\n", stage + 1, edge,
                           kCases[static_cast<std::size_t>(s.edge.what)]) +
                   corner_list("in", s.in) + corner_list("out", s.out));
  }
  if (course.steps.empty()) return track;
  ink_contour(track, world, course.polygon, theme::kText);
  const auto left = static_cast<double>(course.polygon.size());
  track.step({double(stage + 1), 0, left, left}, corner_list("left", course.polygon));
  track.step({double(stage + 1), 0, left, left}, corner_list("left", course.polygon));
  return track;
}

Track atherton_track(const AthertonCourse& course, const World& world, int pane) {
  Track track("Weiler-Atherton", {"piece", "x", "y"}, pane);
  std::size_t closed = 0;
  for (const AthertonStep& s : course.steps) {
    for (; closed < s.pieces; ++closed) {
      ink_contour(track, world, course.pieces[closed], theme::kText);
    }
    const glm::dvec2* at = s.piece.empty() ? nullptr : &s.piece.back();
    const char* what = !at         ? "the piece is closed"
                       : s.on_clip ? "along the clip polygon"
                                   : "along the subject";
    track.step({double(s.pieces) + (at ? 1 : 0), at ? at->x : NAN, at ? at->y : NAN},
               fmt::format("{}\n", what) +
                   crossing_list("subject:", course, course.lists.along_subject, at) +
                   crossing_list("clip:", course, course.lists.along_clip, at));
  }
  return track;
}

void paint(const HodgmanCourse& course, std::size_t shown, const World& world,
           Image<Srgb8>& paper) {
  PaperInk ink{paper};
  if (shown == 0) return;
  if (shown > course.steps.size()) return fill({course.polygon}, world, paper);
  const HodgmanStep& s = course.steps[shown - 1];
  ink_contour(ink, world, s.in, theme::kKeyCap);
  ink_line(ink, world, world.middle_of(s.edge.from), world.middle_of(s.edge.to),
           kCaseInks[static_cast<std::size_t>(s.edge.what)]);
  ink_chain(ink, world, s.out, theme::kText);
}

void paint(const AthertonCourse& course, std::size_t shown, const World& world,
           Image<Srgb8>& paper) {
  if (shown == 0 || course.steps.empty()) return;
  const AthertonStep& s = course.steps[std::min(shown, course.steps.size()) - 1];
  const auto end = course.pieces.begin() + static_cast<std::ptrdiff_t>(s.pieces);
  fill(Region(course.pieces.begin(), end), world, paper);
  PaperInk ink{paper};
  ink_chain(ink, world, s.piece, s.on_clip ? theme::kCool : theme::kGreen);
}

void add_overlay(Overlay& over, const HodgmanCourse& course, std::size_t shown, const World& world,
                 int pane) {
  if (shown == 0 || shown > course.steps.size()) return;
  const HodgmanStep& s = course.steps[shown - 1];
  // The side's line through the whole pane.
  const glm::dvec2 a = world.middle_of(s.side.from), b = world.middle_of(s.side.to), along = b - a;
  const double reach = 2.0 * (world.columns() + world.rows());
  const double length = std::hypot(along.x, along.y);
  if (!(length > 0)) return;
  over.guides.push_back(
      {a - along * (reach / length), b + along * (reach / length), theme::kAccent, pane});
}

void add_overlay(Overlay& over, const AthertonCourse& course, std::size_t shown, const World& world,
                 int pane) {
  if (shown == 0) return;
  for (std::size_t i = 0; i < course.lists.crossings.size(); ++i) {
    const ContourCrossing& x = course.lists.crossings[i];
    over.labels.push_back({world.middle_of(x.point),
                           fmt::format("{}{}", i + 1, x.entering ? '+' : '-'),
                           x.entering ? theme::kGreen : theme::kRed, pane});
  }
}

void add_outline(Overlay& over, const World& world, const Contour& contour, Srgb8 colour,
                 int pane) {
  contour_edges(contour, [&](glm::dvec2 a, glm::dvec2 b) {
    over.guides.push_back({world.middle_of(a), world.middle_of(b), colour, pane});
  });
}

}  // namespace kinescope
