#include <limits>
#include <string_view>

#include "demos/grammar/commands.h"
#include "demos/grammar/options.h"
#include "raster/base/error.h"

namespace kinescope::grammar {

void add_vector_command(CLI::App& app, Options& options) {
  VectorRequest& request = options.vector;
  app.add_option("IN", request.input,
                 "a Tektronix 4010 or 4014 stream, HP-GL, SVG or stereo WAV, or - for standard "
                 "input")
      ->type_name("");
  std::vector<std::string> kinds{"auto"};
  for (const std::string_view name : vector_kind_names()) kinds.emplace_back(name);
  add_choice(app, "--kind", kinds, "what the input is (default: auto, by its content)",
             [&request](std::size_t i) {
               request.kind.reset();
               if (i > 0) request.kind = static_cast<VectorKind>(i - 1);
             });
  add(app, "-o", "OUT", "NAME.png, NAME.svg, or - for standard output",
      [&](const std::string& text, const std::string& option) {
        if (text.empty()) throw Error(ErrorKind::kUsage, "the name is empty", option);
        options.picture.output = text;
      });
  const std::vector<std::string> formats{"png", "svg"};
  add_choice(app, "--format", formats, "what -o holds, whatever its name",
             [&options, formats](std::size_t i) { options.picture.format = formats[i]; });
  add_size(app, options.picture);
  app.add_flag("--segments", request.segments,
               "print what was decoded, x1 y1 x2 y2 intensity a line, in device units");
  app.add_flag("--texts", request.texts,
               "print the characters: place, advance, height as x y pairs, and the text, a line");
  app.add_flag("--pty", request.pty,
               "be a terminal: print its name, and show what programs draw on it");
  add(app, "--page", "N", "which page, from 0 (default: the last that holds anything)",
      [&](const std::string& text, const std::string& option) {
        request.page = parse_whole(text, option, 0, std::numeric_limits<int>::max());
      });
  add_common(app, options.common);
}

}  // namespace kinescope::grammar
