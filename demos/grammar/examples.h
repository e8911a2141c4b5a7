// What each command's help ends with.
#pragma once

namespace kinescope::grammar {

inline constexpr const char* kGalleryExamples = R"(Examples:
  kinescope                            the gallery of demos, in a window
  kinescope --headless                 the first demo's picture in out/
  kinescope render model.obj -o a.png  a model on a tube, photographed
  kinescope timing 640x480@60          a video mode, interval by interval
Each command explains itself: kinescope render --help)";

inline constexpr const char* kListExamples = R"(Examples:
  kinescope list
  kinescope list --json
  kinescope list --markdown)";

inline constexpr const char* kDemoExamples =
    R"(Without -o a window opens. Script lines: FRAME key NAME, FRAME drag X0 Y0 X1 Y1 FRAMES ...
Examples:
  kinescope demo teapot
  kinescope demo teapot -o teapot.png
  kinescope demo retrace --frames 30 -o retrace.y4m --quiet)";

inline constexpr const char* kRenderExamples = R"(Without -o a window opens: drag to turn the model.
Examples:
  kinescope render model.obj -o model.png
  kinescope render model.obj --display none --shading flat --size 320x240 -o - > model.png
  kinescope render model.obj --turntable --frames 24 --size 320x240 -o turn.y4m)";

inline constexpr const char* kDisplayExamples =
    R"(Without -o a window opens: Space pauses, . steps, [ and ] slow time down and up again.
Examples:
  kinescope display photo.png -o tube.png
  kinescope display pattern:smpte-bars --mode ntsc -o bars.png
  kinescope display film.y4m --fps 240 --shutter 1/240 -o slices.y4m
  kinescope display pattern:crosshatch --mode 240p --shutter 1/4000 -o lines.png)";

inline constexpr const char* kVectorExamples =
    R"(Without -o a window opens. gnuplot draws on a --pty by set output "/dev/pts/N".
Examples:
  gnuplot -e 'set term tek40xx; plot sin(x)' | kinescope vector - -o plot.png
  kinescope vector plot.hpgl -o plot.svg
  kinescope vector drawing.svg --segments
  kinescope vector --pty
  kinescope vector list.txt --kind display-file --machine dvg -o asteroids.png
  kinescope vector --assemble list.txt -o list.bin
  kinescope vector --list-machines)";

inline constexpr const char* kTimingExamples =
    R"(MODE is a name such as 640x480@60, gtf:WxH@HZ, cvt:WxH@HZ, cvtrb:WxH@HZ, or a Modeline.
Examples:
  kinescope timing 640x480@60
  kinescope timing cvt:1024x768@75
  kinescope timing gtf:800x600@72 --json)";

}  // namespace kinescope::grammar
