// A terminal device that other programs open and draw on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kinescope {

/// The master's side of a pseudo-terminal in raw mode: bytes pass as they are, nothing is echoed.
class PseudoTerminal {
 public:
  /// @throws Error (usage) if the system has none left
  PseudoTerminal();
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// As programs open it: "/dev/pts/3".
  const std::string& name() const { return name_; }
  /// Appends what has arrived, waiting at most that long for something. @return how many bytes
  std::size_t read(std::vector<std::uint8_t>& to, int milliseconds);
  /// What the terminal answers; lost if nobody reads and the system's buffer is full.
  void write(const std::string& text);
  /// Whether somebody has written, and all who had it open have left.
  bool finished() const { return used_ && left_; }

 private:
  int master_ = -1;
  std::string name_;
  bool used_ = false, left_ = false;
};

}  // namespace kinescope
