#include "bench/peer_report.h"

#include <fmt/format.h>

#include <cmath>

#include "bench/targets.h"

namespace kinescope::bench {
namespace {

std::string number(std::optional<double> value, int decimals, const char* none) {
  return value && std::isfinite(*value) ? fmt::format("{:.{}f}", *value, decimals) : none;
}

std::optional<double> psnr_db(const Row& row) {
  return row.difference ? std::optional(row.difference->psnr_db) : std::nullopt;
}

std::string pixels_differing(const Row& row, const char* none) {
  return row.difference ? std::to_string(row.difference->pixels_differing) : none;
}

}  // namespace

void print_table(const std::vector<Row>& rows) {
  fmt::print("{:<20}{:>8}{:>8}{:>10}{:>10}{:>8}{:>8}{:>8}{:>10}{:>8}\n", "workload", "samples",
             "threads", "ours ms", "peer ms", "ratio", "least", "", "pixels", "psnr");
  for (const Row& r : rows) {
    const double least = least_ratio(r.workload, r.samples);
    const std::optional<double> target = least > 0 ? std::optional(least) : std::nullopt;
    fmt::print("{:<20}{:>8}{:>8}{:>10.2f}{:>10}{:>8}{:>8}{:>8}{:>10}{:>8}\n", r.workload, r.samples,
               r.threads, r.ours_ms, number(r.peer_ms, 2, "-"), number(r.ratio, 2, "-"),
               number(target, 1, "-"), r.ratio ? at_least(*r.ratio, least) : "-",
               pixels_differing(r, "-"), number(psnr_db(r), 1, "-"));
  }
}

void print_own_lines(const std::vector<OwnLine>& lines) {
  if (!lines.empty()) fmt::print("\n{:<56}{:>8}{:>8}\n", "ours alone", "figure", "target");
  for (const OwnLine& line : lines) {
    const auto target = line.target > 0 ? std::optional(line.target) : std::nullopt;
    fmt::print("{:<56}{:>8.2f}{:>8}{:>8}\n", line.what, line.figure, number(target, 2, "-"),
               line.verdict);
  }
}

void add_lines(const std::string& workload, const OwnCost& cost, std::vector<OwnLine>& lines) {
  const Target& target = target_of(workload);
  lines.push_back({workload + ": 4 samples over 1, at most", cost.four_over_one, target.own_4x,
                   at_most(cost.four_over_one, target.own_4x)});
  lines.push_back({workload + ": 8 samples over 4, at most", cost.eight_over_four, target.own_8x,
                   at_most(cost.eight_over_four, target.own_8x)});
}

void add_lines(const ColdRow& cold, std::vector<OwnLine>& lines) {
  lines.push_back({fmt::format("cold, {}x: first frame over steady, at most", cold.row.samples),
                   cold.ours_over_steady, kFirstFrame,
                   at_most(cold.ours_over_steady, kFirstFrame)});
  if (cold.peer_over_steady) {
    lines.push_back({fmt::format("cold, {}x: the same of llvmpipe", cold.row.samples),
                     *cold.peer_over_steady, 0, "-"});
  }
}

void add_depth_only_line(const Row& row, std::vector<OwnLine>& lines) {
  const double mtris = 1000 / row.ours_ms;  // a million triangles a frame
  const double target = row.samples == 1 ? kDepthOnlyMtris : 0;
  lines.push_back({fmt::format("depth-10, {}x: 10^6 triangles a second, at least", row.samples),
                   mtris, target, at_least(mtris, target)});
}

void add_two_threads_line(const std::string& workload, int samples, double ratio,
                          std::vector<OwnLine>& lines) {
  lines.push_back({fmt::format("{}, {}x: two threads over one, at least", workload, samples), ratio,
                   kTwoThreads, at_least(ratio, kTwoThreads)});
}

void print_json(const std::vector<Row>& rows) {
  fmt::print("[");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& r = rows[i];
    fmt::print(
        "{}\n  {{\"workload\": \"{}\", \"samples\": {}, \"threads\": {}, \"ours_ms\": {:.3f}, "
        "\"peer_ms\": {}, \"ratio\": {}, \"pixels_differing\": {}, \"psnr_db\": {}}}",
        i ? "," : "", r.workload, r.samples, r.threads, r.ours_ms, number(r.peer_ms, 3, "null"),
        number(r.ratio, 3, "null"), pixels_differing(r, "null"), number(psnr_db(r), 3, "null"));
  }
  fmt::print("\n]\n");
}

}  // namespace kinescope::bench
