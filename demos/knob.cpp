#include "demos/knob.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kinescope {
namespace {

int steps_between(const Knob& knob, double from, double to) {
  return static_cast<int>(std::lround((to - from) / knob.step));
}

}  // namespace

Knob::Knob() = default;
Knob::Knob(const Knob&) = default;
Knob::Knob(Knob&&) noexcept = default;
Knob& Knob::operator=(const Knob&) = default;
Knob& Knob::operator=(Knob&&) noexcept = default;
Knob::~Knob() = default;

std::string Knob::text() const {
  switch (kind) {
    case KnobKind::kToggle:
      return on() ? "on" : "off";
    case KnobKind::kChoice:
      return choices[static_cast<std::size_t>(index())];
    case KnobKind::kNumber:
      if (!choices.empty()) return choices[static_cast<std::size_t>(index())];
      break;
  }
  return fmt::format("{:.6g}{}{}", value, unit.empty() ? "" : " ", unit);
}

bool Knob::answer(const std::string& key, bool repeated) {
  const auto found = std::find(keys.begin(), keys.end(), key);
  if (found == keys.end()) return false;
  if (repeated && kind != KnobKind::kNumber) return true;
  const auto which = static_cast<double>(found - keys.begin());
  switch (kind) {
    case KnobKind::kToggle:
      value = on() ? 0 : 1;
      break;
    case KnobKind::kChoice:
      value = keys.size() == 1 ? (index() + 1) % static_cast<int>(choices.size()) : which;
      break;
    case KnobKind::kNumber: {
      // Counted in whole steps from the minimum, so that up and down lead back to the same number.
      const int place = steps_between(*this, minimum, value) + (which == 0 ? -1 : 1);
      value = minimum + step * std::clamp(place, 0, steps_between(*this, minimum, maximum));
      break;
    }
  }
  return true;
}

std::vector<std::string> Knob::keys_to(double target) const {
  switch (kind) {
    case KnobKind::kToggle:
      return std::vector<std::string>((target != 0) == on() ? 0 : 1, keys[0]);
    case KnobKind::kChoice: {
      const int count = static_cast<int>(choices.size());
      const int goal = std::clamp(static_cast<int>(target), 0, count - 1);
      if (keys.size() > 1) return {keys[static_cast<std::size_t>(goal)]};
      return std::vector<std::string>(static_cast<std::size_t>((goal - index() + count) % count),
                                      keys[0]);
    }
    case KnobKind::kNumber:
      break;
  }
  const int steps = steps_between(*this, value, std::clamp(target, minimum, maximum));
  return std::vector<std::string>(static_cast<std::size_t>(std::abs(steps)),
                                  keys[steps < 0 ? 0 : 1]);
}

Knob toggle_knob(std::string name, std::string key, bool on, std::string help) {
  Knob knob;
  knob.name = std::move(name);
  knob.help = std::move(help);
  knob.value = on ? 1 : 0;
  knob.keys = {std::move(key)};
  return knob;
}

Knob choice_knob(std::string name, std::vector<std::string> keys, std::vector<std::string> choices,
                 int index, std::string help) {
  assert(keys.size() == 1 || keys.size() == choices.size());
  Knob knob;
  knob.kind = KnobKind::kChoice;
  knob.name = std::move(name);
  knob.help = std::move(help);
  knob.value = index;
  knob.keys = std::move(keys);
  knob.choices = std::move(choices);
  return knob;
}

Knob number_knob(std::string name, std::string down, std::string up, double minimum, double maximum,
                 double step, double value, std::string unit, std::string help) {
  assert(step > 0 && minimum <= value && value <= maximum);
  Knob knob;
  knob.kind = KnobKind::kNumber;
  knob.name = std::move(name);
  knob.help = std::move(help);
  knob.value = value;
  knob.keys = {std::move(down), std::move(up)};
  knob.minimum = minimum;
  knob.maximum = maximum;
  knob.step = step;
  knob.unit = std::move(unit);
  return knob;
}

Knob scale_knob(std::string name, std::string down, std::string up,
                std::vector<std::string> choices, int index, std::string help) {
  const auto last = static_cast<double>(choices.size() - 1);
  Knob knob = number_knob(std::move(name), std::move(down), std::move(up), 0, last, 1, index, "",
                          std::move(help));
  knob.choices = std::move(choices);
  return knob;
}

}  // namespace kinescope

template class std::vector<kinescope::Knob>;
