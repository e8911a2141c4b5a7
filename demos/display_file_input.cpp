#include "demos/display_file_input.h"

#include <fmt/format.h>

#include <algorithm>

#include "display/vector/display_processor.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 26;
constexpr Seconds kSlice = milliseconds(1), kLongest(600);

bool looks_like_text(std::span<const std::uint8_t> bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t c) {
    return c == '\t' || c == '\n' || c == '\r' || (c >= ' ' && c != 0x7f);
  });
}

/// The lowest byte first.
Word word_at(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t bytes_a_word) {
  Word word = 0;
  for (std::size_t b = 0; b < bytes_a_word; ++b) word |= Word{bytes[at + b]} << (8 * b);
  return word;
}

}  // namespace

bool looks_like_display_file(std::span<const std::uint8_t> first_bytes, bool all,
                             const InstructionSet& set) {
  if (first_bytes.empty()) return false;
  if (looks_like_text(first_bytes)) {
    const std::string_view text(reinterpret_cast<const char*>(first_bytes.data()),
                                first_bytes.size());
    return is_display_file_text(all ? text : text.substr(0, text.rfind('\n') + 1), set);
  }
  const auto bytes_a_word = static_cast<std::size_t>(set.word_bits() / 8);
  if (all && first_bytes.size() % bytes_a_word != 0) return false;
  std::vector<Word> words;
  for (std::size_t i = 0; i + bytes_a_word <= first_bytes.size(); i += bytes_a_word) {
    words.push_back(word_at(first_bytes, i, bytes_a_word));
  }
  for (std::size_t at = 0; at < words.size();) {
    const InstructionSet::Text text = set.decode(std::span(words).subspan(at));
    const bool cut_off = !all && at + 1 == words.size();
    if (text.text.empty() && !cut_off) return false;
    at += text.words;
  }
  return std::any_of(words.begin(), words.end(), [](Word word) { return word != 0; });
}

DisplayFile read_display_file(InputFile& input, const InstructionSet& set,
                              std::optional<bool> is_text) {
  const std::vector<std::uint8_t> bytes = input.rest(kMostBytes);
  if (bytes.empty()) throw_bad_input("is empty", input.name());
  if (is_text.value_or(looks_like_text(bytes))) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return assemble(text, set, input.name());
  }
  const auto bytes_a_word = static_cast<std::size_t>(set.word_bits() / 8);
  if (bytes.size() % bytes_a_word != 0) {
    throw_bad_input(fmt::format("{} bytes are no whole number of words of {} bytes", bytes.size(),
                                bytes_a_word),
                    input.name());
  }
  DisplayFile file;
  for (std::size_t i = 0; i < bytes.size(); i += bytes_a_word) {
    file.words.push_back(word_at(bytes, i, bytes_a_word));
  }
  return file;
}

std::size_t memory_for(const VectorMachine& machine, const DisplayFile& program) {
  const auto built = static_cast<std::size_t>(machine.memory_words);
  return machine.name == "generic" ? std::max(built, program.words.size()) : built;
}

std::string words_as_bytes(std::span<const Word> words, const InstructionSet& set) {
  std::string bytes;
  for (const Word word : words) {
    for (int bit = 0; bit < set.word_bits(); bit += 8) {
      bytes += static_cast<char>(word >> bit & 0xff);
    }
  }
  return bytes;
}

VectorDrawing one_refresh(const VectorMachine& machine, const DisplayFile& program,
                          const std::string& name) {
  DisplayMemory memory(memory_for(machine, program));
  if (program.words.size() > memory.size()) {
    throw_bad_input(fmt::format("its {} words do not fit the machine's memory of {}",
                                program.words.size(), memory.size()),
                    name);
  }
  memory.load(0, program.words);
  DisplayProcessor processor(machine, memory);
  processor.start(program.start);
  std::vector<BeamMove> moves;
  Seconds end{0};
  // A list that draws nothing is given time to be found endless.
  while ((processor.refreshes() < 2 || moves.empty()) && end < kLongest &&
         processor.status() == ProcessorStatus::kRunning) {
    end += kSlice;
    processor.run(end, moves);
  }
  processor.throw_fault(name);
  const Seconds length = processor.refresh_period().value_or(end);
  VectorDrawing drawing;
  drawing.size = {static_cast<float>(machine.width), static_cast<float>(machine.height)};
  for (const BeamMove& m : moves) {
    if (!(m.intensity > 0) || m.begin >= length) continue;
    drawing.line({static_cast<float>(m.x0), static_cast<float>(m.y0)},
                 {static_cast<float>(m.x1), static_cast<float>(m.y1)}, m.intensity);
  }
  return drawing;
}

}  // namespace kinescope
