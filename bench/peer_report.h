// bench_peers' figures as a table for people or a list for programs.
#pragma once

#include <string>
#include <vector>

#include "bench/cold.h"
#include "bench/peer_rows.h"

namespace kinescope::bench {

/// A figure of ours alone, with its target.
struct OwnLine {
  std::string what;
  double figure;
  double target;        ///< 0: none
  const char* verdict;  ///< "met", "short" or "-"
};

void print_table(const std::vector<Row>& rows);
void print_own_lines(const std::vector<OwnLine>& lines);

/// Lines for what was measured of ours alone.
void add_lines(const std::string& workload, const OwnCost& cost, std::vector<OwnLine>& lines);
void add_lines(const ColdRow& cold, std::vector<OwnLine>& lines);
void add_depth_only_line(const Row& row, std::vector<OwnLine>& lines);
void add_two_threads_line(const std::string& workload, int samples, double ratio,
                          std::vector<OwnLine>& lines);

/// A list of {workload, samples, threads, ours_ms, peer_ms, ratio, pixels_differing, psnr_db}; null
/// where the peer has no such mode, and where pictures are equal (psnr_db).
void print_json(const std::vector<Row>& rows);

}  // namespace kinescope::bench
