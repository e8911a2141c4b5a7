#include "display/vector/input/read_vectors.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "display/vector/input/hpgl_reader.h"
#include "display/vector/input/svg_reader.h"
#include "display/vector/input/tek_reader.h"
#include "display/vector/input/wav_reader.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 31;

bool begins(std::string_view text, std::string_view with) { return text.starts_with(with); }

/// A plotter's own escapes: device control, HP-GL/2 in a printer's stream.
bool is_plotter_escape(std::string_view text) {
  return begins(text, "\x1b.") || begins(text, "\x1b%-") || begins(text, "\x1b%0B") ||
         begins(text, "\x1b%1B") ||
         begins(text,
                "\x1b"
                "E");
}

bool is_tek_control(char c) {
  return c == '\x1d' || c == '\x1e' || c == '\x1f' || c == '\x1c' || c == '\x0c';
}

/// Instructions that plots begin with, and any others of two capitals.
bool is_instruction(std::string_view text) {
  const auto letter = [&](std::size_t i) {
    return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
  };
  if (!letter(0) || !letter(1)) return false;
  // A third letter begins the next instruction, or a label.
  const std::string name{static_cast<char>(std::toupper(text[0])),
                         static_cast<char>(std::toupper(text[1]))};
  constexpr std::array kNames{"IN", "DF", "SP", "PU", "PD", "PA", "PR", "SC", "IP", "LB", "SI",
                              "SR", "DI", "DR", "LT", "VS", "PS", "CO", "BP", "NP", "PW", "RO",
                              "IW", "CI", "AA", "AR", "EA", "RA", "CS", "PC", "FS", "SM", "CA",
                              "DT", "LO", "FT", "PT", "OI", "OE", "AF", "PG", "ES", "WU"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

}  // namespace

std::span<const std::string_view> vector_kind_names() {
  static constexpr std::array<std::string_view, 4> kNames{"tek", "hpgl", "svg", "wav"};
  return kNames;
}

std::optional<VectorKind> recognise_vectors(std::span<const std::uint8_t> first_bytes) {
  std::string_view text(reinterpret_cast<const char*>(first_bytes.data()), first_bytes.size());
  if (begins(text, "RIFF") || begins(text, "RF64")) return VectorKind::kWav;
  if (begins(text, "\xef\xbb\xbf")) text.remove_prefix(3);
  const std::string_view words =
      text.substr(std::min(text.find_first_not_of(" \t\r\n;"), text.size()));
  if (begins(words, "<")) return VectorKind::kSvg;
  if (is_plotter_escape(words)) return VectorKind::kHpgl;
  if (is_instruction(words)) return VectorKind::kHpgl;
  if (begins(words, "\x1b") || std::any_of(text.begin(), text.end(), is_tek_control)) {
    return VectorKind::kTek;
  }
  return std::nullopt;
}

namespace {

VectorKind kind_of(InputFile& input) {
  const auto first = input.peek(kRecogniseBytes);
  if (first.empty()) throw_bad_input("is empty", input.name());
  if (first.size() > 1 && first[0] == 0x1f && first[1] == 0x8b) {
    throw_bad_input("is compressed; pass it through gunzip first", input.name());
  }
  if (const auto kind = recognise_vectors(first)) return *kind;
  throw_bad_input(
      "is no Tektronix stream, HP-GL, SVG, WAV, display file or model that can be recognised; "
      "see --kind",
      input.name());
}

VectorDrawing read_tek_stream(InputFile& input) {
  VectorDrawing drawing;
  TekReader terminal;
  std::vector<std::uint8_t> bytes;
  constexpr std::size_t kBlock = 1 << 16;
  while (input.append_to(bytes, kBlock) > 0) {
    terminal.read(bytes, drawing);
    bytes.clear();
  }
  terminal.flush(drawing);
  return drawing;
}

}  // namespace

VectorDrawing read_vectors(InputFile& input, std::optional<VectorKind> kind, Warnings* warnings) {
  if (!kind) kind = kind_of(input);
  switch (*kind) {
    case VectorKind::kTek:
      return read_tek_stream(input);
    case VectorKind::kHpgl:
      return read_hpgl(input.rest(kMostBytes), input.name(), warnings);
    case VectorKind::kSvg:
      return read_svg(input.rest(kMostBytes), input.name());
    case VectorKind::kWav:
      return read_wav(input.rest(kMostBytes), input.name());
  }
  throw_bad_input("is of no kind that can be read", input.name());
}

}  // namespace kinescope
