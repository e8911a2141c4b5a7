// A file, or standard input, read once from its beginning.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace kinescope {

/// Bytes in order. Takes no more from a pipe than is asked for or already there.
class InputFile {
 public:
  /// `path` "-" is standard input. @throws Error (bad input) if it cannot be read, as all below
  explicit InputFile(const std::string& path);
  /// Bytes at hand, which must outlive it. @param name what an Error calls them
  InputFile(std::span<const std::uint8_t> bytes, std::string name);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& name() const { return name_; }
  /// Bytes taken so far.
  std::uint64_t position() const { return position_; }

  /// What comes next, without taking it: at least `count` bytes unless the file ends.
  /// @return valid until the next call
  std::span<const std::uint8_t> peek(std::size_t count);
  /// The next line without its newline, taken. @return false if none ends within `most` bytes
  bool read_line(std::string& line, std::size_t most);
  /// Appends the next `count` bytes, fewer if the file ends. Memory grows with what arrives, not
  /// with `count`. @return how many
  std::size_t append_to(std::vector<std::uint8_t>& bytes, std::size_t count);
  /// From any thread: whoever waits for bytes is told that the file has ended.
  void interrupt() { interrupted_ = true; }
  /// All that is left. @throws Error (bad input) if that is more than max_bytes
  std::vector<std::uint8_t> rest(std::size_t max_bytes);

 private:
  bool fill();
  bool wait_for_bytes() const;
  void take(std::size_t count);
  std::size_t read_some(std::uint8_t* to, std::size_t count);
  [[noreturn]] void fail() const;

  std::string name_;
  int descriptor_ = -1;
  bool owned_ = false;
  std::vector<std::uint8_t> storage_;
  std::span<const std::uint8_t> ahead_;  // read, not yet taken
  std::uint64_t position_ = 0;
  std::atomic<bool> interrupted_ = false;
};

/// The whole of a file, or of standard input for "-".
/// @throws Error (bad input) if it cannot be read or is larger than max_bytes
std::vector<std::uint8_t> read_file(const std::string& path,
                                    std::size_t max_bytes = std::size_t{1} << 31);

}  // namespace kinescope
