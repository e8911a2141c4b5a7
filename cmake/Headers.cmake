# Headers that most sources read, compiled once: what remains of a small file's compilation is its own.
# Only with g++: clang's builds (the fuzzers) show when a source misses an include of its own.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(KINESCOPE_PRECOMPILE ON)
  add_compile_options(-fpch-preprocess)  # so that ccache sees what they hold
else()
  set(KINESCOPE_PRECOMPILE OFF)
endif()

# kinescope_precompiled(NAME headers...): a set of headers that targets share by
# kinescope_precompile(TARGET NAME).
function(kinescope_precompiled name)
  if(NOT KINESCOPE_PRECOMPILE)
    return()
  endif()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Carries the precompiled headers.\n")
  add_library(${name} OBJECT ${source})
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

function(kinescope_precompile target name)
  if(KINESCOPE_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
