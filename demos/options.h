// What a user can ask for, parsed; free of the command-line library.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demos/picture.h"
#include "raster/base/units.h"
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

/// What `demo` alone takes.
struct DemoRequest {
  std::string name;
  std::string script;  ///< a file of inputs, or empty
};

enum class Command { kGallery, kList, kDemo, kRender, kTiming };

struct Options {
  Command command = Command::kGallery;
  CommonOptions common;
  PictureOptions picture;
  RenderOptions render;
  DemoRequest demo;
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
/// "1,2.5,-3"
glm::vec3 parse_vector(std::string_view text, const std::string& option);

}  // namespace kinescope
