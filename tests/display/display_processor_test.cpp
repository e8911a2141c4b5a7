#include "display/vector/display_processor.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "display/vector/assembler.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

/// A machine with a list in its memory.
struct Bench {
  explicit Bench(const std::string& text, const std::string& name = "generic")
      : machine(find_vector_machine(name)),
        memory(static_cast<std::size_t>(machine.memory_words)),
        processor(machine, memory) {
    file = assemble(text, instruction_set(machine.words), "list");
    memory.load(0, file.words);
    processor.start(file.start);
  }
  std::vector<BeamMove> run(double ms) {
    std::vector<BeamMove> moves;
    processor.run(milliseconds(ms), moves);
    return moves;
  }
  const VectorMachine& machine;
  DisplayMemory memory;
  DisplayProcessor processor;
  DisplayFile file;
};

TEST(DisplayProcessor, DrawsWhatTheListSays) {
  Bench bench("move 100 200\nintensity 51\ndraw 300 200\nrdraw -10 20\nshort 1 2 1 -3 4 0\nhalt\n");
  const auto moves = bench.run(1);
  ASSERT_EQ(moves.size(), 5u);
  EXPECT_EQ(moves[0].intensity, 0);
  EXPECT_FLOAT_EQ(moves[1].intensity, 0.2f);
  EXPECT_EQ(moves[1].x1, 300);
  EXPECT_EQ(moves[2].x1, 290);
  EXPECT_EQ(moves[2].y1, 220);
  EXPECT_EQ(moves[4].x1, 288);
  EXPECT_EQ(moves[4].intensity, 0);
  EXPECT_EQ(moves[3].address, 4u);
  EXPECT_EQ(bench.processor.status(), ProcessorStatus::kHalted);
}

TEST(DisplayProcessor, RefreshesAsOftenAsTheInstructionsTake) {
  std::string list = "start: move 0 0\n";
  for (int i = 0; i < 1000; ++i) list += fmt::format(" rdraw {} 0\n", i % 2 ? -400 : 400);
  Bench bench(list + " again\n");
  bench.run(100);
  // 2 us, 1000 vectors of 2 us and 400 units of 0.025 us, 1 us.
  EXPECT_NEAR(bench.processor.refresh_period()->count(), 1e-6 * (2 + 1000 * 12 + 1), 1e-6);
}

TEST(DisplayProcessor, WaitsForItsClock) {
  Bench bench("start: sync\nmove 0 0\ndraw 100 0\nagain\n");
  bench.run(200);
  EXPECT_NEAR(bench.processor.refresh_period()->count(), 1.0 / 60, 1e-7);
  EXPECT_NEAR(static_cast<double>(bench.processor.refreshes()), 13, 1);
}

TEST(DisplayProcessor, PointsOfTheType30Take50Microseconds) {
  std::string list = "start:\n";
  for (int i = 0; i < 1000; ++i) list += fmt::format(" point {} {}\n", i, i);
  Bench bench(list + " again\n", "type-30");
  bench.run(200);
  EXPECT_NEAR(bench.processor.refresh_period()->count(), 0.05, 0.05e-3);  // 20 Hz within 0.1 %
}

TEST(DisplayProcessor, DvgVectorsTakeTheirSteps) {
  Bench bench("labs 0 0 0\nvctr 1023 0 9 15\nvctr 1023 0 8 15\nsvec 2 0 3 15\nhalt\n", "dvg");
  const auto moves = bench.run(5);
  ASSERT_GE(moves.size(), 4u);
  EXPECT_NEAR((moves[1].end - moves[1].begin).count(), 677e-6, 0.5e-6);
  EXPECT_EQ(moves[1].x1, 1023);
  EXPECT_NEAR((moves[2].end - moves[2].begin).count(), 338.6e-6, 0.3e-6);
  EXPECT_EQ(moves[2].x1 - moves[2].x0, 511.5);
  EXPECT_EQ(moves[3].x1 - moves[3].x0, 32);  // 512 at scale 5
}

TEST(DisplayProcessor, GoesOnWhereItStopped) {
  const std::string list =
      "start: move 5 5\nloop: chars \"ab\"\n sync\n again\n"
      "a: rdraw 10 0\n return\nb: call a\n rdraw 0 10\n return\n"
      "set: table 100 - 97\n jump start\n.org 100\n.word a b\n";
  Bench whole(list), sliced(list);
  whole.processor.start(static_cast<Address>(whole.file.names.at("set")));
  sliced.processor.start(static_cast<Address>(sliced.file.names.at("set")));
  std::vector<BeamMove> want, got;
  whole.processor.run(milliseconds(50), want);
  for (int i = 1; i <= 50000; ++i) sliced.processor.run(microseconds(i), got);
  ASSERT_EQ(got.size(), want.size());
  ASSERT_GE(got.size(), 4u);
  for (std::size_t i = 0; i < got.size(); ++i) {
    ASSERT_EQ(got[i].begin, want[i].begin);
    ASSERT_EQ(got[i].x1, want[i].x1);
    ASSERT_EQ(got[i].address, want[i].address);
  }
}

