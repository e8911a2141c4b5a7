# Flags that every target shares.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
endif()

# Multiply and add stay two roundings: coverage and depth must agree on every instruction set.
add_compile_options(-ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wno-psabi -Werror)
# Sanitized builds keep their preset's flags, and with them their assertions.
if(NOT KINESCOPE_SANITIZE)
  set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
endif()

if(KINESCOPE_SANITIZE)
  add_compile_options(-fsanitize=${KINESCOPE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${KINESCOPE_SANITIZE})
endif()

# The instruction sets that kernels are compiled for: any x86-64 (Highway's portable target), SSE4,
# AVX2 and AVX-512. The two left out gain little over their neighbours and cost compile time.
# Sanitized builds take the portable one and AVX2: the loops are the same source on each.
if(KINESCOPE_SANITIZE)
  add_compile_definitions("HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_SSE4|HWY_AVX3|HWY_AVX3_DL)")
else()
  add_compile_definitions("HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_AVX3_DL)")
endif()
