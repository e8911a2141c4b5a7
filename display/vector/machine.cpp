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

struct NumberKey {
  std::string_view key;
  double least, most;
  void (*set)(VectorMachine&, double);
};

int whole(double v) { return static_cast<int>(v); }

constexpr std::array kNumbers{
    NumberKey{"memory", 16, 1 << 24, [](VectorMachine& m, double v) { m.memory_words = whole(v); }},
    NumberKey{"stack", 1, 1024, [](VectorMachine& m, double v) { m.stack = whole(v); }},
    NumberKey{"screen_mm", 10, 2000, [](VectorMachine& m, double v) { m.screen_mm = v; }},
    NumberKey{"clock_mhz", 0.01, 1000, [](VectorMachine& m, double v) { m.clock_hz = v * 1e6; }},
    NumberKey{"sync_hz", 0, 1000, [](VectorMachine& m, double v) { m.sync_hz = v; }},
    NumberKey{"restart_hz", 0, 1000, [](VectorMachine& m, double v) { m.restart_hz = v; }},
    NumberKey{"blink_hz", 0.01, 100, [](VectorMachine& m, double v) { m.blink_hz = v; }},
    NumberKey{"watchdog_ms", 0.1, 1e4, [](VectorMachine& m, double v) { m.watchdog_ms = v; }},
    NumberKey{"speed_units_us", 1e-3, 1e6,
              [](VectorMachine& m, double v) { m.speed_units_us = v; }},
    NumberKey{"spot_sigma_mm", 0.001, 50, [](VectorMachine& m, double v) { m.spot_sigma_mm = v; }},
    NumberKey{"deflection_khz", 0, 1e6, [](VectorMachine& m, double v) { m.deflection_khz = v; }},
    NumberKey{"damping", 0.05, 10, [](VectorMachine& m, double v) { m.damping = v; }},
    NumberKey{"slew_mm_us", 0, 1e6, [](VectorMachine& m, double v) { m.slew_mm_us = v; }},
    NumberKey{"intensity_mhz", 0, 1e4, [](VectorMachine& m, double v) { m.intensity_mhz = v; }},
    NumberKey{"spot_growth", 0, 2, [](VectorMachine& m, double v) { m.spot_growth = v; }},
    NumberKey{"penetration", 0, 1, [](VectorMachine& m, double v) { m.penetration = v != 0; }},
    NumberKey{"edge_spread", 0, 10, [](VectorMachine& m, double v) { m.edge_spread = v; }},
};

std::string join(const Words& words) {
  return fmt::format("{}", fmt::join(words.begin() + 1, words.end(), " "));
}

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
    if (i >= words.size()) fail(words[0] + " lacks a number");
    const double v = parse_number(words[i], file_, where_);
    if (!(v >= least && v <= most)) {
      fail(fmt::format("{} must lie from {:g} to {:g}", words[0], least, most));
    }
    return v;
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
    const auto found = std::find_if(kNumbers.begin(), kNumbers.end(),
                                    [&](const NumberKey& n) { return n.key == key; });
    if (found != kNumbers.end()) {
      found->set(machine_, number(words, 1, found->least, found->most));
    } else if (key == "size") {
      machine_.width = whole(number(words, 1, 2, 1 << 16));
      machine_.height = whole(number(words, 2, 2, 1 << 16));
    } else if (key == "cost") {
      const double per_unit = words.size() > 3 ? number(words, 3, 0, 1e6) : 0;
      machine_.costs.push_back({words[1], number(words, 2, 0, 1e6), per_unit});
    } else if (key == "note") {
      machine_.note = join(words);
    } else if (key == "source") {
      machine_.source += (machine_.source.empty() ? "" : " ") + join(words);
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
