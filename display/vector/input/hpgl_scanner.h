// HP-GL text, instruction by instruction. Source: Hewlett-Packard, 7550A Interfacing and
// Programming Manual; PCL 5 Technical Reference, chapters on HP-GL/2.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kinescope {

/// Two letters, in capitals, and what follows them.
struct HpglInstruction {
  std::string name;
  std::vector<double> numbers;
  std::string text;       ///< of a label, comment, symbol or terminator
  std::size_t place = 0;  ///< where it begins, bytes
};

/// Any bytes are harmless: what is no instruction is passed over.
class HpglScanner {
 public:
  explicit HpglScanner(std::span<const std::uint8_t> bytes)
      : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

  /// @return false at the end
  bool next(HpglInstruction& instruction);
  /// What ends a label from now on.
  void set_terminator(char c) { terminator_ = c; }
  std::size_t passed_over() const { return passed_over_; }  ///< bytes

 private:
  void skip_escape();
  void read_numbers(std::vector<double>& numbers);
  void read_text(HpglInstruction& instruction);
  std::string up_to(char terminator);

  std::string_view text_;
  std::size_t at_ = 0, passed_over_ = 0;
  char terminator_ = '\x03';
};

}  // namespace kinescope
