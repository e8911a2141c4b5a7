#include "display/vector/display_processor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "raster/base/error.h"

namespace kinescope {

std::optional<Word> ProcessorCore::read(Address address) {
  const std::optional<Word> word = memory_.read(address);
  if (!word)
    fault(fmt::format("address {} lies outside the memory of {} words", address, memory_.size()));
  return word;
}

void ProcessorCore::fault(const std::string& what) {
  state_.status = ProcessorStatus::kFaulted;
  fault_ = ProcessorFault{what, at_};
}

void ProcessorCore::move_beam(double x, double y, std::int64_t clocks, float intensity) {
  ProcessorState& s = state_;
  BeamMove move{s.x,       s.y,      x,  y, seconds(s.clock), seconds(s.clock + clocks),
                intensity, s.colour, at_};
  if (s.blinks && std::fmod(move.begin.count() * machine_.blink_hz, 1.0) >= 0.5) move.intensity = 0;
  s.x = x, s.y = y;
  s.clock += clocks;
  s.last_sign = s.clock;
  moves_->push_back(move);
  if (!pen_ || !s.pen_on) return;
  if (const auto sight = see(*pen_, move)) {
    hit_ = BeamPenHit{at_, s.calls, sight->x, sight->y, sight->time};
    s.status = ProcessorStatus::kPenHit;
  }
}

void ProcessorCore::call(Address target, Address back) {
  if (state_.calls.size() >= static_cast<std::size_t>(machine_.stack)) {
    return fault(fmt::format("calls more than {} deep", machine_.stack));
  }
  state_.calls.push_back(at_);
  state_.returns.push_back(back);
  state_.next = target;
}

void ProcessorCore::come_back() {
  if (state_.calls.empty()) return fault("return without a call");
  state_.next = state_.returns.back();
  state_.calls.pop_back();
  state_.returns.pop_back();
}

void ProcessorCore::wait_for(double hertz) {
  if (!(hertz > 0)) return;
  const double period = machine_.clock_hz / hertz;
  const double ticks = std::floor(static_cast<double>(state_.clock) / period) + 1;
  state_.clock = std::max<std::int64_t>(state_.clock + 1, std::llround(ticks * period));
  state_.last_sign = state_.clock;
}

DisplayProcessor::DisplayProcessor(const VectorMachine& machine, DisplayMemory& memory)
    : ProcessorCore(machine, memory), set_(instruction_set(machine.words)) {}

void DisplayProcessor::start(Address address) {
  state_.start = state_.next = address;
  state_.calls.clear();
  state_.returns.clear();
  state_.character = 0;
  state_.status = ProcessorStatus::kRunning;
  state_.last_sign = state_.clock;
  fault_.reset();
  hit_.reset();
}

void DisplayProcessor::resume() {
  if (status() != ProcessorStatus::kPenHit) return;
  hit_.reset();
  state_.status = ProcessorStatus::kRunning;
}

/// Lets time pass. @return whether it has come to `end`
bool DisplayProcessor::idle(std::int64_t end) {
  if (status() == ProcessorStatus::kHalted && machine_.restart_hz > 0) {
    wait_for(machine_.restart_hz);
    start(state_.start);
    return state_.clock >= end;
  }
  state_.clock = std::max(state_.clock, end);
  return true;
}

void DisplayProcessor::mark_refresh() {
  began_before_ = began_;
  began_ = state_.clock;
  ++refreshes_;
}

std::optional<Seconds> DisplayProcessor::refresh_period() const {
  if (refreshes_ < 2) return std::nullopt;
  return seconds(began_ - began_before_);
}

void DisplayProcessor::run(Seconds end, std::vector<BeamMove>& moves) {
  const auto stop = static_cast<std::int64_t>(std::ceil(end.count() * machine_.clock_hz));
  const auto most_silent =
      static_cast<std::int64_t>(machine_.watchdog_ms * 1e-3 * machine_.clock_hz);
  moves_ = &moves;
  while (state_.clock < stop) {
    if (status() != ProcessorStatus::kRunning) {
      if (idle(stop)) break;
      continue;
    }
    at_ = state_.next;
    if (at_ == state_.start && state_.calls.empty() && state_.character == 0) mark_refresh();
    set_.step(*this);
    if (status() == ProcessorStatus::kRunning && state_.clock - state_.last_sign > most_silent) {
      ProcessorCore::fault(
          fmt::format("endless loop: nothing drawn for {:g} ms", machine_.watchdog_ms));
    }
  }
  moves_ = nullptr;
}

void DisplayProcessor::throw_fault(const std::string& file) const {
  if (fault_) throw_bad_input(fault_->what, file, fmt::format("address {}", fault_->address));
}

}  // namespace kinescope
