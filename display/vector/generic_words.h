// The generic machine's instruction set. A word has 32 bits: eight of operation, 24 of operands.
//
//   halt                     stops until it is started again
//   nop
//   move X Y                 dark, to a place: 12 bits each, y upwards
//   draw X Y                 lit, to a place
//   point X Y                dark to a place, and rests there lit
//   rmove DX DY              the same by a way, of -2048 to 2047 each, times the scale
//   rdraw DX DY
//   rpoint DX DY
//   short DX DY L DX DY L    two ways of -16 to 15 each, times the scale; L: 1 lit, 0 dark
//   chars C C C              calls three subroutines: of character C, the word at table + C holds
//                            the address; character 0 is none. In text: chars "abc", of any length
//   table ADDRESS            where the characters' table lies
//   intensity N              0 dark, 255 the full current
//   colour R G B             0 to 255 each: of three guns, or of a penetration tube's layers
//   blink N                  1: what follows is dark half the time
//   scale N                  sixteenths: 16 draws relative ways as they are
//   jump ADDRESS
//   call ADDRESS
//   return
//   sync                     waits for the next tick of the machine's clock
//   again                    goes to where the list begins: another list, if one was put on show
//   pen N                    1: a light pen that sees what follows stops the processor
#pragma once

#include "display/vector/instruction_set.h"

namespace kinescope {

class GenericWords : public InstructionSet {
 public:
  void step(ProcessorCore& core) const override;
  std::vector<std::string> cost_names() const override;
  int word_bits() const override { return 32; }
  std::size_t length(std::string_view name, std::size_t operands) const override;
  std::vector<Word> encode(std::string_view name,
                           std::span<const std::int64_t> operands) const override;
  Text decode(std::span<const Word> words) const override;
};

}  // namespace kinescope
