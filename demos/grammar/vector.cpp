#include <limits>
#include <string_view>

#include "demos/grammar/commands.h"
#include "demos/grammar/options.h"
#include "display/vector/machine.h"
#include "raster/base/error.h"

namespace kinescope::grammar {
namespace {

/// What concerns display files alone.
void add_display_files(CLI::App& app, VectorRequest& request) {
  std::string machines;
  for (const VectorMachine& machine : vector_machines()) {
    machines += (machines.empty() ? "" : ", ") + machine.name;
  }
  add(app, "--machine", "NAME",
      "the display machine that runs a display file: " + machines + " (default: generic)",
      [&](const std::string& text, const std::string&) {
        request.machine = find_vector_machine(text).name;
      });
  app.add_flag("--list-machines", request.list_machines, "list the machines and leave");
  add(app, "--assemble", "FILE",
      "translate a display file's text, or a model's wireframe, into words (-o), or print it with "
      "its addresses",
      [&](const std::string& text, const std::string&) { request.assemble = text; });
  add(app, "--disassemble", "FILE", "print a display file's words as text",
      [&](const std::string& text, const std::string&) { request.disassemble = text; });
}

/// What concerns models alone.
void add_models(CLI::App& app, Options& options) {
  VectorRequest& request = options.vector;
  app.add_flag("--hidden", request.hidden_removed, "remove a model's hidden lines");
  add(app, "--crease", "DEGREES",
      "leave out edges where a model's surface bends less, but for outlines; 0: none (default: 1)",
      [&](const std::string& text, const std::string& option) {
        request.crease_deg = parse_number(text, option);
        if (*request.crease_deg >= 0 && *request.crease_deg <= 180) return;
        throw Error(ErrorKind::kUsage, text + " is not between 0 and 180", option);
      });
  add(app, "--turn", "SECONDS",
      "so long a model takes to turn once in a film or a window; 0: it stands (default: 6)",
      [&](const std::string& text, const std::string& option) {
        request.turn = parse_start(text, option);
      });
  add_camera(app, options.render);
}

void add_exposure(CLI::App& app, Options& options) {
  add(app, "--gain", "G|auto",
      "brightness: the light times G, or (auto, default) light over the shutter's length",
      [&](const std::string& text, const std::string& option) {
        options.vector.gain = parse_gain(text, option);
      });
  add(app, "--start", "SECONDS", "when the first picture is taken (default: 0, as drawing begins)",
      [&](const std::string& text, const std::string& option) {
        options.vector.start = parse_start(text, option);
      });
  add_depth(app, options.picture);
}

}  // namespace

void add_vector_command(CLI::App& app, Options& options) {
  VectorRequest& request = options.vector;
  app.add_option(
         "IN", request.input,
         "a Tektronix 4010 or 4014 stream, HP-GL, SVG, stereo WAV, a display file, or a model as "
         "of render; - for standard input")
      ->type_name("");
  std::vector<std::string> kinds{"auto"};
  for (const std::string_view name : vector_kind_names()) kinds.emplace_back(name);
  kinds.insert(kinds.end(), {"display-file", "model"});
  add_choice(app, "--kind", kinds, "what the input is (default: auto, by its content)",
             [&request](std::size_t i) {
               request.kind.reset();
               const std::size_t known = vector_kind_names().size();
               request.display_file = i == known + 1;
               request.model = i == known + 2;
               if (i > 0 && i <= known) request.kind = static_cast<VectorKind>(i - 1);
             });
  add_picture(app, options.picture, {"png", "y4m", "raw", "svg"});
  add_exposure(app, options);
  add_display_files(app, request);
  add_models(app, options);
  app.add_flag("--segments", request.segments,
               "print what was decoded, x1 y1 x2 y2 intensity a line, in device units");
  app.add_flag("--texts", request.texts,
               "print the characters: place, advance, height as x y pairs, and the text, a line");
  app.add_flag("--pty", request.pty,
               "be a terminal: print its name, and show what programs draw on it");
  app.add_flag("--hard-copy", request.hard_copy,
               "write what a copier puts on paper of a Tektronix screen, instead of a photograph");
  add(app, "--page", "N", "which page, from 0 (default: the last that holds anything)",
      [&](const std::string& text, const std::string& option) {
        request.page = parse_whole(text, option, 0, std::numeric_limits<int>::max());
      });
  add_common(app, options.common);
}

}  // namespace kinescope::grammar