TEST(DisplayProcessor, ShowsAnotherListOnceThisOneIsThrough) {
  Bench bench("one: draw 1 1\nsync\nagain\ntwo: draw 2 2\nsync\nagain\n");
  bench.processor.start(0);
  bench.run(10);
  bench.processor.show(static_cast<Address>(bench.file.names.at("two")));
  const auto moves = bench.run(40);
  ASSERT_FALSE(moves.empty());
  EXPECT_EQ(moves.front().x1, 2);
}

TEST(DisplayProcessor, StopsAtFaultsAndNamesTheAddress) {
  const auto fault = [](const std::string& list) {
    Bench bench(list);
    bench.run(500);
    EXPECT_EQ(bench.processor.status(), ProcessorStatus::kFaulted) << list;
    return bench.processor.fault().value_or(ProcessorFault{});
  };
  const ProcessorFault loop = fault("nop\nhere: jump here\n");
  EXPECT_EQ(loop.address, 1u);
  EXPECT_EQ(loop.what, "endless loop: nothing drawn for 100 ms");
  const ProcessorFault deep = fault("nop\nnop\nme: draw 1 1\ncall me\n");
  EXPECT_EQ(deep.address, 3u);
  EXPECT_EQ(deep.what, "calls more than 8 deep");
  EXPECT_EQ(fault("jump 0xfffff0").what, "address 16777200 lies outside the memory of 65536 words");
  EXPECT_EQ(fault("return").what, "return without a call");
  EXPECT_EQ(fault(".word 0xff000000").what, "0xff000000 is no instruction");
  Bench bench("here: jump here");
  bench.run(500);
  EXPECT_THROW(bench.processor.throw_fault("list"), Error);
}

TEST(DisplayProcessor, PenFindsTheInstructionThatDrew) {
  Bench bench(
      "start: pen 1\nmove 1000 1000\ncall box\nmove 2000 2000\nhere: call box\nsync\nagain\n"
      "box: rdraw 100 0\nside: rdraw 0 100\nrdraw -100 0\nrdraw 0 -100\nreturn\n");
  bench.processor.hold_pen(BeamPen{2100, 2050, 10, 0.05});
  const auto moves = bench.run(10);
  ASSERT_EQ(bench.processor.status(), ProcessorStatus::kPenHit);
  const BeamPenHit hit = *bench.processor.hit();
  EXPECT_EQ(hit.address, bench.file.names.at("side"));
  ASSERT_EQ(hit.calls.size(), 1u);
  EXPECT_EQ(hit.calls[0], bench.file.names.at("here"));
  EXPECT_NEAR(hit.y, 2042, 1);
  EXPECT_EQ(moves.back().address, hit.address);
  bench.processor.resume();
  bench.run(11);
  EXPECT_EQ(bench.processor.status(), ProcessorStatus::kRunning);
  // Dark strokes, and light beside its field, leave it quiet.
  bench.processor.hold_pen(BeamPen{1500, 1500, 10, 0.05});
  bench.run(100);
  EXPECT_EQ(bench.processor.status(), ProcessorStatus::kRunning);
}

/// Random lists of every instruction that draws: the rate is what the machine's table adds up to.
TEST(DisplayProcessor, TheRefreshIsTheSumOfTheInstructionsTimes) {
  const VectorMachine& m = find_vector_machine("generic");
  const auto cost = [&](const std::string& name, double units) {
    for (const InstructionCost& c : m.costs) {
      if (c.name == name) return c.fixed_us + c.per_unit_us * units;
    }
    return 0.0;
  };
  std::uint32_t seed = 1;
  const auto random = [&](int most) {
    seed = seed * 1664525 + 1013904223;
    return static_cast<int>(seed >> 8) % most;
  };
  for (const int count : {10, 300, 4000}) {
    std::string list = "start: call sub\n";
    double us = cost("call", 0) + cost("rdraw", std::hypot(30, 40)) + cost("return", 0), x = 0,
           y = 0;
    us += cost("move", 0);
    for (int i = 0; i < count; ++i) {
      const int to_x = random(4096), to_y = random(4096);
      const std::string name = random(2) != 0 ? "draw" : "move";
      list += fmt::format(" {} {} {}\n intensity {}\n", name, to_x, to_y, random(256));
      // From the subroutine's end at first.
      const double from_x = i == 0 ? 30 : x, from_y = i == 0 ? 40 : y;
      us += cost(name, std::hypot(to_x - from_x, to_y - from_y)) + cost("intensity", 0);
      x = to_x, y = to_y;
    }
    Bench bench(list + " move 0 0\n again\nsub: rdraw 30 40\n return\n");
    us += cost("move", std::hypot(x, y)) - cost("move", 0) + cost("again", 0);
    bench.run(3.5e-3 * us);
    ASSERT_TRUE(bench.processor.refresh_period());
    EXPECT_NEAR(bench.processor.refresh_period()->count() / (1e-6 * us), 1, 1e-3) << count;
  }
}

