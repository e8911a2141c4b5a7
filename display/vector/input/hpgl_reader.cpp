#include "display/vector/input/hpgl_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <unordered_map>

#include "display/vector/input/hpgl_plotter.h"
#include "display/vector/input/hpgl_scanner.h"
#include "display/vector/input/stroke_font.h"

namespace kinescope {
namespace {

/// Instructions that draw nothing, or tell the computer something.
constexpr std::array kQuiet{"VS", "FS", "AS", "CA", "CS", "SS", "SA", "CM", "DS", "IV", "OA", "OC",
                            "OD", "OE", "OF", "OH", "OI", "OK", "OL", "OO", "OP", "OS", "OT", "OW",
                            "LA", "UL", "NP", "CR", "MC", "TR", "AC", "QL", "EC", "NR", "RP", "SB",
                            "SV", "TD", "CF", "FI", "FN", "MG", "CT", "DC", "DP", "BF", "GM", "GC",
                            "GP", "IM", "KY", "LM", "RC", "CC", "NM", "SD", "AD", "UC", "WD"};

using Table = std::unordered_map<std::string_view, void (*)(HpglPlotter& plotter,
                                                            const std::vector<double>& numbers)>;

Table make_table() {
  Table table;
  for (const HpglAction& action : hpgl_setup_actions()) table.emplace(action.name, action.obey);
  for (const HpglAction& action : hpgl_drawing_actions()) table.emplace(action.name, action.obey);
  return table;
}

/// Those that take text. @return false if it is none of them
bool obey_text(const HpglInstruction& instruction, HpglPlotter& plotter, HpglScanner& scanner) {
  const std::string& name = instruction.name;
  if (name == "LB") {
    hpgl_label(plotter, instruction.text);
  } else if (name == "BL") {
    plotter.label_buffer = instruction.text;
  } else if (name == "DT") {
    scanner.set_terminator(instruction.text.empty() ? '\x03' : instruction.text[0]);
  } else if (name == "SM") {
    plotter.symbol = instruction.text.empty() ? '\0' : instruction.text[0];
  } else {
    return name == "CO";
  }
  return true;
}

/// The area that shows all strokes, with a fiftieth around it.
void frame(VectorDrawing& drawing) {
  glm::vec2 least{HUGE_VALF}, most{-HUGE_VALF};
  const auto take = [&](glm::vec2 p) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y)};
  };
  for (const VectorSegment& s : drawing.segments) {
    take({s.x1, s.y1});
    take({s.x2, s.y2});
  }
  for (const DrawnText& text : drawing.texts) {
    for_each_text_stroke(text, [&](glm::vec2 from, glm::vec2 to) {
      take(from);
      take(to);
    });
  }
  if (!(least.x <= most.x)) return;
  const glm::vec2 size = most - least;
  const float margin = std::max({size.x, size.y, 50.0f}) / 50;
  drawing.origin = least - margin;
  drawing.size = size + 2 * margin;
}

}  // namespace

VectorDrawing read_hpgl(std::span<const std::uint8_t> bytes, const std::string& name,
                        Warnings* warnings) {
  static const Table table = make_table();
  VectorDrawing drawing;
  HpglPlotter plotter(drawing);
  plotter.name = name;
  HpglScanner scanner(bytes);
  HpglInstruction instruction;
  std::set<std::string> unknown;
  std::size_t known = 0;
  while (scanner.next(instruction)) {
    if (const auto found = table.find(instruction.name); found != table.end()) {
      found->second(plotter, instruction.numbers);
    } else if (!obey_text(instruction, plotter, scanner) &&
               std::find(kQuiet.begin(), kQuiet.end(), instruction.name) == kQuiet.end()) {
      if (unknown.size() < 100) unknown.insert(instruction.name);
      continue;
    }
    ++known;
  }
  plotter.set_down(false);
  if (known == 0) throw_bad_input("holds no HP-GL instruction", name);
  if (warnings && !unknown.empty()) {
    std::string list;
    for (const std::string& word : unknown) list += (list.empty() ? "" : " ") + word;
    warnings->push_back(name +
                        ": passed over instructions that are not known: " + list.substr(0, 100));
  }
  frame(drawing);
  return drawing;
}

}  // namespace kinescope
