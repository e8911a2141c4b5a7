// The program, from arguments to exit code.
#pragma once

namespace kinescope {

/// @return 0 done, 2 bad usage, 3 bad input, 4 could not write; every Error is one line on
/// standard error
int run_program(int argc, const char* const* argv);

}  // namespace kinescope
