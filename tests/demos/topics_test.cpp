// What the course asks for, and where `kinescope list --json` names it.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "demos/registry.h"

namespace kinescope {
namespace {

const std::map<std::string, std::vector<std::string>>& rows_of_chapters() {
  static const std::map<std::string, std::vector<std::string>> kRows = {
      {"1 Displays and coordinates",
       {"four operations: imaging, modelling, rendering, animation",
        "image as samples",
        "magnified pixel grid against vectors",
        "graphics pipeline: local, world, view, clip, logical screen, device",
        "CRT: gun, focus, deflection, phosphor: a beam seen in slow time",
        "raster scan: frame buffer, refresh",
        "raster scan: horizontal and vertical retrace, interlace",
        "random scan: display file, display processor, refresh falling as the list grows",
        "persistence",
        "resolution",
        "aspect ratio",
        "frame buffer",
        "bitmap and pixmap",
        "applications: a wireframe CAD part",
        "applications: bar, line and pie charts",
        "applications: a paint program (brush widths and colours)",
        "applications: picture enhancement",
        "applications: windows and menus",
        "input: mouse, keyboard",
        "input: light pen",
        "Cartesian and polar coordinates",
        "conversions, both grids"}},
      {"2 Scan conversion",
       {"DDA line", "Bresenham line, all octants", "explicit circle", "parametric circle",
        "DDA circle", "Bresenham circle", "midpoint circle", "eight-way symmetry",
        "midpoint ellipse", "DDA ellipse", "general conic", "arcs", "thick lines", "dashed lines",
        "compare DDA with Bresenham value by value"}},
      {"3 Two-dimensional transformations",
       {"identity", "scaling (uniform, differential, about a point)",
        "reflection (axes, origin, y=x, any line y=mx+c)", "shear (x, y)",
        "rotation (origin, pivot)", "translation", "composition", "homogeneous coordinates",
        "geometric against coordinate transformation", "classes (rigid, conformal, affine)"}},
      {"5 Three-dimensional transformations",
       {"three-dimensional scaling", "translation", "rotation about x, y, z and any axis", "shear",
        "reflection in a plane", "reflection about an axis",
        "planes by three points and by point and normal", "normals under affine maps"}},
      {"6 Projections",
       {"orthographic views (front, top, side)", "axonometric: isometric, dimetric, trimetric",
        "oblique (cavalier, cabinet)", "perspective with one, two and three vanishing points",
        "foreshortening", "view confusion", "topological distortion", "cured by clipping"}},
      {"7 Viewing and clipping",
       {"window to viewport", "normalized device coordinates", "point clipping", "Cohen-Sutherland",
        "Liang-Barsky", "midpoint subdivision", "polygons by Sutherland-Hodgman (four clippers)",
        "Weiler-Atherton for concave ones", "curves clipped", "text: all-or-none string",
        "all-or-none character", "text by component",
        "objects in local coordinates placed in a world",
        "view volume from eye, look, up (a vector or an angle), view distance and window size",
        "a window not square to the view axis", "the four steps of the viewing transformation",
        "clipping in homogeneous space against all six planes"}},
      {"8 Filling, characters, sampling",
       {"even-odd test",
        "winding-number test",
        "self-crossing polygons",
        "boundary fill",
        "flood fill",
        "4- and 8-connected",
        "span-based: no stack overflows",
        "recursive fill failing on painted pixels and on its stack",
        "scan-line fill with an active edge table",
        "vertices counted rightly",
        "priority fill (farthest first)",
        "polygons with holes",
        "curve-bounded regions",
        "pattern fill",
        "bitmap fonts",
        "stroke fonts",
        "outline fonts in four steps with dropout control",
        "aliasing shown (a fence that turns to stripes)",
        "supersampling",
        "exact area",
        "Wu lines",
        "filtering",
        "edge-finding blur",
        "halftoning: clustered dots, 2x2 to 8x8",
        "thresholding at one and at several levels",
        "ordered dithering (Bayer)",
        "error diffusion (Floyd-Steinberg, Jarvis, Atkinson)",
        "blue noise",
        "to 1 bit and to a palette of 256"}},
      {"9 Curves and fractals",
       {"continuity none, C0, C1, C2 and G1",
        "convex hull",
        "variation diminishing",
        "axis independence",
        "local against global control",
        "blending functions drawn",
        "conics",
        "piecewise and parametric curves",
        "interpolating and approximating splines",
        "Hermite",
        "Catmull-Rom",
        "natural cubic",
        "Bezier of any degree (de Casteljau, Bernstein, subdivision)",
        "B-splines of any order",
        "uniform, open and given knots",
        "cut into its Bezier pieces",
        "beside a Bezier curve of the same points",
        "NURBS circle",
        "L-systems",
        "Koch curve and snowflake",
        "quadratic Koch",
        "Sierpinski arrowhead",
        "dragon",
        "plants with brackets",
        "Cantor set",
        "Sierpinski triangle and carpet",
        "Sierpinski tetrahedron in 3-D",
        "IFS (fern)",
        "Mandelbrot and Julia with deep zoom",
        "Brownian motion",
        "plasma and midpoint-displacement landscapes",
        "diffusion-limited aggregation",
        "clouds, flames",
        "dendrites",
        "exact, quasi- and statistical self-similarity under magnification",
        "a coastline measured with shrinking rulers",
        "fractal image compression",
        "fractal dimension by similarity",
        "fractal dimension by box counting"}},
      {"Practicals",
       {"practical 1", "practical 2", "practical 3", "practical 4", "practical 5", "practical 6",
        "practical 7", "practical 8", "practical 9", "practical 10", "practical 11",
        "practical 12"}},
  };
  return kRows;
}

TEST(Topics, EveryRowIsNamedInItsChapter) {
  for (const auto& [chapter, rows] : rows_of_chapters()) {
    for (const std::string& row : rows) {
      const auto all = all_demos();
      EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                              [&](const DemoInfo& info) {
                                return info.chapter == chapter &&
                                       std::find(info.topics.begin(), info.topics.end(), row) !=
                                           info.topics.end();
                              }))
          << chapter << ": " << row;
    }
  }
}

// The course's demos are those of its chapters 1 to 9 and its practicals: a chapter whose name is
// misspelt would stand by itself in the gallery.
TEST(Topics, EveryDemoOfTheseChaptersNamesWhatItShows) {
  for (const DemoInfo& info : all_demos()) {
    if (info.chapter == "11 Rendering") continue;
    EXPECT_TRUE(rows_of_chapters().count(std::string(info.chapter))) << info.name;
    EXPECT_FALSE(info.topics.empty()) << info.name;
  }
}

}  // namespace
}  // namespace kinescope
