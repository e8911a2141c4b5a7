// What a user can ask for, parsed; free of the command-line library.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demos/picture.h"
#include "display/vector/input/read_vectors.h"
#include "raster/base/units.h"
#include "raster/image/video.h"
#include "shading/surface.h"

namespace kinescope {

/// Frames `first` to `last` of a film, both drawn, counted from 0.
struct FrameRange {
  int first = 0, last = 0;
  int count() const { return last - first + 1; }
};

/// What every command takes.
struct CommonOptions {
  int threads = 0;            ///< 0: one a core
  std::string simd = "best";  ///< as use_simd_target takes it
  std::uint64_t seed = 1;
  bool json = false;
  bool quiet = false;
  bool headless = false;
};

/// Where pictures go, and how they are photographed.
struct PictureOptions {
  std::string output;  ///< empty: a window
  std::string format;  ///< png, y4m or raw; empty: by the output's ending
  std::optional<Size> size;
  std::optional<FrameRange> frames;
  std::optional<Rate> fps;             ///< of a film; none: the display's refresh
  std::optional<Seconds> shutter;      ///< none: one refresh of the display
  std::optional<std::string> display;  ///< a preset, or "none"; none given: the command's default
  std::vector<std::string> changes;    ///< to it: "spot.sigma=0.2mm"
  int depth_bits = 8;                  ///< of a PNG channel: 8 or 16
};

/// What `render` alone takes.
struct RenderOptions {
  std::vector<std::string> models;
  ShadingModel shading = ShadingModel::kPhong;
  bool wireframe = false;
  int samples = 4;
  std::optional<double> azimuth_deg, elevation_deg, fov_deg;
  std::optional<glm::vec3> eye, look, up;
  bool turntable = false;
};

/// How a picture lies on a raster of another size.
enum class Fit {
  kInside,  ///< as large as it can be, in its own shape
  kFill,    ///< stretched to the whole face
  kNative,  ///< pixel for pixel, centred, cut off where it is larger
};

/// "rgb24:640x480@60": video without headers.
struct RawVideo {
  VideoFormat format;
  Rate rate;
};

/// What `display` alone takes.
struct DisplayRequest {
  std::string input;  ///< a file, frame_####.png, pattern:NAME, or - for standard input
  std::optional<RawVideo> raw;
  std::optional<YuvMatrix> matrix;  ///< of a video; none: as it says, or the usual one
  std::optional<Rate> input_rate;   ///< none: as the input says, or the display's refresh
  std::optional<bool> gun_drive;    ///< whether codes are the guns' signal; none: patterns alone
  std::optional<std::string> mode;  ///< instead of the preset's
  Fit fit = Fit::kInside;
  std::optional<double> aspect;  ///< width over height of the tube's face; none: the preset's
  std::optional<double> gain;    ///< none: by the shutter's length
  Seconds start{0};
  bool list_presets = false;
};

/// What `vector` alone takes.
struct VectorRequest {
  std::string input;                     ///< a file, or - for standard input
  std::optional<VectorKind> kind;        ///< none: by its content
  std::optional<int> page;               ///< from 0; none: the last that holds anything
  bool segments = false, texts = false;  ///< print them
  bool pty = false;                      ///< the input is a terminal that programs draw on
  bool display_file = false;             ///< the input is a display processor's program
  bool model = false;                    ///< the input is a model; see also RenderOptions
  bool hidden_removed = false;           ///< of a model: only edges in sight
  std::optional<double> crease_deg;      ///< of a model: edges that bend less are left out
  std::optional<Seconds> turn;           ///< so long a model takes to turn once; 0: it stands
  std::string machine = "generic";       ///< that runs display files
  std::string assemble, disassemble;     ///< a file to translate, or empty
  bool list_machines = false;
  bool hard_copy = false;      ///< of a storage screen, instead of a photograph
  std::optional<double> gain;  ///< none: by the shutter's length
  Seconds start{0};
};

/// What `list` alone takes.
struct ListRequest {
  bool markdown = false;  ///< the gallery's page
  std::string pictures;   ///< a folder to draw the demos' pictures in, or empty
};

/// What `demo` alone takes.
struct DemoRequest {
  std::string name;
  std::string script;  ///< a file of inputs, or empty
};

enum class Command { kGallery, kList, kDemo, kRender, kDisplay, kVector, kTiming };

struct Options {
  Command command = Command::kGallery;
  CommonOptions common;
  PictureOptions picture;
  RenderOptions render;
  DisplayRequest display;
  VectorRequest vector;
  DemoRequest demo;
  ListRequest list;
  std::string mode;  ///< what `timing` explains
};

/// Parsers of single options. Each takes the option's name for its message.
/// @throws Error (usage)
int parse_whole(std::string_view text, const std::string& option, int least, int most);
double parse_number(std::string_view text, const std::string& option);
/// "640x480"
Size parse_size(std::string_view text, const std::string& option);
/// "60" is 0-59; "10-19"
FrameRange parse_frames(std::string_view text, const std::string& option);
/// "60", "59.94", "60000/1001"
Rate parse_rate(std::string_view text, const std::string& option);
/// "frame" (nothing is returned), "0.004", "1/240"
std::optional<Seconds> parse_shutter(std::string_view text, const std::string& option);
/// A time in seconds, 0 or later
Seconds parse_start(std::string_view text, const std::string& option);
/// "auto" (nothing is returned), or a factor above 0
std::optional<double> parse_gain(std::string_view text, const std::string& option);
/// "16:9", "4/3", "1.333"
double parse_aspect(std::string_view text, const std::string& option);
/// "rgb24:640x480@60"
RawVideo parse_raw_video(std::string_view text, const std::string& option);
/// "1,2.5,-3"
glm::vec3 parse_vector(std::string_view text, const std::string& option);

}  // namespace kinescope
