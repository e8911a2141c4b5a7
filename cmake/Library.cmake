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
endfunction()

# kinescope_knows_folders(FILES...): sources that find the repository and the programs. Only these:
# a folder's name in every compilation would keep clones from sharing what ccache keeps.
function(kinescope_knows_folders)
  set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_DEFINITIONS
    KINESCOPE_SOURCE_DIR="${CMAKE_SOURCE_DIR}" KINESCOPE_BIN_DIR="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
endfunction()

# What tests are compiled with: most of what they do, they do once.
function(kinescope_test_options name)
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
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 900
    ENVIRONMENT "LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/leaks.supp:print_suppressions=0")
endfunction()
