# kinescope_library(NAME deps...): every .cpp below the folder becomes one static library.
function(kinescope_library name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ARGN})
  kinescope_precompile(${name} library_headers)
  if(KINESCOPE_FUZZ)
    kinescope_watch_readers(${sources})
  endif()
endfunction()

# kinescope_watch_readers(FILES...): libFuzzer sees which branches the readers among them take. They
# alone are watched, so that the tests of a sanitized build keep their speed.
function(kinescope_watch_readers)
  list(FILTER ARGV INCLUDE REGEX
    "/(characters|image|input|io)/|/(assembler|display_processor|font|l_system|preset|svg_path|turtle)|_words")
  set_property(SOURCE ${ARGV} APPEND PROPERTY COMPILE_OPTIONS
    -fsanitize-coverage=inline-8bit-counters,indirect-calls,trace-cmp,pc-table)
endfunction()

# kinescope_knows_folders(FILES...): sources that find the repository and the programs. Only these:
# a folder's name in every compilation would keep clones from sharing what ccache keeps.
function(kinescope_knows_folders)
  set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_DEFINITIONS
    KINESCOPE_SOURCE_DIR="${CMAKE_SOURCE_DIR}" KINESCOPE_BIN_DIR="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
endfunction()

# kinescope_sanitize_unoptimized(TARGETS...): of what does most of its work once. Under sanitizers the
# optimizer takes two thirds of a test's compilation.
function(kinescope_sanitize_unoptimized)
  if(KINESCOPE_SANITIZE)
    foreach(target IN LISTS ARGN)
      target_compile_options(${target} PRIVATE -O0)
    endforeach()
  endif()
endfunction()

# kinescope_sanitize_optimized(FILES...): what touches every pixel, in whichever target.
function(kinescope_sanitize_optimized)
  if(KINESCOPE_SANITIZE)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -O2)
    set_property(SOURCE ${ARGN} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# What tests are compiled with: most of what they do, they do once.
function(kinescope_test_options name)
  kinescope_sanitize_unoptimized(${name})
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT KINESCOPE_SANITIZE)
    target_compile_options(${name} PRIVATE -O1)
  endif()
endfunction()

# kinescope_tests(NAME libs...): every .cpp below the folder becomes one GoogleTest program.
function(kinescope_tests name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${name} ${sources})
  kinescope_test_options(${name})
  kinescope_precompile(${name} test_headers)
  target_link_libraries(${name} PRIVATE ${ARGN} GTest::gmock GTest::gtest GTest::gtest_main fmt::fmt)
  if(KINESCOPE_SANITIZE)
    kinescope_add_shards(${name})
  else()
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 900)
  endif()
endfunction()

# Most tests are over before a sanitized program has started: each start runs an eighth of them.
function(kinescope_add_shards name)
  set(leaks "LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/leaks.supp:print_suppressions=0")
  set(names "ASAN_OPTIONS=external_symbolizer_path=/usr/bin/llvm-symbolizer-19")
  foreach(shard RANGE 7)
    add_test(NAME ${name}_${shard} COMMAND ${name})
    set_tests_properties(${name}_${shard} PROPERTIES TIMEOUT 1800
      ENVIRONMENT "${leaks};${names};GTEST_TOTAL_SHARDS=8;GTEST_SHARD_INDEX=${shard}")
  endforeach()
endfunction()
