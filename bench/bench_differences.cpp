// Pixels that are not llvmpipe's, counted by the kind of their difference.
#include <fmt/format.h>

#include <cstdio>

#include "bench/difference_kinds.h"
#include "bench/flags/flags.h"
#include "bench/peer_llvmpipe.h"
#include "bench/program.h"
#include "raster/base/error.h"

namespace kinescope::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;

/// A row of a Markdown table: a cell a kind, "pixels (seen)".
void print_row(const DifferenceTable& table) {
  fmt::print("| {} | {}x |", table.workload, table.samples);
  for (const DifferenceCount& count : table.count) {
    if (count.pixels == 0) {
      fmt::print(" - |");
    } else {
      fmt::print(" {} ({}) |", count.pixels, count.seen);
    }
  }
  if (table.samples == 1) {
    fmt::print(" {:.2f} |\n", table.farthest_256ths);
  } else {
    fmt::print(" |\n");
  }
}

void print_head() {
  fmt::print("| workload | samples |");
  for (std::size_t i = 0; i < kDifferenceKinds; ++i) {
    fmt::print(" {} |", name_of(static_cast<DifferenceKind>(i)));
  }
  fmt::print(" farthest from an edge, 1/256 px |\n|---|---|");
  for (std::size_t i = 0; i <= kDifferenceKinds; ++i) fmt::print("---|");
  fmt::print("\n");
}

void print_examples(const DifferenceTable& table) {
  const auto text = [](Linear8 c) { return fmt::format("{},{},{}", c.r, c.g, c.b); };
  for (const DifferingPixel& p : table.examples) {
    fmt::print(stderr, "{} {}x {} at {},{}: colour {} and {}, triangle {} and {}\n", table.workload,
               table.samples, name_of(p.kind), p.x, p.y, text(p.ours), text(p.peers),
               text(p.our_triangle), text(p.peer_triangle));
  }
}

int run(int argc, char** argv) {
  std::vector<std::string> workloads;
  std::vector<int> samples{1, 4};
  int examples = 0;
  Flags flags("Pixels that are not llvmpipe's, by kind, as a Markdown table: pixels (seen).");
  flags.option("--workload", &workloads, "by name; all if none is given");
  flags.option("--samples", &samples, "1, 4", Flags::OneOf{{"1", "4"}});
  flags.option("--examples", &examples, "pixels of each kind to print to stderr");
  if (const auto exit = flags.parse(argc, argv)) return *exit;
  if (workloads.empty()) workloads = workload_names();
  LlvmpipePeer::set_threads(2);
  print_head();
  for (const std::string& name : workloads) {
    const Workload workload = make_workload(name);
    for (const int count : samples) {
      const DifferenceTable table = compare_with_peer(workload, kWidth, kHeight, count, examples);
      print_row(table);
      print_examples(table);
    }
  }
  return 0;
}

}  // namespace
}  // namespace kinescope::bench

int main(int argc, char** argv) {
  return kinescope::bench::run_program("bench_differences", kinescope::bench::run, argc, argv);
}
