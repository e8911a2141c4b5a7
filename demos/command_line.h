// The command line. CLI11 stands behind it and what lies in demos/grammar/.
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
