#include "display/vector/machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "display/data_lines.h"
#include "display/phosphor.h"
#include "display/vector/instruction_set.h"
#include "raster/base/error.h"
#include "vector_machines.h"

namespace kinescope {
namespace {

int whole(double v) { return static_cast<int>(v); }

using Key = NumberKey<VectorMachine>;

constexpr std::array kNumbers{
    Key{"memory", 16, 1 << 24, [](VectorMachine& m, double v) { m.memory_words = whole(v); }},
    Key{"stack", 1, 1024, [](VectorMachine& m, double v) { m.stack = whole(v); }},
    Key{"screen_mm", 10, 2000, [](VectorMachine& m, double v) { m.screen_mm = v; }},
    Key{"clock_mhz", 0.01, 1000, [](VectorMachine& m, double v) { m.clock_hz = v * 1e6; }},
    Key{"sync_hz", 0, 1000, [](VectorMachine& m, double v) { m.sync_hz = v; }},
    Key{"restart_hz", 0, 1000, [](VectorMachine& m, double v) { m.restart_hz = v; }},
    Key{"blink_hz", 0.01, 100, [](VectorMachine& m, double v) { m.blink_hz = v; }},
    Key{"watchdog_ms", 0.1, 1e4, [](VectorMachine& m, double v) { m.watchdog_ms = v; }},
    Key{"speed_units_us", 1e-3, 1e6, [](VectorMachine& m, double v) { m.speed_units_us = v; }},
    Key{"spot_sigma_mm", 0.001, 50, [](VectorMachine& m, double v) { m.spot_sigma_mm = v; }},
    Key{"deflection_khz", 0, 1e6, [](VectorMachine& m, double v) { m.deflection_khz = v; }},
    Key{"damping", 0.05, 10, [](VectorMachine& m, double v) { m.damping = v; }},
    Key{"slew_mm_us", 0, 1e6, [](VectorMachine& m, double v) { m.slew_mm_us = v; }},
    Key{"intensity_mhz", 0, 1e4, [](VectorMachine& m, double v) { m.intensity_mhz = v; }},
    Key{"spot_growth", 0, 2, [](VectorMachine& m, double v) { m.spot_growth = v; }},
    Key{"penetration", 0, 1, [](VectorMachine& m, double v) { m.penetration = v != 0; }},
    Key{"edge_spread", 0, 10, [](VectorMachine& m, double v) { m.edge_spread = v; }},
};

/// The lines of one file; see generic.txt for what they mean.
class MachineReader {
 public:
  MachineReader(const std::string& name, const std::string& file) : file_(file) {
    machine_.name = name;
  }

  VectorMachine read(std::string_view text) {
    for_each_data_line(text, [&](const Words& words, const std::string& where) {
      where_ = where;
      if (words.size() < 2) fail(words[0] + " lacks its value");
      read_line(words);
    });
    where_ = {};
    find_phosphor_or_tell();
    if (!has_instruction_set(machine_.words)) {
      fail("words " + machine_.words + " are not known; there are " + instruction_set_names());
    }
    for (const std::string& name : instruction_set(machine_.words).cost_names()) {
      const auto named = [&](const InstructionCost& c) { return c.name == name; };
      if (!machine_.knows(name)) continue;
      if (std::none_of(machine_.costs.begin(), machine_.costs.end(), named)) {
        fail("the cost of " + name + " is missing");
      }
    }
    return std::move(machine_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw_bad_input(what, file_, where_); }

  double number(const Words& words, std::size_t i, double least, double most) const {
    return bounded_number(words, i, least, most, file_, where_);
  }

  void find_phosphor_or_tell() const {
    try {
      find_phosphor(machine_.phosphor);
    } catch (const Error& error) {
      fail(error.what());
    }
  }

  void read_line(const Words& words) {
    const std::string& key = words[0];
    if (set_number(kNumbers, machine_, words, file_, where_)) return;
    if (key == "size") {
      machine_.width = whole(number(words, 1, 2, 1 << 16));
      machine_.height = whole(number(words, 2, 2, 1 << 16));
    } else if (key == "cost") {
      const double per_unit = words.size() > 3 ? number(words, 3, 0, 1e6) : 0;
      machine_.costs.push_back({words[1], number(words, 2, 0, 1e6), per_unit});
    } else if (key == "note") {
      machine_.note = words_after_key(words);
    } else if (key == "source") {
      machine_.source += (machine_.source.empty() ? "" : " ") + words_after_key(words);
    } else if (key == "lacks") {
      machine_.lacks.insert(machine_.lacks.end(), words.begin() + 1, words.end());
    } else if (key == "words") {
      machine_.words = words[1];
    } else if (key == "phosphor") {
      machine_.phosphor = words[1];
    } else {
      fail("\"" + key + "\" is not known");
    }
  }

  VectorMachine machine_;
  std::string file_, where_;
};

}  // namespace

std::int64_t VectorMachine::clocks(std::string_view instruction, double units) const {
  for (const InstructionCost& cost : costs) {
    if (cost.name != instruction) continue;
    const double us = cost.fixed_us + cost.per_unit_us * units;
    return std::max<std::int64_t>(1, std::llround(us * 1e-6 * clock_hz));
  }
  return 1;
}

bool VectorMachine::knows(std::string_view instruction) const {
  return std::find(lacks.begin(), lacks.end(), instruction) == lacks.end();
}

VectorMachine parse_vector_machine(std::string_view text, const std::string& name,
                                   const std::string& file) {
  return MachineReader(name, file).read(text);
}

std::span<const VectorMachine> vector_machines() {
  static const std::vector<VectorMachine> all = [] {
    std::vector<VectorMachine> machines;
    for (const auto& [name, text] : embedded_vector_machines()) {
      const std::string of(name);
      machines.push_back(parse_vector_machine(text, of, "display/data/machines/" + of + ".txt"));
    }
    return machines;
  }();
  return all;
}

const VectorMachine& find_vector_machine(std::string_view name) {
  std::string names;
  for (const VectorMachine& machine : vector_machines()) {
    if (machine.name == name) return machine;
    names += (names.empty() ? "" : ", ") + machine.name;
  }
  throw Error(ErrorKind::kUsage, fmt::format("no machine \"{}\"; there are {}", name, names));
}

}  // namespace kinescope
