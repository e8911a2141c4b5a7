#include "demos/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "demos/grammar/commands.h"
#include "demos/grammar/examples.h"
#include "demos/grammar/options.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

using namespace grammar;

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
    list.add_flag("--markdown", options.list.markdown,
                  "the gallery's page of the documentation: docs/gallery.md");
    add(list, "--pictures", "FOLDER", "draw each demo's small picture there, as NAME.png",
        [this](const std::string& text, const std::string&) { options.list.pictures = text; });
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
  Grammar program;
  const auto hint = [&] {
    CLI::App& app = program.current();
    return std::string("; try kinescope ") +
           (app.get_name() == "kinescope" ? "" : app.get_name() + " ") + "--help";
  };
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Answer{program.help()};
  } catch (const CLI::CallForVersion&) {
    return Answer{program.version()};
  } catch (const CLI::ParseError& fault) {
    if (const std::string word = program.unknown_command(); !word.empty()) {
      throw Error(ErrorKind::kUsage, "no command is called \"" + word + "\"" + hint());
    }
    throw Error(ErrorKind::kUsage, first_line(fault.what()) + hint());
  } catch (const Error& fault) {
    throw Error(ErrorKind::kUsage, fault.what() + hint());
  }
  return program.options;
}

}  // namespace kinescope
