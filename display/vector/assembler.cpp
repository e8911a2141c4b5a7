#include "display/vector/assembler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "display/vector/operands.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr std::size_t kMostWords = std::size_t{1} << 24;

bool in_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }

/// "-5" after a blank is a number; in "a-5" and "a - 5" the sign stands between two.
bool starts_negative_number(std::string_view line, std::size_t at) {
  return line[at] == '-' && at + 1 < line.size() &&
         std::isdigit(static_cast<unsigned char>(line[at + 1])) != 0 &&
         (at == 0 || !in_name(line[at - 1]));
}

/// Cuts a line into tokens: names and numbers, signs, strings with their quotes.
std::vector<std::string> tokens_of(std::string_view line) {
  std::vector<std::string> tokens;
  std::size_t i = 0;
  while (i < line.size()) {
    const std::size_t from = i;
    const char c = line[i++];
    if (is_blank(c)) continue;
    if (c == ';') break;
    if (c == '"' || c == '\'') {
      const std::size_t close = line.find(c, i);
      if (close == std::string_view::npos) throw_bad_input(fmt::format("{} is not closed", c));
      i = close + 1;
    } else if (in_name(c) || starts_negative_number(line, from)) {
      while (i < line.size() && in_name(line[i])) ++i;
    } else if (std::string_view(":=+-").find(c) == std::string_view::npos) {
      throw_bad_input(fmt::format("\"{}\" is not understood", c));
    }
    tokens.emplace_back(line.substr(from, i - from));
  }
  return tokens;
}

std::int64_t number_of(const std::string& token) {
  if (token.size() == 3 && token[0] == '\'') return static_cast<unsigned char>(token[1]);
  const bool hex = token.starts_with("0x");
  std::int64_t value = 0;
  const char* const end = token.data() + token.size();
  const auto [rest, fault] =
      std::from_chars(token.data() + (hex ? 2 : 0), end, value, hex ? 16 : 10);
  if (fault != std::errc() || rest != end) throw_bad_input("\"" + token + "\" is not a number");
  return value;
}

/// One that stands for an operand's value, not for a sign.
bool is_term(const std::string& token) { return token != "+" && token != "-"; }

/// Two passes over the lines: the first finds where labels lie, the second makes words.
class Assembler {
 public:
  Assembler(const InstructionSet& set, const std::string& file) : set_(set), file_(file) {}

  DisplayFile assemble(std::string_view text) {
    for (const bool final_pass : {false, true}) {
      final_ = final_pass;
      at_ = 0;
      std::string_view left = text;
      for (line_ = 1; !left.empty(); ++line_) {
        const std::size_t end = left.find('\n');
        take_line_or_tell(left.substr(0, end));
        left.remove_prefix(end == std::string_view::npos ? left.size() : end + 1);
      }
    }
    const auto start = out_.names.find("start");
    if (start != out_.names.end()) out_.start = static_cast<Address>(start->second);
    return std::move(out_);
  }

 private:
  using Tokens = std::span<const std::string>;

  void take_line_or_tell(std::string_view line) {
    try {
      take_line(line);
    } catch (const Error& error) {
      throw_bad_input(error.what(), file_, "line " + std::to_string(line_));
    }
  }

  void take_line(std::string_view line) {
    const std::vector<std::string> all = tokens_of(line);
    Tokens tokens(all);
    if (tokens.size() >= 2 && tokens[1] == ":") {
      define(tokens[0], at_);
      tokens = tokens.subspan(2);
    }
    if (tokens.empty()) return;
    if (tokens.size() >= 2 && tokens[1] == "=") {
      const auto values = values_of(tokens.subspan(2), true);
      if (values.size() != 1) throw_bad_input(tokens[0] + " = takes one value");
      return define(tokens[0], values[0]);
    }
    if (tokens[0] == ".org") return go_on_at(tokens.subspan(1));
    take_words(tokens[0], tokens.subspan(1));
  }

  void define(const std::string& name, std::int64_t value) {
    if (!in_name(name[0]) || std::isdigit(static_cast<unsigned char>(name[0])) != 0) {
      throw_bad_input("\"" + name + "\" is no name");
    }
    if (!final_ && out_.names.contains(name)) throw_bad_input(name + " is defined twice");
    out_.names[name] = value;
  }

