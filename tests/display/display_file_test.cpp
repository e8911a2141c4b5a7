#include <gtest/gtest.h>

#include <random>

#include "display/vector/assembler.h"
#include "display/vector/display_processor.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

std::string fault_of(const std::string& text) {
  try {
    assemble(text, instruction_set("generic"), "list.txt");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(DisplayFile, AssemblesWhatItSays) {
  const DisplayFile file = assemble(
      "size = 40 - 8\nstart: move size, 2 ; a comment\n"
      " rdraw -5 size+1\nloop: jump loop - 1\n chars \"abcd\"\n"
      ".org 0x10\n.word 7 'A'\n",
      instruction_set("generic"), "list.txt");
  ASSERT_EQ(file.words.size(), 18u);
  EXPECT_EQ(file.start, 0u);
  EXPECT_EQ(file.words[0], 0x02020002u);
  EXPECT_EQ(file.words[1], 0x06ffb021u);
  EXPECT_EQ(file.words[2], 0x0f000001u);
  EXPECT_EQ(file.words[3], 0x09616263u);
  EXPECT_EQ(file.words[4], 0x09640000u);
  EXPECT_EQ(file.words[16], 7u);
  EXPECT_EQ(file.words[17], 65u);
}

TEST(DisplayFile, KnowsTheDvgsWords) {
  const DisplayFile file =
      assemble("vctr 1 -2 9 15\nlabs 512 3 1\nsvec -3 1 2 7\njsrl 0x123\nhalt\n",
               instruction_set("dvg"), "list.txt");
  EXPECT_EQ(file.words,
            (std::vector<Word>{0x9402, 0xf001, 0xa003, 0x1200, 0xf17f, 0xc123, 0xb000}));
}

TEST(DisplayFile, DisassembledAssemblesToTheSameWords) {
  std::mt19937 random(1);
  for (const char* name : {"generic", "dvg"}) {
    const InstructionSet& set = instruction_set(name);
    std::vector<Word> words(4000);
    for (Word& w : words) {
      w = static_cast<Word>(random());
      if (set.word_bits() == 16) w &= 0xffff;
      if (set.word_bits() == 32 && random() % 8 != 0)
        w = (w & 0xffffff) | static_cast<Word>(random() % 22) << 24;
    }
    const std::string text = disassemble(words, set);
    EXPECT_EQ(assemble(text, set, "list.txt").words, words) << name;
  }
}

TEST(DisplayFile, TellsTheLineOfAFault) {
  EXPECT_EQ(fault_of("nop\nfly 1 2\n"), "list.txt: line 2: no instruction \"fly\"");
  EXPECT_EQ(fault_of("jump nowhere"), "list.txt: line 1: \"nowhere\" is not defined");
  EXPECT_NE(fault_of("move 1 5000").find("5000 must lie from 0 to 4095"), std::string::npos);
  EXPECT_NE(fault_of("move 1").find("move takes 2 operands, not 1"), std::string::npos);
  EXPECT_NE(fault_of("a: nop\na: nop").find("line 2: a is defined twice"), std::string::npos);
  EXPECT_NE(fault_of("chars \"abc"), "");
  EXPECT_NE(fault_of(".org -1"), "");
  EXPECT_NE(fault_of(".word 1 +"), "");
  EXPECT_NE(fault_of("= 3"), "");
}

}  // namespace
}  // namespace kinescope
