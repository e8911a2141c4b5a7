// What the program says: results on standard output, all else on standard error.
#pragma once

#include <string>

#include "raster/base/error.h"

namespace kinescope {

/// Writes text to standard output. @throws Error (cannot write) on a full disk or a closed pipe
void print_result(const std::string& text);

/// "kinescope: text"; control characters are replaced, so that it stays one line.
void print_fault(const std::string& text);
void print_warnings(const Warnings& warnings, bool quiet);
/// Something worth knowing that is no warning: "wrote out/teapot.png".
void print_remark(const std::string& text, bool quiet);

}  // namespace kinescope
