// What the comparing programs' main functions have in common.
#pragma once

#include <cstdio>

#include "raster/base/error.h"

namespace kinescope::bench {

/// Runs a program; what it throws becomes one line on stderr and the exit code.
template <typename Run>
int run_program(const char* name, const Run& run, int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return error.exit_code();
  }
}

}  // namespace kinescope::bench
