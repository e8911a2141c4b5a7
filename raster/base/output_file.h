// A file that appears whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

namespace kinescope {

/// Writes to a temporary file beside `path`, renamed by commit(); or to standard output for "-".
/// Devices and pipes that exist already are written to directly.
class OutputFile {
 public:
  /// @throws Error (cannot write)
  explicit OutputFile(const std::string& path);
  ~OutputFile();  ///< without commit(): removes the temporary file
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::span<const std::uint8_t> bytes);
  void write(const std::string& text);
  /// Flushes, closes and renames. @throws Error (cannot write) on a full disk or a closed pipe
  void commit();

  /// Removes the unfinished files of this process; async-signal-safe, for a signal handler.
  static void remove_unfinished() noexcept;

 private:
  [[noreturn]] void fail(const char* doing);
  std::string path_;    // as the user gave it
  std::string target_;  // where the finished file goes
  std::string temporary_;
  std::FILE* stream_ = nullptr;
  int slot_ = -1;
};

}  // namespace kinescope
