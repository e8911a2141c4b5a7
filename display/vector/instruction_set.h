// What the words of a display file mean: one set a kind of machine.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "display/vector/display_memory.h"

namespace kinescope {

class ProcessorCore;

/// Stateless.
class InstructionSet {
 public:
  virtual ~InstructionSet() = default;

  /// Carries out the instruction at the program counter.
  virtual void step(ProcessorCore& core) const = 0;
  /// Names of what a machine's file must give a cost for.
  virtual std::vector<std::string> cost_names() const = 0;
  /// Bits a word.
  virtual int word_bits() const = 0;

  /// How many words an instruction takes; 0 if its name is not known.
  virtual std::size_t length(std::string_view name, std::size_t operands) const = 0;
  /// @throws Error (bad input) telling which operand is wrong
  virtual std::vector<Word> encode(std::string_view name,
                                   std::span<const std::int64_t> operands) const = 0;
  /// The instruction's text, and how many words it took; empty if these are none.
  struct Text {
    std::string text;
    std::size_t words = 1;
  };
  virtual Text decode(std::span<const Word> words) const = 0;
};

bool has_instruction_set(std::string_view name);
std::string instruction_set_names();
/// @throws Error (usage) naming the known ones
const InstructionSet& instruction_set(std::string_view name);

}  // namespace kinescope
