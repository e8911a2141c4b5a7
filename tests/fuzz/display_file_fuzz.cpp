#include <string_view>

#include "display/vector/assembler.h"
#include "display/vector/display_processor.h"
#include "tests/fuzz/fuzz.h"

namespace kinescope {
namespace {

/// Runs what was assembled for a few refreshes; what is disassembled must be the same words.
void check(std::string_view text, const VectorMachine& machine) {
  const InstructionSet& set = instruction_set(machine.words);
  const DisplayFile file = assemble(text, set, "list");
  if (file.words.size() > 4096) return;
  if (assemble(disassemble(file.words, set), set, "list").words != file.words) std::abort();
  DisplayMemory memory(static_cast<std::size_t>(machine.memory_words));
  memory.load(0, file.words);
  DisplayProcessor processor(machine, memory);
  processor.start(file.start);
  std::vector<BeamMove> moves;
  processor.run(milliseconds(5), moves);
  Seconds last{0};
  for (const BeamMove& move : moves) {
    if (move.begin < last || move.end < move.begin) std::abort();
    last = move.end;
  }
}

}  // namespace
}  // namespace kinescope

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinescope::fuzz_reader(data, size, [](auto bytes) {
    if (bytes.empty()) return;
    const auto machines = kinescope::vector_machines();
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    // A seed's first letter picks the machine: lists may begin with any.
    kinescope::check(text, machines[bytes[0] % machines.size()]);
  });
  return 0;
}