TEST(DisplayProcessor, TheType30DrawsNoLines) {
  for (const char* list :
       {"point 1 1\ndraw 5 5\n", "point 1 1\nrdraw 5 5\n", "nop\nshort 1 1 1\n"}) {
    Bench bench(list, "type-30");
    bench.run(1);
    ASSERT_EQ(bench.processor.status(), ProcessorStatus::kFaulted) << list;
    EXPECT_EQ(bench.processor.fault()->address, 1u);
    EXPECT_NE(bench.processor.fault()->what.find("type-30 has no "), std::string::npos);
  }
}

TEST(DisplayProcessor, BlinksHalfTheTimeWhateverTheRefresh) {
  Bench bench("start: blink 1\ndraw 100 0\nblink 0\ndraw 0 0\nsync\nagain\n");
  int lit = 0, dark = 0;
  for (const BeamMove& move : bench.run(3000)) {
    if (move.address == 3) {
      EXPECT_EQ(move.intensity, 1);
    }
    if (move.address == 1) ++(move.intensity > 0 ? lit : dark);
  }
  EXPECT_NEAR(lit, 90, 4);
  EXPECT_NEAR(dark, 90, 4);
}

TEST(DisplayProcessor, DvgScalesBeyondNineDrawNothing) {
  Bench bench("labs 100 100 3\nvctr 512 0 9 15\nvctr 512 0 2 15\nhalt\n", "dvg");
  const auto moves = bench.run(1);
  ASSERT_GE(moves.size(), 2u);
  EXPECT_EQ(moves[1].x0, 100);
  EXPECT_EQ(moves[1].x1, 100 + 512.0 / 16);
}

TEST(DisplayProcessor, EveryMachinesFaultsNameTheAddress) {
  const auto fault = [](const std::string& list, const std::string& machine) {
    Bench bench(list, machine);
    bench.run(500);
    EXPECT_EQ(bench.processor.status(), ProcessorStatus::kFaulted) << list;
    return bench.processor.fault().value_or(ProcessorFault{});
  };
  EXPECT_EQ(fault("halt\nstart: jmpl 1\n", "dvg").address, 1u);
  EXPECT_EQ(fault("start: jsrl 0\n", "dvg").what, "calls more than 4 deep");
  EXPECT_EQ(fault("rtsl\n", "dvg").what, "return without a call");
  EXPECT_NE(fault("jump 9000\n", "type-30").what.find("address 9000 lies outside"),
            std::string::npos);
  // Over the end of memory; a character's table that is not there.
  EXPECT_EQ(fault("jump 65535\n.org 65535\nnop\n", "generic").address, 65536u);
  const ProcessorFault untold = fault("nop\nchars \"ab\"\n", "generic");
  EXPECT_EQ(untold.what, "chars before any table of characters");
  EXPECT_EQ(untold.address, 1u);
  EXPECT_EQ(fault("table 0xffff00\nchars \"a\"\n", "generic").address, 1u);
}

TEST(VectorMachine, BadFilesAreRefusedByTheirLine) {
  const auto fault = [](const std::string& text) {
    try {
      parse_vector_machine(text, "mine", "mine.txt");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(fault("words dvg\ncost fetch 1\n").find("the cost of labs is missing"),
            std::string::npos);
  EXPECT_NE(fault("# a\nstack 0\n").find("line 2: stack must lie from 1 to 1024"),
            std::string::npos);
  EXPECT_NE(fault("words latin\n").find("words latin are not known"), std::string::npos);
  EXPECT_NE(fault("phosphor P999\n").find("P999"), std::string::npos);
  EXPECT_NE(fault("colour red\n").find("\"colour\" is not known"), std::string::npos);
  EXPECT_NE(fault("size 12\n").find("lacks a number"), std::string::npos);
  EXPECT_NE(fault("memory 1e9\n").find("memory must lie"), std::string::npos);
  EXPECT_NE(fault("damping\n").find("damping lacks its value"), std::string::npos);
}

}  // namespace
}  // namespace kinescope
