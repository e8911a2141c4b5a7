#include <array>

#include "demos/grammar/commands.h"
#include "demos/grammar/options.h"
#include "display/video_mode.h"

namespace kinescope::grammar {
namespace {

/// What says how the input is to be read.
void add_input(CLI::App& app, DisplayRequest& request) {
  app.add_option("IN", request.input,
                 "a PNG or JPEG, a y4m film, frame_####.png, pattern:NAME, or - for standard input")
      ->type_name("");
  add(app, "--raw", "FMT:WxH@RATE",
      "the input is video without headers, such as rgb24:640x480@60; FMT is " + raw_format_names(),
      [&](const std::string& text, const std::string& option) {
        request.raw = parse_raw_video(text, option);
      });
  add(app, "--input-fps", "RATE",
      "pictures a second of the input (default: as it says; a sequence: the display's refresh)",
      [&](const std::string& text, const std::string& option) {
        request.input_rate = parse_rate(text, option);
      });
  add_choice(app, "--matrix", {"auto", "601", "709"},
             "a video's colours: BT.601 or BT.709 (default: as it says, or by its size)",
             [&](std::size_t i) {
               if (i == 0) request.matrix.reset();
               if (i > 0) request.matrix = i == 1 ? YuvMatrix::kBt601 : YuvMatrix::kBt709;
             });
  add_choice(app, "--signal", {"picture", "drive"},
             "what the input's codes are: sRGB, gamma-corrected for the tube (default), or the "
             "guns' drive, as old computers sent it",
             [&](std::size_t i) { request.gun_drive = i == 1; });
  add_choice(app, "--fit", {"inside", "fill", "native"},
             "in its own shape (default), stretched to the face, or pixel for pixel",
             [&](std::size_t i) {
               request.fit = std::array{Fit::kInside, Fit::kFill, Fit::kNative}[i];
             });
}

}  // namespace

void add_display_command(CLI::App& app, Options& options) {
  DisplayRequest& request = options.display;
  add_input(app, request);
  add_picture(app, options.picture);
  add_display(app, options.picture, false);
  app.add_flag("--list-presets", request.list_presets, "list the displays and leave");
  add(app, "--mode", "MODE", "a video mode, as timing takes it, instead of the preset's",
      [&](const std::string& text, const std::string&) {
        parse_mode(text).check();
        request.mode = text;
      });
  add(app, "--aspect", "W:H", "shape of the tube's face (default: 4:3)",
      [&](const std::string& text, const std::string& option) {
        request.aspect = parse_aspect(text, option);
      });
  add(app, "--gain", "G|auto",
      "brightness: light over the refresh period times G, or (auto, default) light over the "
      "shutter's length, so that short exposures are not black",
      [&](const std::string& text, const std::string& option) {
        request.gain = parse_gain(text, option);
      });
  add(app, "--start", "SECONDS", "when the first picture is taken (default: 0)",
      [&](const std::string& text, const std::string& option) {
        request.start = parse_start(text, option);
      });
  add_depth(app, options.picture);
  add_common(app, options.common);
}

}  // namespace kinescope::grammar
