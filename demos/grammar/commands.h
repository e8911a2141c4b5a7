// What the larger commands take.
#pragma once

#include <CLI/CLI.hpp>

#include "demos/options.h"

namespace kinescope::grammar {

void add_render(CLI::App& app, Options& options);
void add_display_command(CLI::App& app, Options& options);
void add_vector_command(CLI::App& app, Options& options);

}  // namespace kinescope::grammar
