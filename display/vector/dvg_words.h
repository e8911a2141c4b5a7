// Atari's digital vector generator (Asteroids, 1979; Lunar Lander): its own instruction words, of
// 16 bits. Memory is addressed by words.
//
//   vctr DX DY SCALE Z       ways of -1023 to 1023, shifted right by 9 - (SCALE + global scale)
//   labs X Y SCALE           dark, to a place of 10 bits each; sets the global scale
//   svec DX DY SCALE Z       short: DX and DY of -3 to 3, in units of 256; SCALE 0 to 3, plus 2
//   jmpl, jsrl ADDRESS       12 bits
//   rtsl
//   halt                     until started again
//
// A vector takes 2^(s + 1) steps of 8 clocks whatever its direction, s being the sum of scales,
// four bits; beyond 9 none at all. So its brightness depends on its length. Words, scales, steps
// and the stack of four calls agree with MAME's avgdvg.cpp, which follows the schematics. Not
// modelled: what the state machine needs besides for fetching (each word is taken to cost two
// steps, a byte each: assumed), `labs`'s settling, and that counters that leave the screen blank
// the beam.
#pragma once

#include "display/vector/instruction_set.h"

namespace kinescope {

class DvgWords : public InstructionSet {
 public:
  void step(ProcessorCore& core) const override;
  std::vector<std::string> cost_names() const override;
  int word_bits() const override { return 16; }
  std::size_t length(std::string_view name, std::size_t operands) const override;
  std::vector<Word> encode(std::string_view name,
                           std::span<const std::int64_t> operands) const override;
  Text decode(std::span<const Word> words) const override;
};

}  // namespace kinescope
