#include <filesystem>
#include <optional>
#include <utility>

#include "demos/chosen_tube.h"
#include "demos/commands/commands.h"
#include "demos/console.h"
#include "demos/model_demo.h"
#include "demos/model_files.h"
#include "demos/model_film.h"
#include "demos/progress.h"
#include "demos/session.h"
#include "display/presenter.h"
#include "raster/base/simd.h"

namespace kinescope {
namespace {

/// Where the pictures go; empty: nowhere, only figures are wanted.
std::string output_of(const Options& options, bool several) {
  if (!options.picture.output.empty() || options.common.json) return options.picture.output;
  return output_in_out(std::filesystem::path(options.render.models.front()).stem().string(),
                       several);
}

void write_frames(JsonWriter& json, const ModelFilm& film) {
  json.hash_member("visibility_hash", film.figures().front().stats.raster.visibility_hash);
  json.hash_member("colour_hash", film.figures().front().colour_hash);
  json.key("frames").begin_array();
  for (const ModelFilm::FrameFigures& frame : film.figures()) {
    json.begin_object().member("frame", frame.frame);
    json.hash_member("visibility_hash", frame.stats.raster.visibility_hash);
    json.hash_member("colour_hash", frame.colour_hash);
    if (frame.picture_hash != 0) json.hash_member("picture_hash", frame.picture_hash);
    json.end_object();
  }
  json.end_array();
}

std::string figures(const Options& options, const ModelFilmPlan& plan, const ModelView& view,
                    const ModelFilm& film, const Workers& workers, const Warnings& warnings,
                    double import_ms, double total_ms) {
  const RenderStats& stats = film.figures().back().stats;
  JsonWriter json;
  json.begin_object();
  json.member("triangles", drawn_triangle_count(view.scene()));
  json.member("drawn", stats.raster.drawn).member("clipped", stats.clipped);
  json.member("vertices", stats.vertices).member("fragments", stats.raster.fragments);
  json.member("width", plan.size.width).member("height", plan.size.height);
  json.member("samples", options.render.samples).member("threads", workers.count());
  json.member("simd", simd_target());
  json.member("display", plan.bare ? std::string("none") : chosen_tube(options.picture).name);
  write_frames(json, film);
  film.write_times(json);
  json.member("import_ms", import_ms).member("ms", total_ms);
  json.member("peak_memory_mib", peak_memory_mib());
  json.key("warnings").begin_array();
  for (const std::string& warning : warnings) json.value(warning);
  json.end_array();
  return json.end_object().text();
}

int film_models(const Options& options, const ModelFilmPlan& plan, const std::string& output) {
  Stopwatch whole, reading;
  whole.start();
  std::optional<Film> film;
  if (!output.empty()) {
    const FilmFormat format = film_format(output, options.picture.format, plan.several());
    check_output(options, format);
    film.emplace(output, format, plan.size, plan.rate);
  }
  Warnings warnings;
  reading.start();
  Scene scene = import_models(options.render.models, warnings);
  reading.stop();
  print_warnings(warnings, options.common.quiet);

  Workers workers(options.common.threads);
  const double aspect = static_cast<double>(plan.drawn.width) / plan.drawn.height;
  ModelView view(std::move(scene), options.render, aspect, plan.several(), workers);
  ModelFilm shots(view, plan, options, workers);
  {
    Progress progress("rendering", plan.frames.count(), !options.common.quiet);
    for (int i = 1; i <= plan.frames.count(); ++i) {
      shots.shoot(film ? &*film : nullptr);
      progress.done(i);
    }
  }
  if (film) film->close();
  whole.stop();
  if (options.common.json) {
    print_result(figures(options, plan, view, shots, workers, warnings, reading.total_ms(),
                         whole.total_ms()));
  }
  return 0;
}

}  // namespace

/// A window in which the models are turned by hand.
int show_models(const Options& options, const ModelFilmPlan& plan) {
  Warnings warnings;
  Scene scene = import_models(options.render.models, warnings);
  print_warnings(warnings, options.common.quiet);
  const DemoInfo demo = model_demo(std::move(scene), options.render, plan);
  return run_demo_window(
      demo, {plan.size.width, plan.size.height, options.common.seed, options.common.threads});
}

int run_render(const Options& as_typed) {
  Options options = as_typed;
  options.render = with_up_of_files(options.render);
  const ModelFilmPlan plan = plan_model_film(options);
  check_memory(plan, options);
  const bool wants_window =
      options.picture.output.empty() && !options.common.headless && !options.common.json;
  if (wants_window && Presenter::available()) return show_models(options, plan);
  const std::string output = output_of(options, plan.several());
  film_models(options, plan, output);
  if (options.picture.output.empty() && !output.empty()) {
    print_remark("wrote " + output, options.common.quiet);
  }
  return 0;
}

}  // namespace kinescope
