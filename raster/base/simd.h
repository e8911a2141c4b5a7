// Which instruction set the kernels run on. Highway chooses at start; --simd and tests may narrow.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kinescope {

/// Names of the targets that this binary holds and this machine runs, best first ("AVX3", "AVX2",
/// "SSE4", and the portable one: "EMU128", or "SCALAR" from compilers with which that one is
/// broken).
std::vector<std::string> simd_targets();

/// The target in use.
std::string simd_target();

/// Runs every kernel on the named target from now on ("best" returns to Highway's choice). Call
/// between frames only. @throws Error (usage) naming the targets there are
void use_simd_target(std::string_view name);

}  // namespace kinescope
