#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "demos/commands/commands.h"
#include "demos/console.h"
#include "demos/display_film.h"
#include "demos/film_window.h"
#include "demos/progress.h"
#include "display/presenter.h"
#include "display/tube/preset.h"
#include "raster/base/error.h"
#include "raster/base/simd.h"

namespace kinescope {
namespace {

std::string presets_as_json() {
  JsonWriter json;
  json.begin_array();
  for (const TubePreset& preset : tube_presets()) {
    json.begin_object().member("name", preset.name).member("mode", preset.mode_name);
    json.member("phosphor", preset.settings.phosphor).member("note", preset.note).end_object();
  }
  return json.end_array().text();
}

std::string presets_as_table() {
  std::size_t name = 0, mode = 0;
  for (const TubePreset& preset : tube_presets()) {
    name = std::max(name, preset.name.size());
    mode = std::max(mode, preset.mode_name.size());
  }
  std::string table;
  for (const TubePreset& p : tube_presets()) {
    table += fmt::format("{:{}}  {:{}}  {:8}  {}\n", p.name, name, p.mode_name, mode,
                         p.settings.phosphor, p.note);
  }
  return table;
}

/// What an input is called where a name must be made of it.
std::string stem_of(const std::string& input) {
  if (input == "-") return "display";
  std::string stem = std::filesystem::path(input).stem().string();
  std::replace_if(
      stem.begin(), stem.end(), [](char c) { return c == '#' || c == ':'; }, '-');
  return stem;
}

/// Where the pictures go; empty: nowhere, only figures are wanted.
std::string output_of(const Options& options, bool several) {
  if (!options.picture.output.empty() || options.common.json) return options.picture.output;
  return output_in_out(stem_of(options.display.input), several);
}

void check_memory(const DisplayPlan& plan, const PictureFeed::Facts& facts,
                  const std::string& input) {
  constexpr double kGib = 1 << 30;
  // A frame's bytes and its picture; scaled across it is linear light.
  const double across = 1.0 * plan.shot.tube.mode.horizontal.active * sizeof(LinearRgb);
  const double reading = facts.size.height * (across + 3.0 * facts.size.width * sizeof(Srgb8));
  const double have = available_memory_bytes();
  if (reading > have) {
    throw_bad_input(fmt::format("pictures of {}x{} pixels take about {:.1f} GiB of memory, and "
                                "{:.1f} GiB are free",
                                facts.size.width, facts.size.height, reading / kGib, have / kGib),
                    input == "-" ? "standard input" : input);
  }
  const std::size_t encoded = plan.shot.deep ? sizeof(Srgb16) : sizeof(Srgb8);
  const Size size = plan.shot.size;
  check_memory(size, tube_bytes_a_pixel(encoded) * size.width * size.height + reading);
}

std::string figures(const Options& options, const DisplayPlan& plan,
                    const PictureFeed::Facts& facts, const DisplayFilm& film, int threads) {
  JsonWriter json;
  json.begin_object().member("input", options.display.input);
  json.member("input_width", facts.size.width).member("input_height", facts.size.height);
  json.member("input_hz", plan.input_rate.hertz()).member("pictures_read", film.pictures_read());
  json.member("display", plan.preset).member("mode", plan.shot.tube.mode.modeline());
  json.member("refresh_hz", plan.refresh.hertz()).member("fps", plan.rate.hertz());
  json.member("shutter_s", plan.shot.shutter.count());
  json.member("width", plan.shot.size.width).member("height", plan.shot.size.height);
  json.member("threads", threads).member("simd", simd_target());
  json.key("frames").begin_array();
  for (const DisplayFilm::FrameFigures& frame : film.figures()) {
    json.begin_object().member("frame", frame.frame);
    if (frame.picture_hash != 0) json.hash_member("picture_hash", frame.picture_hash);
    json.end_object();
  }
  json.end_array();
  film.write_times(json);
  json.member("peak_memory_mib", peak_memory_mib());
  return json.end_object().text();
}

/// The film, and its figures if they are wanted.
void film_feed(const Options& options, PictureFeed& feed, const DisplayPlan& plan,
               const std::string& output, Workers& workers) {
  std::optional<Film> film;
  if (!output.empty()) {
    const FilmFormat format = film_format(output, options.picture.format, plan.several());
    check_output(options, format);
    film.emplace(output, format, plan.shot.size, plan.rate);
  }
  DisplayFilm shots(plan, feed, options.common.json, workers);
  {
    Progress progress("photographing", plan.open_ended ? 0 : plan.frames.count(),
                      !options.common.quiet);
    for (int done = 1; shots.shoot(film ? &*film : nullptr); ++done) progress.done(done);
  }
  if (shots.figures().empty()) {
    throw Error(ErrorKind::kUsage, "the input is over before the first picture would be taken",
                "--start");
  }
  if (film) film->close();
  if (options.common.json) {
    print_result(figures(options, plan, feed.facts(), shots, workers.count()));
  }
}

}  // namespace

int run_display(const Options& options) {
  if (options.display.list_presets) {
    print_result(options.common.json ? presets_as_json() : presets_as_table());
    return 0;
  }
  if (options.display.input.empty()) {
    throw Error(ErrorKind::kUsage,
                "nothing to show: name a picture, a film, pattern:NAME, or - for standard input");
  }
  const VideoMode mode = plan_shot(options).tube.mode;
  Workers workers(options.common.threads);
  auto feed = open_feed(options.display, {mode.horizontal.active, mode.vertical.active}, workers);
  const DisplayPlan plan = plan_display_film(options, feed->facts());
  check_memory(plan, feed->facts(), options.display.input);
  const bool wants_window =
      options.picture.output.empty() && !options.common.headless && !options.common.json;
  if (wants_window && Presenter::available()) {
    if (options.picture.fps) {
      throw Error(ErrorKind::kUsage, "is for a film that -o writes: a window shows each refresh",
                  "--fps");
    }
    return run_film_window(options, plan, std::move(feed));
  }
  const std::string output = output_of(options, plan.several());
  film_feed(options, *feed, plan, output, workers);
  if (options.picture.output.empty() && !output.empty()) {
    print_remark("wrote " + output, options.common.quiet);
  }
  return 0;
}

}  // namespace kinescope
