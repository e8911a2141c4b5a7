#include <fmt/format.h>

#include "demos/commands/commands.h"
#include "demos/console.h"
#include "demos/json.h"
#include "display/video_mode.h"

namespace kinescope {
namespace {

struct Interval {
  const char* name;
  int count;  ///< pixels across, or lines down
};

std::array<Interval, 5> intervals(const SyncTiming& timing) {
  return {{{"active", timing.active},
           {"front_porch", timing.front_porch},
           {"sync", timing.sync},
           {"back_porch", timing.back_porch},
           {"total", timing.total()}}};
}

/// An interval in the three units.
struct Measured {
  double pixels, lines, us;
};

Measured measure(const VideoMode& mode, int count, bool vertical) {
  const double pixels = vertical ? 1.0 * count * mode.horizontal.total() : count;
  return {pixels, pixels / mode.horizontal.total(), pixels / mode.pixel_clock_hz * 1e6};
}

void write_axis(JsonWriter& json, const VideoMode& mode, bool vertical) {
  const SyncTiming& timing = vertical ? mode.vertical : mode.horizontal;
  json.key(vertical ? "vertical" : "horizontal").begin_object();
  json.member("sync_polarity", timing.positive_sync ? "positive" : "negative");
  for (const Interval& interval : intervals(timing)) {
    const Measured m = measure(mode, interval.count, vertical);
    json.key(interval.name).begin_object();
    json.member("pixels", m.pixels).member("lines", m.lines).member("us", m.us).end_object();
  }
  json.end_object();
}

std::string as_json(const VideoMode& mode) {
  const Rate rate = mode.frame_rate();
  JsonWriter json;
  json.begin_object();
  json.member("name", mode.name).member("modeline", mode.modeline());
  json.member("pixel_clock_hz", mode.pixel_clock_hz).member("line_rate_hz", mode.line_rate_hz());
  json.key("frame_rate").begin_object();
  json.member("numerator", rate.numerator).member("denominator", rate.denominator);
  json.member("hz", rate.hertz()).end_object();
  json.member("field_rate_hz", 1 / mode.field_period().count());
  json.member("interlaced", mode.interlaced);
  write_axis(json, mode, false);
  write_axis(json, mode, true);
  return json.end_object().text();
}

std::string table_of_axis(const VideoMode& mode, bool vertical) {
  const SyncTiming& timing = vertical ? mode.vertical : mode.horizontal;
  std::string table =
      fmt::format("{:<22}{:>12}{:>12}{:>14}\n", vertical ? "Down a frame" : "Across a line",
                  "pixels", "lines", "us");
  for (const Interval& interval : intervals(timing)) {
    std::string name = interval.name;
    if (name == "front_porch") name = "front porch";
    if (name == "back_porch") name = "back porch";
    if (name == "total") name = vertical ? "whole frame" : "whole line";
    if (name == "sync") name += timing.positive_sync ? " (positive)" : " (negative)";
    const Measured m = measure(mode, interval.count, vertical);
    table += fmt::format("  {:<20}{:>12.0f}{:>12.{}f}{:>14.3f}\n", name, m.pixels, m.lines,
                         vertical ? 0 : 4, m.us);
  }
  return table;
}

std::string as_table(const VideoMode& mode) {
  const Rate rate = mode.frame_rate();
  std::string text = mode.modeline() + "\n\n";
  text += fmt::format("pixel clock  {:.6g} MHz\nline rate    {:.6g} kHz\n",
                      mode.pixel_clock_hz * 1e-6, mode.line_rate_hz() * 1e-3);
  text += fmt::format("frame rate   {:.6g} Hz ({}/{})\n", rate.hertz(), rate.numerator,
                      rate.denominator);
  text += mode.interlaced ? fmt::format(
                                "field rate   {:.6g} Hz: two interlaced fields a frame, "
                                "{:g} lines each\n",
                                1 / mode.field_period().count(), mode.vertical.total() / 2.0)
                          : std::string("progressive\n");
  return text + "\n" + table_of_axis(mode, false) + "\n" + table_of_axis(mode, true);
}

}  // namespace

int run_timing(const Options& options) {
  const VideoMode mode = parse_mode(options.mode);
  mode.check();
  print_result(options.common.json ? as_json(mode) : as_table(mode));
  return 0;
}

}  // namespace kinescope
