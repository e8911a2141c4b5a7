// The command line. The only file behind which CLI11 stands.
#pragma once

#include <string>
#include <variant>

#include "demos/options.h"

namespace kinescope {

/// The answer to --help or --version, for standard output.
struct Answer {
  std::string text;
};

/// @throws Error (usage) naming the option, with a hint at --help
std::variant<Options, Answer> parse_command_line(int argc, const char* const* argv);

}  // namespace kinescope
