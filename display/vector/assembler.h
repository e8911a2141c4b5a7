// Display files as text. A line holds a label, an instruction, or both; comments from ';':
//
//   size = 40            a name for a number
//   start:               a label: the address of what follows
//           move 100 100
//           call box
//           chars "text"
//           jump start + 1
//   .org 0x200           goes on at an address; words between are 0
//   .word 1, box, 'A'    words as they are
//
// Operands are separated by blanks or commas; a number may be decimal, 0x..., or a character in
// quotes; an operand a sum such as box + 2 - size.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "display/vector/instruction_set.h"

namespace kinescope {

struct DisplayFile {
  std::vector<Word> words;  ///< from address 0 on
  std::map<std::string, std::int64_t> names;
  Address start = 0;  ///< label "start", if there is one
};

/// @param file for messages @throws Error (bad input) naming the file and line
DisplayFile assemble(std::string_view text, const InstructionSet& set, const std::string& file);

/// Whether text is a display file's: every line one that assemble() would read, and at least one an
/// instruction. @param text whole lines
bool is_display_file_text(std::string_view text, const InstructionSet& set);

/// A line a word or instruction, with its address and words as a comment. Assembled, it gives the
/// same words.
std::string disassemble(std::span<const Word> words, const InstructionSet& set);

}  // namespace kinescope
