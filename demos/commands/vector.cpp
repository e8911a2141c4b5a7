#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "demos/commands/commands.h"
#include "demos/console.h"
#include "demos/display_file_input.h"
#include "demos/film.h"
#include "demos/json.h"
#include "demos/model_files.h"
#include "demos/model_view.h"
#include "demos/progress.h"
#include "demos/session.h"
#include "demos/vector_film.h"
#include "demos/vector_view.h"
#include "demos/wire_show.h"
#include "display/presenter.h"
#include "display/vector/beam_move.h"
#include "display/vector/input/read_vectors.h"
#include "display/vector/input/write_svg.h"
#include "display/vector/stroke_list.h"
#include "engine/io/import.h"
#include "raster/base/error.h"
#include "raster/base/output_file.h"
#include "raster/image/codecs.h"

namespace kinescope {
namespace {

/// Of a model, unless told.
constexpr double kCreaseDegrees = 1;
constexpr Seconds kTurn(6);

/// Numbers as they are, the shortest that read back the same.
void print_segments(const VectorDrawing& drawing) {
  OutputFile out("-");
  fmt::memory_buffer text;
  constexpr std::size_t kBlock = 1 << 16;
  for (const VectorSegment& s : drawing.segments) {
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {}\n", s.x1, s.y1, s.x2, s.y2,
                   s.intensity);
    if (text.size() < kBlock) continue;
    out.write(fmt::to_string(text));
    text.clear();
  }
  out.write(fmt::to_string(text));
  out.commit();
}

/// "x y advance_x advance_y up_x up_y text" a line; control characters as spaces.
void print_texts(const VectorDrawing& drawing) {
  std::string lines;
  for (const DrawnText& t : drawing.texts) {
    std::string shown = t.text;
    std::replace_if(
        shown.begin(), shown.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
    lines += fmt::format("{} {} {:.6g} {:.6g} {:.6g} {:.6g} {}\n", t.place.x, t.place.y,
                         t.advance.x, t.advance.y, t.up.x, t.up.y, shown);
  }
  print_result(lines);
}

void print_figures(const Options& options, const std::vector<VectorDrawing>& all) {
  std::uint64_t segments = 0, texts = 0;
  for (const VectorDrawing& page : all) {
    segments += page.segments.size();
    texts += page.texts.size();
  }
  JsonWriter json;
  json.begin_object().member("input", options.vector.input);
  json.member("segments", segments).member("texts", texts);
  json.member("pages", static_cast<std::uint64_t>(all.size()));
  const glm::vec2 size = all.empty() ? VectorDrawing{}.size : all.front().size;
  json.member("width_units", static_cast<double>(size.x));
  json.member("height_units", static_cast<double>(size.y));
  print_result(json.end_object().text());
}

bool asks_for_print(const Options& options) {
  return options.vector.segments || options.vector.texts || options.common.json;
}

/// What was asked for. @return the pages
std::vector<VectorDrawing> print_asked(const Options& options, VectorDrawing drawing) {
  if (options.vector.segments) print_segments(drawing);
  if (options.vector.texts) print_texts(drawing);
  std::vector<VectorDrawing> all = pages(std::move(drawing));
  if (options.common.json) print_figures(options, all);
  return all;
}

/// What the screen shows at the end, or the page that was asked for.
VectorDrawing shown_page(const Options& options, std::vector<VectorDrawing> all,
                         const std::string& name) {
  if (all.empty()) throw_bad_input("draws nothing", name);
  const std::size_t last = all.size() - 1;
  const auto wanted =
      static_cast<std::size_t>(options.vector.page.value_or(static_cast<int>(last)));
  if (wanted > last) {
    throw Error(ErrorKind::kUsage,
                fmt::format("the input has {} pages, counted from 0", all.size()), "--page");
  }
  return std::move(all[wanted]);
}

Size picture_size(const Options& options) { return options.picture.size.value_or(Size{1280, 960}); }

bool wants_svg(const Options& options, const std::string& output) {
  if (!options.picture.format.empty()) return options.picture.format == "svg";
  return std::filesystem::path(output).extension() == ".svg";
}

/// What is shown, and on what.
struct Shown {
  VectorDrawing page;                          ///< of a display file: one refresh of it
  const VectorMachine* machine = nullptr;      ///< that runs the program; none: a drawing
  std::shared_ptr<const DisplayFile> program;  ///< of a machine
  std::optional<WireRequest> wire;             ///< a model
  std::string name;
  bool stored = false;  ///< drawn on a storage tube, as Tektronix terminals did
  VectorShow show(Size size, Workers& workers) const {
    if (wire) return wire_show(*wire, size, workers);
    if (machine != nullptr) return processor_show(*machine, program, size, name);
    return stored ? storage_show(page, size) : refreshed_show(page, size);
  }
};

/// The finished screen on paper.
void write_hard_copy(const Options& options, const Shown& shown, const std::string& output) {
  if (!shown.stored) {
    throw Error(ErrorKind::kUsage, "only what a storage tube keeps can be copied", "--hard-copy");
  }
  Workers workers(options.common.threads);
  const VectorShow show = shown.show(picture_size(options), workers);
  show.expose(show.settled, workers);
  write_png(output, show.hard_copy());
}

/// Before anything is drawn. @return what a picture that is no SVG is written as
FilmFormat check_picture(const Options& options, const std::string& output) {
  check_writable(output);
  const bool svg = wants_svg(options, output), copy = options.vector.hard_copy;
  if (svg && !copy) return FilmFormat::kPng;
  const bool several = options.picture.frames.has_value();
  const FilmFormat format =
      svg ? FilmFormat::kRaw : film_format(output, options.picture.format, several);
  if (copy && (several || format != FilmFormat::kPng)) {
    throw Error(ErrorKind::kUsage, "a copy is one picture, a PNG", "--hard-copy");
  }
  check_output(options, format);
  return format;
}

void write_picture(const Options& options, const Shown& shown, const std::string& output) {
  const FilmFormat format = check_picture(options, output);
  if (options.vector.hard_copy) return write_hard_copy(options, shown, output);
  if (wants_svg(options, output)) return write_svg(output, shown.page);
  const bool several = options.picture.frames.has_value();
  const Size size = picture_size(options);
  check_memory(size, 64.0 * size.width * size.height +
                         static_cast<double>(shown.page.segments.size()) * 2 * sizeof(BeamMove));
  Workers workers(options.common.threads);
  VectorFilm shots(vector_shot(options), shown.show(size, workers), workers);
  Film film(output, format, size, shots.rate());
  Progress progress("photographing", several ? options.picture.frames->count() : 1,
                    several && !options.common.quiet);
  for (int done = 1; shots.shoot(film); ++done) progress.done(done);
  film.close();
}

std::string stem_of(const std::string& input) {
  return input == "-" ? "vector" : std::filesystem::path(input).stem().string();
}

bool wants_window(const Options& options) {
  return options.picture.output.empty() && !options.common.headless && Presenter::available();
}

int open_window(const Options& options, const DemoInfo& view) {
  const Size size = picture_size(options);
  return run_demo_window(view,
                         {size.width, size.height, options.common.seed, options.common.threads});
}

/// The page, or what the terminal shows at last, to its file.
void finish(const Options& options, const Shown& shown, const std::string& stem) {
  std::string output = options.picture.output;
  if (output.empty()) output = output_in_out(stem, options.picture.frames.has_value());
  write_picture(options, shown, output);
  if (options.picture.output.empty()) print_remark("wrote " + output, options.common.quiet);
}

/// What is drawn or translated is no model, so that nothing heeds the options for one.
/// @param name of the input
void refuse_model_options(const Options& options, const std::string& name) {
  const VectorRequest& v = options.vector;
  const RenderOptions& r = options.render;
  const std::array<std::pair<bool, const char*>, 9> given{
      {{v.hidden_removed, "--hidden"},
       {v.crease_deg.has_value(), "--crease"},
       {v.turn.has_value(), "--turn"},
       {r.azimuth_deg.has_value(), "--azimuth"},
       {r.elevation_deg.has_value(), "--elevation"},
       {r.fov_deg.has_value(), "--fov"},
       {r.eye.has_value(), "--eye"},
       {r.look.has_value(), "--look"},
       {r.up.has_value(), "--up"}}};
  for (const auto& [is_given, option] : given) {
    if (is_given) throw Error(ErrorKind::kUsage, "is for models, and " + name + " is none", option);
  }
}

/// Prints the terminal's name at once; then draws live, or until its last user has left.
int run_terminal(const Options& options) {
  refuse_model_options(options, "a terminal's picture");
  const auto terminal = std::make_shared<VectorTerminal>(options.vector.kind);
  if (!options.picture.output.empty()) check_picture(options, options.picture.output);
  print_result(terminal->name() + "\n");
  if (wants_window(options)) return open_window(options, vector_view(terminal));
  const auto copier = [&](const VectorDrawing& page) {
    Workers workers(options.common.threads);
    copy_to_paper(page, picture_size(options), workers);
  };
  while (!terminal->finished()) terminal->poll(20, copier);
  print_asked(options, terminal->drawing());
  if (options.picture.output.empty() && asks_for_print(options)) return 0;
  Shown shown;
  shown.page = terminal->drawing();
  shown.stored = terminal->stores();
  finish(options, shown, "vector");
  return 0;
}

int list_machines(const Options& options) {
  std::string table;
  JsonWriter json;
  json.begin_array();
  for (const VectorMachine& m : vector_machines()) {
    table += fmt::format("{:8}  {:>4} x {:<4}  {:5}  {}\n", m.name, m.width, m.height, m.phosphor,
                         m.note);
    json.begin_object().member("name", m.name).member("width", m.width).member("height", m.height);
    json.member("words", m.words).member("phosphor", m.phosphor).member("note", m.note);
    json.end_object();
  }
  print_result(options.common.json ? json.end_array().text() : table);
  return 0;
}

/// A model before its camera. It turns where more than one moment of it is shown.
WireRequest wire_request(const Options& options, const std::string& path) {
  RenderOptions render = options.render;
  render.models = {path};
  render = with_up_of_files(render);
  Warnings warnings;
  const Scene scene = upright_scene(import_models(render.models, warnings), render);
  print_warnings(warnings, options.common.quiet);
  WireRequest wire;
  wire.machine = find_vector_machine(options.vector.machine);
  const double aspect = static_cast<double>(wire.machine.width) / wire.machine.height;
  wire.style.hidden_removed = options.vector.hidden_removed;
  wire.style.crease_rad = static_cast<float>(options.vector.crease_deg.value_or(kCreaseDegrees) *
                                             std::numbers::pi / 180);
  const Seconds turn = options.vector.turn.value_or(kTurn);
  const bool turns = (options.picture.frames || wants_window(options)) && turn > Seconds(0);
  wire.model = std::make_shared<WireModel>(scene, model_camera(scene, render, aspect, turns));
  if (turns) wire.turn_rad_per_s = 2 * std::numbers::pi / turn.count();
  return wire;
}

std::vector<VectorSegment> strokes_of(const Options& options, const WireRequest& wire) {
  Workers workers(options.common.threads);
  return wire.model->strokes(0, wire.style, wire.machine, workers);
}

bool is_model(const VectorRequest& request, InputFile& input) {
  if (request.kind || request.display_file) return false;
  return request.model || looks_like_model(input.name(), input.peek(kRecogniseBytes));
}

bool is_display_file(const VectorRequest& request, InputFile& input) {
  if (request.kind || request.model || request.display_file) return request.display_file;
  const auto first = input.peek(kRecogniseBytes);
  const InstructionSet& set = instruction_set(find_vector_machine(request.machine).words);
  return looks_like_display_file(first, first.size() < kRecogniseBytes, set);
}

/// A display file, or the list that a model makes.
DisplayFile file_to_translate(const Options& options, InputFile& input, bool to_words) {
  const VectorMachine& machine = find_vector_machine(options.vector.machine);
  if (!to_words || !is_model(options.vector, input)) {
    refuse_model_options(options, input.name());
    return read_display_file(input, instruction_set(machine.words), to_words);
  }
  DisplayFile file;
  file.words =
      stroke_list(strokes_of(options, wire_request(options, options.vector.assemble)), machine);
  return file;
}

/// Text or a model to words, or words to text.
int translate(const Options& options) {
  const bool to_words = !options.vector.assemble.empty();
  const InstructionSet& set = instruction_set(find_vector_machine(options.vector.machine).words);
  InputFile input(to_words ? options.vector.assemble : options.vector.disassemble);
  const DisplayFile file = file_to_translate(options, input, to_words);
  const std::string& output = options.picture.output;
  const bool binary = to_words && !output.empty();
  if (binary && file.start != 0) {
    print_warnings({fmt::format("words are run from address 0; \"start\" is {}", file.start)},
                   options.common.quiet);
  }
  OutputFile out(output.empty() ? "-" : output);
  out.write(binary ? words_as_bytes(file.words, set) : disassemble(file.words, set));
  out.commit();
  return 0;
}

void check_one_task(const VectorRequest& request) {
  std::vector<std::string> tasks;
  if (!request.input.empty()) tasks.push_back(request.input);
  if (!request.assemble.empty()) tasks.emplace_back("--assemble");
  if (!request.disassemble.empty()) tasks.emplace_back("--disassemble");
  if (request.pty) tasks.emplace_back("--pty");
  if (tasks.size() < 2) return;
  throw Error(ErrorKind::kUsage, "is an input of its own; leave out " + tasks.front(),
              tasks.back());
}

/// What is to be shown; figures that were asked for are printed.
Shown read_input(const Options& options) {
  const VectorRequest& request = options.vector;
  InputFile input(request.input);
  Shown shown;
  shown.name = input.name();
  VectorDrawing drawing;
  const bool model = is_model(request, input);
  if (!model) refuse_model_options(options, input.name());
  if (model) {
    shown.wire = wire_request(options, request.input);
    drawing.size = {shown.wire->machine.width, shown.wire->machine.height};
    drawing.segments = strokes_of(options, *shown.wire);
  } else if (is_display_file(request, input)) {
    shown.machine = &find_vector_machine(request.machine);
    const InstructionSet& set = instruction_set(shown.machine->words);
    shown.program = std::make_shared<DisplayFile>(read_display_file(input, set, std::nullopt));
    drawing = one_refresh(*shown.machine, *shown.program, shown.name);
  } else {
    const auto kind = request.kind ? request.kind : recognise_vectors(input.peek(kRecogniseBytes));
    shown.stored = kind == VectorKind::kTek;
    Warnings warnings;
    drawing = read_vectors(input, request.kind, &warnings);
    print_warnings(warnings, options.common.quiet);
  }
  std::vector<VectorDrawing> all = print_asked(options, std::move(drawing));
  if (options.picture.output.empty() && asks_for_print(options)) return shown;
  shown.page = shown_page(options, std::move(all), input.name());
  return shown;
}

}  // namespace

int run_vector(const Options& options) {
  const VectorRequest& request = options.vector;
  if (request.list_machines) return list_machines(options);
  check_one_task(request);
  if (!request.assemble.empty() || !request.disassemble.empty()) return translate(options);
  if (request.pty) return run_terminal(options);
  if (request.input.empty()) {
    throw Error(ErrorKind::kUsage,
                "nothing to draw: name a Tektronix, HP-GL, SVG or WAV file, a display file or a "
                "model, - for "
                "standard input, or --pty");
  }
  const Shown shown = read_input(options);
  if (options.picture.output.empty() && asks_for_print(options)) return 0;
  if (wants_window(options)) {
    return open_window(options, vector_view([shown](Size size, Workers& workers) {
                         return shown.show(size, workers);
                       }));
  }
  finish(options, shown, stem_of(request.input));
  return 0;
}

}  // namespace kinescope
