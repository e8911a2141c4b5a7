#include "demos/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <utility>

#include "display/tube/preset.h"
#include "raster/base/error.h"
#include "raster/base/simd.h"

namespace kinescope {
namespace {

using Parse = std::function<void(const std::string& text, const std::string& option)>;

/// An option whose text a parser of our own takes; `names` as CLI11 has them ("-o,--output").
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

/// One of a few words; `set` gets its index.
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

void add_picture(CLI::App& app, PictureOptions& picture) {
  add(app, "-o", "OUT", "NAME.png, NAME.y4m, frame_####.png, or - for standard output",
      [&](const std::string& text, const std::string& option) {
        if (text.empty()) throw Error(ErrorKind::kUsage, "the name is empty", option);
        picture.output = text;
      });
  add_size(app, picture);
  const std::vector<std::string> formats{"png", "y4m", "raw"};
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

/// @param or_bare whether the picture may also be left as it is
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

void add_camera(CLI::App& app, RenderOptions& render) {
  const auto angle = [&app](const std::string& name, const std::string& help,
                            std::optional<double>& to, double least, double most) {
    add(app, name, "DEGREES", help,
        [&to, least, most](const std::string& text, const std::string& option) {
          to = parse_number(text, option);
          if (*to >= least && *to <= most) return;
          throw Error(ErrorKind::kUsage,
                      text + " is not between " + std::to_string(std::lround(least)) + " and " +
                          std::to_string(std::lround(most)),
                      option);
        });
  };
  angle("--azimuth", "camera's angle about the vertical, from +z (default: 34)", render.azimuth_deg,
        -3600, 3600);
  angle("--elevation", "camera's angle above the horizon (default: 20)", render.elevation_deg, -90,
        90);
  angle("--fov", "vertical field of view (default: 40)", render.fov_deg, 1, 170);
  const auto vector = [&app](const std::string& name, const std::string& help,
                             std::optional<glm::vec3>& to) {
    add(app, name, "X,Y,Z", help, [&to](const std::string& text, const std::string& option) {
      to = parse_vector(text, option);
    });
  };
  vector("--eye", "where the camera stands (default: where all is seen)", render.eye);
  vector("--look", "the point it looks at (default: the middle)", render.look);
  vector("--up", "which way is up in the model (default: 0,0,1 for STL, else 0,1,0)", render.up);
}

void add_render(CLI::App& app, Options& options) {
  RenderOptions& render = options.render;
  app.add_option("MODEL", render.models,
                 "glTF, GLB, OBJ, PLY, STL or OFF; several stand side by side along x, scaled to "
                 "one size")
      ->required()
      ->type_name("");
  add_picture(app, options.picture);
  add_display(app, options.picture, true);
  add_depth(app, options.picture);
  add_choice(app, "--shading", {"flat", "gouraud", "phong", "blinn", "unlit", "wireframe"},
             "how surfaces are lit (default: phong)", [&render](std::size_t i) {
               constexpr std::array kModels{ShadingModel::kFlat, ShadingModel::kGouraud,
                                            ShadingModel::kPhong, ShadingModel::kBlinn,
                                            ShadingModel::kUnlit};
               if (i == kModels.size()) render.wireframe = true;
               if (i < kModels.size()) render.shading = kModels[i];
             });
  app.add_flag("--wireframe", render.wireframe, "edges only");
  add_choice(app, "--samples,--aa", {"1", "4", "8"}, "samples a pixel (default: 4)",
             [&render](std::size_t i) {
               render.samples = std::array{1, 4, 8}[i];
             });
  add_camera(app, render);
  app.add_flag("--turntable", render.turntable,
               "a film of exactly one turn in --frames (default: six seconds)");
  add_common(app, options.common);
}

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

constexpr const char* kGalleryExamples = R"(Examples:
  kinescope                            the gallery of demos, in a window
  kinescope --headless                 the first demo's picture in out/
  kinescope render model.obj -o a.png  a model on a tube, photographed
  kinescope timing 640x480@60          a video mode, interval by interval
Each command explains itself: kinescope render --help)";

constexpr const char* kListExamples = R"(Examples:
  kinescope list
  kinescope list --json)";

constexpr const char* kDemoExamples =
    R"(Without -o a window opens. Script lines: FRAME key NAME, FRAME drag X0 Y0 X1 Y1 FRAMES ...
Examples:
  kinescope demo teapot
  kinescope demo teapot -o teapot.png
  kinescope demo retrace --frames 30 -o retrace.y4m --quiet)";

constexpr const char* kRenderExamples = R"(Without -o a window opens: drag to turn the model.
Examples:
  kinescope render model.obj -o model.png
  kinescope render model.obj --display none --shading flat --size 320x240 -o - > model.png
  kinescope render model.obj --turntable --frames 24 --size 320x240 -o turn.y4m)";

constexpr const char* kDisplayExamples =
    R"(Without -o a picture is shown in a window; a film is written to out/.