  void go_on_at(Tokens operands) {
    const auto values = values_of(operands, true);
    if (values.size() != 1) throw_bad_input(".org takes one address");
    if (values[0] < 0 || values[0] > static_cast<std::int64_t>(kMostWords)) {
      throw_bad_input(fmt::format("address {} lies outside any memory", values[0]));
    }
    at_ = static_cast<std::size_t>(values[0]);
  }

  void take_words(const std::string& name, Tokens operands) {
    const auto values = values_of(operands, final_);
    const std::size_t length = name == ".word" ? values.size() : set_.length(name, values.size());
    if (name != ".word" && length == 0) throw_bad_input("no instruction \"" + name + "\"");
    if (at_ + length > kMostWords) throw_bad_input("more words than any memory has");
    if (final_) {
      std::vector<Word> words;
      if (name == ".word") {
        for (const std::int64_t v : values) words.push_back(unsigned_field(v, set_.word_bits()));
      } else {
        words = set_.encode(name, values);
      }
      if (out_.words.size() < at_ + length) out_.words.resize(at_ + length, 0);
      std::copy(words.begin(), words.end(), out_.words.begin() + static_cast<std::ptrdiff_t>(at_));
    }
    at_ += length;
  }

  /// @param known whether every name must be known; if not, unknown ones count as 0
  std::vector<std::int64_t> values_of(Tokens tokens, bool known) const {
    std::vector<std::int64_t> values;
    for (std::size_t i = 0; i < tokens.size();) {
      if (tokens[i][0] == '"') {
        for (const char c : tokens[i].substr(1, tokens[i].size() - 2)) {
          values.push_back(static_cast<unsigned char>(c));
        }
        ++i;
        continue;
      }
      values.push_back(sum_of(tokens, i, known));
    }
    return values;
  }

  /// A term, and those that follow with a sign between.
  std::int64_t sum_of(Tokens tokens, std::size_t& i, bool known) const {
    std::int64_t sum = term(tokens, i, known);
    while (i + 1 < tokens.size() && !is_term(tokens[i]) && is_term(tokens[i + 1])) {
      const bool minus = tokens[i++] == "-";
      const std::int64_t v = term(tokens, i, known);
      sum += minus ? -v : v;
    }
    return sum;
  }

  std::int64_t term(Tokens tokens, std::size_t& i, bool known) const {
    if (i >= tokens.size()) throw_bad_input("a value is missing");
    const std::string& token = tokens[i++];
    const char first = token[0] == '-' && token.size() > 1 ? token[1] : token[0];
    if (first == '\'' || std::isdigit(static_cast<unsigned char>(first)) != 0)
      return number_of(token);
    const auto found = out_.names.find(token);
    if (found != out_.names.end()) return found->second;
    if (known) throw_bad_input("\"" + token + "\" is not defined");
    return 0;
  }

  const InstructionSet& set_;
  std::string file_;
  DisplayFile out_;
  bool final_ = false;
  std::size_t at_ = 0;
  int line_ = 0;
};

}  // namespace

bool is_display_file_text(std::string_view text, const InstructionSet& set) {
  bool instructs = false;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::vector<std::string> tokens;
    try {
      tokens = tokens_of(text.substr(0, end));
    } catch (const Error&) {
      return false;
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (tokens.size() >= 2 && tokens[1] == ":") tokens.erase(tokens.begin(), tokens.begin() + 2);
    if (tokens.empty() || (tokens.size() > 2 && tokens[1] == "=")) continue;
    if (set.length(tokens[0], tokens.size() - 1) > 0) {
      instructs = true;
    } else if (tokens[0] != ".org" && tokens[0] != ".word") {
      return false;
    }
  }
  return instructs;
}

DisplayFile assemble(std::string_view text, const InstructionSet& set, const std::string& file) {
  return Assembler(set, file).assemble(text);
}

std::string disassemble(std::span<const Word> words, const InstructionSet& set) {
  std::string out;
  for (std::size_t at = 0; at < words.size();) {
    InstructionSet::Text text = set.decode(words.subspan(at));
    // Bits that no operand holds would be lost.
    const auto same = [&] {
      const DisplayFile again = assemble(text.text, set, {});
      return std::equal(again.words.begin(), again.words.end(),
                        words.begin() + static_cast<std::ptrdiff_t>(at));
    };
    if (text.text.empty() || !same()) text = {fmt::format(".word {:#x}", words[at]), 1};
    out += fmt::format("        {:<32}; {:#06x}\n", text.text, at);
    at += text.words;
  }
  return out;
}

}  // namespace kinescope
