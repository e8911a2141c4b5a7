#include <algorithm>

#include "demos/commands/commands.h"
#include "demos/console.h"
#include "demos/film.h"
#include "demos/json.h"
#include "demos/machine.h"
#include "demos/progress.h"
#include "demos/registry.h"
#include "demos/session.h"
#include "display/presenter.h"
#include "raster/base/simd.h"

namespace kinescope {
namespace {

DemoOptions session_options(const Options& options) {
  DemoOptions session;
  const Size size = options.picture.size.value_or(Size{session.width, session.height});
  session.width = size.width;
  session.height = size.height;
  session.seed = options.common.seed;
  session.threads = options.common.threads;
  return session;
}

void check_memory(const DemoOptions& session) {
  const double pixels = 1.0 * session.width * session.height;
  check_memory(Size{session.width, session.height}, tube_bytes_a_pixel(sizeof(Srgb8)) * pixels);
}

bool can_open_window(const Options& options) {
  return !options.common.headless && Presenter::available();
}

DemoFilm demo_film(const Options& options) {
  DemoFilm film;
  if (!options.demo.script.empty()) film.script = InputScript::read(options.demo.script);
  // Without --frames one picture, half a second after the start or the script's last input.
  const FrameRange frames = options.picture.frames.value_or([&] {
    const int frame = static_cast<int>(std::max<std::int64_t>(film.script.last_frame(), 0)) + 30;
    return FrameRange{frame, frame};
  }());
  film.first_frame = frames.first;
  film.last_frame = frames.last;
  film.fps = options.picture.fps;
  film.shutter = options.picture.shutter;
  return film;
}

/// The demo's frames to `output`, and what they were.
int film_demo(const DemoInfo& demo, const Options& options, const std::string& output) {
  const DemoOptions session = session_options(options);
  const DemoFilm what = demo_film(options);
  const int count = static_cast<int>(what.last_frame - what.first_frame) + 1;
  Film film(output, film_format(output, options.picture.format, count > 1),
            {session.width, session.height}, film_rate(demo, session, what));
  JsonWriter json;
  json.begin_object().member("demo", demo.name).member("output", output);
  json.member("simd", simd_target()).key("picture_hashes").begin_array();
  Stopwatch watch;
  {
    Progress progress("drawing", static_cast<int>(what.last_frame) + 1, !options.common.quiet);
    watch.start();
    render_demo(demo, session, what, [&](std::int64_t frame, const Image<Srgb8>& picture) {
      watch.stop();
      film.write(picture, static_cast<int>(frame));
      json.hash(hash_picture(picture));
      progress.done(static_cast<int>(frame) + 1);
      watch.start();
      return true;
    });
  }
  film.close();
  json.end_array().key("frame_ms");
  watch.write(json);
  json.member("peak_memory_mib", peak_memory_mib()).end_object();
  if (options.common.json) print_result(json.text());
  return 0;
}

/// Films what nobody named a place for.
int film_to_out(const DemoInfo& demo, const Options& options, const std::string& why) {
  const bool several = options.picture.frames && options.picture.frames->count() > 1;
  const std::string output = output_in_out(std::string(demo.name), several);
  const int exit_code = film_demo(demo, options, output);
  print_remark(why + "; wrote " + output, options.common.quiet);
  return exit_code;
}

std::string why_no_window(const Options& options) {
  return options.common.headless ? "no window wanted" : "there is no display to open a window on";
}

}  // namespace

int run_gallery(const Options& options) {
  check_memory(session_options(options));
  if (can_open_window(options)) return run_gallery_window(session_options(options));
  return film_to_out(all_demos().front(), options, why_no_window(options));
}

int run_demo(const Options& options) {
  const DemoInfo& demo = find_demo(options.demo.name);
  const PictureOptions& picture = options.picture;
  if (options.common.json && picture.output == "-") {
    throw Error(ErrorKind::kUsage, "standard output cannot hold both a picture and --json", "-o");
  }
  check_memory(session_options(options));
  if (!picture.output.empty()) return film_demo(demo, options, picture.output);
  if (can_open_window(options)) return run_demo_window(demo, session_options(options));
  return film_to_out(demo, options, why_no_window(options));
}

}  // namespace kinescope