Examples:
  kinescope display photo.png -o tube.png
  kinescope display pattern:smpte-bars --mode ntsc -o bars.png
  kinescope display film.y4m --fps 240 --shutter 1/240 -o slices.y4m
  kinescope display pattern:crosshatch --mode 240p --shutter 1/4000 -o lines.png)";

constexpr const char* kVectorExamples =
    R"(Without -o a window opens. gnuplot draws on a --pty by set output "/dev/pts/N".
Examples:
  gnuplot -e 'set term tek40xx; plot sin(x)' | kinescope vector - -o plot.png
  kinescope vector plot.hpgl -o plot.svg
  kinescope vector drawing.svg --segments
  kinescope vector --pty)";

constexpr const char* kTimingExamples =
    R"(MODE is a name such as 640x480@60, gtf:WxH@HZ, cvt:WxH@HZ, cvtrb:WxH@HZ, or a Modeline.
Examples:
  kinescope timing 640x480@60
  kinescope timing cvt:1024x768@75
  kinescope timing gtf:800x600@72 --json)";

/// The whole grammar. Values land in `options` while CLI11 parses.
class Grammar {
 public:
  Grammar() {
    app_.set_version_flag("--version", "kinescope " KINESCOPE_VERSION,
                          "print the version and leave");
    app_.option_defaults()->take_last();
    app_.require_subcommand(0, 1);
    app_.footer(kGalleryExamples);
    app_.get_formatter()->column_width(34);
    app_.set_help_flag("-h,--help", "print this and leave");
    add_size(app_, options.picture);
    add_common(app_, options.common);

    CLI::App& list =
        command("list", "the demos: name, chapter, one line", Command::kList, kListExamples);
    add_common(list, options.common);
    CLI::App& demo =
        command("demo", "one demo, in a window or to a file", Command::kDemo, kDemoExamples);
    demo.add_option("NAME", options.demo.name, "as kinescope list names it")
        ->required()
        ->type_name("");
    add(demo, "--script", "FILE", "inputs for the demo; - is standard input",
        [this](const std::string& text, const std::string&) { options.demo.script = text; });
    add_picture(demo, options.picture);
    add_common(demo, options.common);
    add_render(command("render", "models to a picture or a film, through a display or bare",
                       Command::kRender, kRenderExamples),
               options);
    add_display_command(command("display", "a picture or a film through a raster tube",
                                Command::kDisplay, kDisplayExamples),
                        options);
    add_vector_command(command("vector", "plots and drawings, stroke by stroke", Command::kVector,
                               kVectorExamples),
                       options);
    CLI::App& timing = command("timing",
                               "a video mode: every interval in pixels, lines and "
                               "microseconds",
                               Command::kTiming, kTimingExamples);
    timing.add_option("MODE", options.mode, "the mode, see below")->required()->type_name("");
    add_common(timing, options.common);
  }

  /// The command that is being parsed, or the program itself.
  CLI::App& current() {
    const auto chosen = app_.get_subcommands();
    return chosen.empty() ? app_ : *chosen.front();
  }
  void parse(int argc, const char* const* argv) { app_.parse(argc, argv); }
  std::string help() {
    CLI::App& app = current();
    return app.help(&app == &app_ ? "" : app_.get_name());
  }
  /// The word that stands where a command should, if one does.
  std::string unknown_command() {
    if (&current() != &app_) return {};
    const auto words = app_.remaining();
    const auto is_option = [](const std::string& word) { return word.starts_with('-'); };
    if (!words.empty() && std::none_of(words.begin(), words.end(), is_option)) return words.front();
    return {};
  }
  std::string version() const { return app_.version() + "\n"; }

  Options options;

 private:
  CLI::App& command(const std::string& name, const std::string& what, Command id,
                    const char* examples) {
    CLI::App& app = *app_.add_subcommand(name, what);
    app.parse_complete_callback([this, id] { options.command = id; });
    app.footer(examples);
    return app;
  }

  CLI::App app_{
      "kinescope draws geometry in software, shows it on a simulated display, and photographs the "
      "light.\nWith no command: the gallery of demos, in a window.",
      "kinescope"};
};

/// One line of CLI11's message.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

std::variant<Options, Answer> parse_command_line(int argc, const char* const* argv) {
  Grammar grammar;
  const auto hint = [&] {
    CLI::App& app = grammar.current();
    return std::string("; try kinescope ") +
           (app.get_name() == "kinescope" ? "" : app.get_name() + " ") + "--help";
  };
  try {
    grammar.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Answer{grammar.help()};
  } catch (const CLI::CallForVersion&) {
    return Answer{grammar.version()};
  } catch (const CLI::ParseError& fault) {
    if (const std::string word = grammar.unknown_command(); !word.empty()) {
      throw Error(ErrorKind::kUsage, "no command is called \"" + word + "\"" + hint());
    }
    throw Error(ErrorKind::kUsage, first_line(fault.what()) + hint());
  } catch (const Error& fault) {
    throw Error(ErrorKind::kUsage, fault.what() + hint());
  }
  return grammar.options;
}

}  // namespace kinescope
