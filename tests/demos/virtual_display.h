// An X server without a screen, and a program run on it.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "raster/image/image.h"

namespace kinescope::test {

/// A child process, ended and reaped with the object. In a folder of its own it writes its errors
/// to said.txt.
class Child {
 public:
  Child(const std::vector<std::string>& command, const std::vector<std::string>& environment,
        const std::string& folder = {}, int inherited_fd = -1);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  /// Exit code if it ends within that time (128 + signal if by one), else none.
  std::optional<int> wait(double seconds);
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
  std::optional<int> exit_code_;
};

/// Xvfb on a free display number, found by itself.
class VirtualDisplay {
 public:
  /// Whether everything that such a test needs is installed.
  static bool available();
  VirtualDisplay(int width, int height);
  const std::string& name() const { return name_; }  ///< ":99", empty if it did not start

  /// Runs a tool ("xdotool key d") on the display to its end and returns what it wrote.
  std::string tool(const std::string& command) const;
  /// What the screen shows.
  Image<Srgb8> screenshot() const;

 private:
  std::optional<Child> server_;
  std::string name_;
};

}  // namespace kinescope::test
