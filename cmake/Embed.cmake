# kinescope_embed(TARGET SYMBOL FILE): the bytes of FILE, linked in, as
#   namespace kinescope::embedded { std::string_view SYMBOL(); }
# declared in "SYMBOL.h", which the build writes. The compiler's assembler reads FILE (.incbin).
function(kinescope_embed target symbol file)
  get_filename_component(path ${file} ABSOLUTE)
  set(dir ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  file(WRITE ${dir}/${symbol}.h.in
"#pragma once
#include <string_view>
namespace kinescope::embedded {
/// The bytes of ${symbol}, as the build found them.
std::string_view ${symbol}();
}  // namespace kinescope::embedded
")
  file(WRITE ${dir}/${symbol}.cpp.in
"#include \"${symbol}.h\"
asm(\".section .rodata\\n.balign 16\\nkinescope_${symbol}_begin:\\n.incbin \\\"${path}\\\"\\n\"
    \"kinescope_${symbol}_end:\\n.byte 0\\n.previous\\n\");
extern \"C\" {
extern const char begin_of[] asm(\"kinescope_${symbol}_begin\");
extern const char end_of[] asm(\"kinescope_${symbol}_end\");
}
namespace kinescope::embedded {
std::string_view ${symbol}() { return {begin_of, static_cast<std::size_t>(end_of - begin_of)}; }
}  // namespace kinescope::embedded
")
  configure_file(${dir}/${symbol}.h.in ${dir}/${symbol}.h COPYONLY)
  configure_file(${dir}/${symbol}.cpp.in ${dir}/${symbol}.cpp COPYONLY)
  set_source_files_properties(${dir}/${symbol}.cpp PROPERTIES OBJECT_DEPENDS ${path}
                              CXX_COMPILER_LAUNCHER "")
  target_sources(${target} PRIVATE ${dir}/${symbol}.cpp)
  target_include_directories(${target} PRIVATE ${dir})
endfunction()
