#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "display/vector/assembler.h"
#include "display/vector/display_processor.h"
#include "display/vector/stroke_list.h"
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

TEST(DisplayFile, IsToldByItsText) {
  const InstructionSet& set = instruction_set("generic");
  EXPECT_TRUE(is_display_file_text("; a list\nscale 16\nbox: .word 3\nhere = 5\n\n", set));
  EXPECT_TRUE(is_display_file_text("start: move here 2\n", set));
  for (const char* const other :
       {"", "box:\n", ".word 7\n", "SC0,16;SP1;\n", "IN;\n", "move 1 2\nPU 3 4\n",
        "move 1 2\n<svg>\n", "move 1 \"\n", "\x1d move\n"}) {
    EXPECT_FALSE(is_display_file_text(other, set)) << other;
  }
  EXPECT_FALSE(is_display_file_text("move 1 2\n", instruction_set("dvg")));
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

using Stroke = std::array<double, 4>;

/// What a list draws in its first refresh, each stroke from its lesser end; and its dark ways.
struct DrawnList {
  std::multiset<Stroke> strokes;
  int dark = 0;
  Seconds period{0};
};
DrawnList run_list(const std::vector<Word>& words, const VectorMachine& machine) {
  DisplayMemory memory(words.size());
  memory.load(0, words);
  DisplayProcessor processor(machine, memory);
  processor.start(0);
  std::vector<BeamMove> moves;
  for (Seconds end{0}; processor.refreshes() < 5;) processor.run(end += milliseconds(1), moves);
  DrawnList drawn;
  drawn.period = *processor.refresh_period();
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const BeamMove& m = moves[i];
    if (i > 0 && m.address < moves[i - 1].address) break;
    drawn.dark += m.intensity == 0;
    if (m.intensity > 0) {
      drawn.strokes.insert(std::min(Stroke{m.x0, m.y0, m.x1, m.y1}, {m.x1, m.y1, m.x0, m.y0}));
    }
  }
  return drawn;
}

TEST(StrokeList, DrawsEachStrokeOnceInTrails) {
  const VectorMachine& machine = find_vector_machine("generic");
  // A square with both diagonals, in no order; one side twice, one turned round, and points.
  const std::vector<VectorSegment> strokes{{0, 0, 100, 0},   {100, 100, 0, 100}, {0, 0, 0, 100.2f},
                                           {0, 0, 100, 100}, {5, 5, 5.3f, 5},    {100, 0, 100, 100},
                                           {100, 0, 0, 0},   {100, 0, 0, 100},   {7, 7, 7, 7}};
  const DrawnList drawn = run_list(stroke_list(strokes, machine), machine);
  EXPECT_EQ(drawn.strokes, (std::multiset<Stroke>{{0, 0, 100, 0},
                                                  {0, 100, 100, 100},
                                                  {0, 0, 0, 100},
                                                  {0, 0, 100, 100},
                                                  {100, 0, 100, 100},
                                                  {0, 100, 100, 0}}));
  EXPECT_EQ(drawn.dark, 2);  // four corners of three strokes: two trails
  EXPECT_NEAR(drawn.period.count(), 1.0 / 60, 1e-6) << "it waits for the clock";
}

TEST(StrokeList, DrawsAllOfManyAndALongOneWaitsForNoClock) {
  const VectorMachine& machine = find_vector_machine("generic");
  std::mt19937 random(3);
  std::vector<VectorSegment> strokes;
  std::set<Stroke> want;
  const auto place = [&] { return static_cast<float>(random() % 12 * 300); };
  for (int i = 0; i < 1500; ++i) {
    const VectorSegment s{place(), place(), place(), place()};
    strokes.push_back(s);
    if (s.x1 == s.x2 && s.y1 == s.y2) continue;
    want.insert(std::min(Stroke{s.x1, s.y1, s.x2, s.y2}, {s.x2, s.y2, s.x1, s.y1}));
  }
  const DrawnList drawn = run_list(stroke_list(strokes, machine), machine);
  EXPECT_EQ(drawn.strokes, std::multiset<Stroke>(want.begin(), want.end()));
  EXPECT_LT(drawn.dark, 72 + 2);  // at most one for two places
  EXPECT_GT(drawn.period.count(), 0.02);
  const double ticks = drawn.period.count() * 60;
  EXPECT_GT(std::abs(ticks - std::round(ticks)), 1e-3);
}

TEST(StrokeList, SomeMachinesDrawNoLines) {
  EXPECT_THROW(stroke_list({}, find_vector_machine("dvg")), Error);
  EXPECT_THROW(stroke_list({}, find_vector_machine("type-30")), Error);
  EXPECT_EQ(stroke_list({}, find_vector_machine("generic")).size(), 2u);
}

}  // namespace
}  // namespace kinescope
