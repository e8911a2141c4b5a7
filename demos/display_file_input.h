// Display files from outside: text for the assembler, or the words themselves.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "display/vector/assembler.h"
#include "display/vector/input/drawing.h"
#include "display/vector/machine.h"
#include "raster/base/input_file.h"

namespace kinescope {

/// Words lie in a file one after the other, the lowest byte first, as many bytes as the machine's
/// words have. @param is_text none: by its content
/// @throws Error (bad input) naming the file, and of text the line
DisplayFile read_display_file(InputFile& input, const InstructionSet& set,
                              std::optional<bool> is_text);
/// Whether an input is a display file, by its first bytes: text that can be assembled, or words
/// that are all instructions. @param all whether there are no more bytes
bool looks_like_display_file(std::span<const std::uint8_t> first_bytes, bool all,
                             const InstructionSet& set);
/// Words of memory that a machine has for a program. The generic machine is of no make: it has as
/// many as the program needs, if that is more; others are as they were built.
std::size_t memory_for(const VectorMachine& machine, const DisplayFile& program);
std::string words_as_bytes(std::span<const Word> words, const InstructionSet& set);

/// What a program draws from its start until it begins again or halts, in the machine's units.
/// @param name of the file, for messages @throws Error (bad input) if the program stops by a fault
VectorDrawing one_refresh(const VectorMachine& machine, const DisplayFile& program,
                          const std::string& name);

}  // namespace kinescope
