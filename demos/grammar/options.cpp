#include "demos/grammar/options.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "display/tube/preset.h"
#include "raster/base/error.h"
#include "raster/base/simd.h"

namespace kinescope::grammar {

CLI::Option* add(CLI::App& app, const std::string& names, const std::string& value_name,
                 const std::string& help, const Parse& parse) {
  std::string shown = names;
  std::replace(shown.begin(), shown.end(), ',', '/');
  return app
      .add_option_function<std::string>(
          names, [parse, shown](const std::string& text) { parse(text, shown); }, help)
      ->type_name(value_name)
      ->take_last();
}

void add_choice(CLI::App& app, const std::string& names, std::vector<std::string> words,
                const std::string& help, const std::function<void(std::size_t)>& set) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : "|") + word;
  add(app, names, list, help, [=](const std::string& text, const std::string& option) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] == text) return set(i);
    }
    throw Error(ErrorKind::kUsage, "\"" + text + "\" is not one of " + list, option);
  });
}

void add_common(CLI::App& app, CommonOptions& common) {
  add(app, "--threads", "N", "worker threads (default: one a core)",
      [&](const std::string& text, const std::string& option) {
        common.threads = parse_whole(text, option, 1, 1024);
      });
  std::string targets = "best";
  for (const std::string& target : simd_targets()) targets += ", " + target;
  add(app, "--simd", "NAME", "instruction set: " + targets + " (default: best)",
      [&](const std::string& text, const std::string&) { common.simd = text; });
  add(app, "--seed", "N", "seed of every random number (default: 1)",
      [&](const std::string& text, const std::string& option) {
        common.seed = static_cast<std::uint64_t>(
            parse_whole(text, option, 0, std::numeric_limits<int>::max()));
      });
  app.add_flag("--json", common.json, "print the figures as one JSON object");
  app.add_flag("--quiet", common.quiet, "no warnings, no progress, no remarks");
  app.add_flag("--headless", common.headless, "never open a window");
}

void add_size(CLI::App& app, PictureOptions& picture) {
  add(app, "--size", "WxH", "size of the picture or window (default: 1280x960)",
      [&](const std::string& text, const std::string& option) {
        picture.size = parse_size(text, option);
      });
}

void add_picture(CLI::App& app, PictureOptions& picture, const std::vector<std::string>& formats) {
  const std::string svg = formats.back() == "svg" ? "NAME.svg, " : "";
  add(app, "-o", "OUT", "NAME.png, NAME.y4m, " + svg + "frame_####.png, or - for standard output",
      [&](const std::string& text, const std::string& option) {
        if (text.empty()) throw Error(ErrorKind::kUsage, "the name is empty", option);
        picture.output = text;
      });
  add_size(app, picture);
  add_choice(app, "--format", formats, "what -o holds, whatever its name; raw is RGB, 8 bits each",
             [&picture, formats](std::size_t i) { picture.format = formats[i]; });
  add(app, "--frames", "N|A-B", "a film of frames 0 to N-1, or A to B",
      [&](const std::string& text, const std::string& option) {
        picture.frames = parse_frames(text, option);
      });
  add(app, "--fps", "RATE", "frames a second of a film (default: the display's refresh)",
      [&](const std::string& text, const std::string& option) {
        picture.fps = parse_rate(text, option);
      });
  add(app, "--shutter", "frame|SECONDS",
      "how long each picture gathers light: one refresh (default), or such as 0.004 or 1/240",
      [&](const std::string& text, const std::string& option) {
        picture.shutter = parse_shutter(text, option);
      });
}

void add_display(CLI::App& app, PictureOptions& picture, bool or_bare) {
  std::string known = or_bare ? "none" : "";
  for (const TubePreset& preset : tube_presets()) {
    known += (known.empty() ? "" : ", ") + preset.name;
  }
  add(app, "--display", "PRESET",
      "the tube that shows the picture, a .txt file or one of " + known + " (default: " +
          tube_presets().front().name + ")" + (or_bare ? "; none is a bare render" : ""),
      [&picture, or_bare](const std::string& text, const std::string&) {
        // A file is read later, so that what is wrong in it is no fault of the command line.
        if (!names_preset_file(text) && (!or_bare || text != "none")) find_tube_preset(text);
        picture.display = text;
      });
  add(app, "--set", "KEY=VALUE",
      "changes one setting of the tube: spot.sigma=0.2mm; may be repeated",
      [&picture](const std::string& text, const std::string&) {
        TubeSettings scratch = tube_presets().front().settings;
        override_tube_setting(scratch, text);
        picture.changes.push_back(text);
      })
      ->trigger_on_parse();  // each time that it is given
}

void add_depth(CLI::App& app, PictureOptions& picture) {
  add_choice(app, "--depth", {"8", "16"}, "bits a channel of a PNG (default: 8)",
             [&picture](std::size_t i) { picture.depth_bits = i == 0 ? 8 : 16; });
}

}  // namespace kinescope::grammar
