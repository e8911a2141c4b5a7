// Model files made by tests, and what comes of reading them.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "engine/io/import.h"

namespace kinescope::testing {

/// A fresh folder of the running test.
inline std::filesystem::path test_folder() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) /
      (std::string("kinescope_") + info->test_suite_name() + "_" + info->name());
  std::filesystem::create_directories(folder);
  return folder;
}

inline std::string write_file(const std::string& name, const std::string& contents) {
  const std::filesystem::path path = test_folder() / name;
  std::ofstream(path, std::ios::binary) << contents;
  return path.string();
}

struct Imported {
  Scene scene;
  Warnings warnings;

  const Mesh& mesh(std::size_t i = 0) const { return scene.meshes.at(i); }
  std::uint64_t triangles() const { return drawn_triangle_count(scene); }
  std::string all_warnings() const {
    std::string all;
    for (const std::string& warning : warnings) all += warning + "\n";
    return all;
  }
};

inline Imported import(const std::string& path) {
  Imported imported;
  imported.scene = import_model(path, imported.warnings);
  return imported;
}

inline Imported import_contents(const std::string& name, const std::string& contents) {
  return import(write_file(name, contents));
}

/// The message of the Error that reading ends in; empty if it does not.
inline std::string error_of_file(const std::string& path) {
  Warnings warnings;
  try {
    import_model(path, warnings);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    return error.what();
  }
  return {};
}

inline std::string error_of(const std::string& name, const std::string& contents) {
  return error_of_file(write_file(name, contents));
}

/// The bytes of values, one after another; reversed each for the other byte order.
template <typename T>
void append(std::string& bytes, T value, bool reversed = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (reversed) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// A place in the packages of test data; without it the calling test is skipped, or fails where
/// data is required.
#define KINESCOPE_NEED_DATA(path)                                                       \
  if (!std::filesystem::exists(path)) {                                                 \
    if (std::getenv("KINESCOPE_REQUIRE_DATA")) FAIL() << (path) << " is not installed"; \
    GTEST_SKIP() << (path) << " is not installed";                                      \
  }

}  // namespace kinescope::testing
