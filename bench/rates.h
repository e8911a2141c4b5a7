// Figures in the unit that people expect: a number of things a second.
#pragma once

#include <benchmark/benchmark.h>

namespace kinescope::bench {

/// Adds the counter `name`: `per_iteration` things, over the time that an iteration took.
inline void count_rate(benchmark::State& state, const char* name, double per_iteration) {
  state.counters[name] =
      benchmark::Counter(per_iteration, benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace kinescope::bench
