// Our rasterizer and its peers on the same pictures, interleaved in one process.
#include <algorithm>
#include <cstdio>

#include "bench/cold.h"
#include "bench/flags/flags.h"
#include "bench/peer_llvmpipe.h"
#include "bench/peer_report.h"
#include "bench/peer_rows.h"
#include "bench/program.h"
#include "raster/base/error.h"

namespace kinescope::bench {
namespace {

/// Rows that are no Workload: they need a new process, or no scene.
constexpr const char *kCold = "cold", *kDepthOnly = "depth-10";

struct Options {
  PairOptions pair;
  std::vector<std::string> workloads, models;
  std::vector<int> samples{1, 4, 8};
  bool json = false, own_cost = false, scaling = false;
  std::string cold_child;
};

void add_options(Flags& flags, Options& options) {
  flags.option("--workload", &options.workloads,
               "workloads by name; cold, depth-10; all if none is given");
  flags.option("--model", &options.models, "model files, drawn in one colour");
  flags.option("--samples", &options.samples,
               "samples a pixel: 1, 4, 8 (of 8 ours alone: llvmpipe has no more than 4)",
               Flags::OneOf{{"1", "4", "8"}});
  flags.option("--threads", &options.pair.threads, "threads of each", Flags::Within{1, 64});
  flags.option("--pairs", &options.pair.pairs, "timed pairs of frames", Flags::Within{1, 1000});
  flags.option("--pictures", &options.pair.pictures, "folder for both last frames as PNG");
  flags.flag("--json", options.json, "a list of figures instead of the table");
  flags.flag("--own-cost", options.own_cost,
             "instead: our 4 samples against our 1, and our 8 against our 4");
  flags.flag("--scaling", options.scaling, "instead: two threads of ours against one");
  flags.exclude("--own-cost", "--json");
  flags.exclude("--scaling", "--json");
  flags.option("--cold-child", &options.cold_child, "", {}, Flags::Need::kHidden);
}

/// Everything asked for, in its order.
class Run {
 public:
  explicit Run(const Options& options) : options_(options) {}

  void workload(const Workload& workload) {
    if (options_.own_cost) {
      add_lines(workload.name, measure_own_cost(options_.pair, workload), lines_);
    } else if (options_.scaling) {
      for (const int samples : options_.samples) {
        add_two_threads_line(workload.name, samples,
                             measure_two_threads(options_.pair, workload, samples), lines_);
      }
    } else {
      for (const int samples : options_.samples) {
        add(measure_pair(options_.pair, workload, samples));
      }
    }
  }
  void cold() {
    if (options_.own_cost || options_.scaling) return;
    for (const int samples : options_.samples) {
      const ColdRow cold = measure_cold(options_.pair, samples);
      add(cold.row);
      add_lines(cold, lines_);
    }
  }
  void depth_only() {
    if (options_.own_cost || options_.scaling) return;
    for (const int samples : options_.samples) {
      add(measure_depth_only(options_.pair, samples));
      add_depth_only_line(rows_.back(), lines_);
    }
  }
  void print() const {
    if (options_.json) return print_json(rows_);
    if (!rows_.empty()) print_table(rows_);
    print_own_lines(lines_);
  }

 private:
  void add(const Row& row) {
    rows_.push_back(row);
    if (!options_.json && !row.peer_version.empty()) {
      std::fprintf(stderr, "%s %dx: %s\n", row.workload.c_str(), row.samples,
                   row.peer_version.c_str());
    }
  }

  const Options& options_;
  std::vector<Row> rows_;
  std::vector<OwnLine> lines_;
};

int run_all(int argc, char** argv) {
  Options options;
  Flags flags(
      "Kinescope's rasterizer beside Mesa's llvmpipe: same pictures, interleaved, medians.");
  add_options(flags, options);
  if (const auto exit = flags.parse(argc, argv)) return *exit;
  LlvmpipePeer::set_threads(options.pair.threads);
  if (!options.cold_child.empty()) {
    run_cold_child(options.pair, options.cold_child, options.samples.front());
    return 0;
  }
  if (options.workloads.empty() && options.models.empty()) {
    options.workloads = workload_names();
    options.workloads.insert(options.workloads.end(), {kCold, kDepthOnly});
  }
  Run run(options);
  for (const std::string& name : options.workloads) {
    if (name == kCold) {
      run.cold();
    } else if (name == kDepthOnly) {
      run.depth_only();
    } else {
      run.workload(make_workload(name));
    }
  }
  for (const std::string& path : options.models) run.workload(model_workload(path));
  run.print();
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

int main(int argc, char** argv) {
  return kinescope::bench::run_program("bench_peers", kinescope::bench::run_all, argc, argv);
}
