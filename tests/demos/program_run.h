// Starts the built kinescope as its users do, and catches what it says.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace kinescope::test {

struct RunResult {
  int exit_code = -1;  ///< 128 + the signal's number if one ended it
  std::string out, err;
  int lines_of_err() const;
};

struct RunOptions {
  std::filesystem::path folder = {};          ///< working directory; empty: this one
  std::vector<std::string> environment = {};  ///< "NAME=value", on top of ours
  std::string input = {};                     ///< for standard input
  std::string out_path = {};                  ///< standard output goes there instead
  bool close_out = false;                     ///< nobody reads standard output
  int stop_signal = 0;                        ///< sent `stop_after_ms` after the start, if not 0
  int stop_after_ms = 0;
};

/// Runs it without a display (SDL_VIDEODRIVER and DISPLAY are taken away) and waits, at most a
/// minute.
RunResult run_kinescope(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// The same for a line of shell in which `kinescope` is the built one.
RunResult run_shell(const std::string& line, const RunOptions& options = {});

/// A folder of its own, gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }
  std::vector<std::string> files() const;  ///< names, sorted

 private:
  std::filesystem::path path_;
};

std::string read_text(const std::string& path);
void write_text(const std::string& path, const std::string& text);

/// A cube of side 2 about the origin, 12 triangles, as OBJ text.
std::string cube_obj();

}  // namespace kinescope::test
