// The commands of the program. Each returns the exit code or throws Error.
#pragma once

#include "demos/options.h"

namespace kinescope {

int run_gallery(const Options& options);
int run_list(const Options& options);
int run_demo(const Options& options);
int run_render(const Options& options);
int run_display(const Options& options);
int run_vector(const Options& options);
int run_timing(const Options& options);

}  // namespace kinescope
