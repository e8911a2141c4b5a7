# Headers that most sources read, compiled once: what remains of a small file's compilation is its own.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-fpch-preprocess)  # so that ccache sees what they hold
else()
  add_compile_options("SHELL:-Xclang -fno-pch-timestamp")  # their contents alone count, for ccache too
  # Precompiled, libstdc++ forgets the pragmas that silence its own use of what it calls deprecated. Of our
  # use of such things g++'s builds tell.
  add_compile_options(-Wno-deprecated-declarations)
endif()

# kinescope_precompiled(NAME headers...): a set of headers that targets share by
# kinescope_precompile(TARGET NAME).
function(kinescope_precompiled name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Carries the precompiled headers.\n")
  add_library(${name} OBJECT ${source})
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

function(kinescope_precompile target name)
  target_precompile_headers(${target} REUSE_FROM ${name})
endfunction()
