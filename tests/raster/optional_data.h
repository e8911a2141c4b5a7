// Test data that a machine may lack.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

/// Skips the test if `path` does not exist; with KINESCOPE_REQUIRE_DATA set, fails it.
#define KINESCOPE_NEEDS(path)                                                      \
  if (!std::filesystem::exists(path)) {                                            \
    if (std::getenv("KINESCOPE_REQUIRE_DATA")) FAIL() << (path) << " is required"; \
    GTEST_SKIP() << (path) << " is not here (scripts/setup --data installs it)";   \
  }                                                                                \
  static_assert(true, "")
