// A display processor: a program of its own in memory, that drives the beam. It steps in time:
// every instruction has its cost, and its state goes on from one refresh to the next.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "display/vector/beam_move.h"
#include "display/vector/beam_pen.h"
#include "display/vector/display_memory.h"
#include "display/vector/instruction_set.h"
#include "display/vector/machine.h"

namespace kinescope {

enum class ProcessorStatus {
  kRunning,
  kHalted,   ///< until start(), or the machine's own restart
  kPenHit,   ///< until resume()
  kFaulted,  ///< until start()
};

/// Why a processor stopped by itself.
struct ProcessorFault {
  std::string what;  ///< "endless loop: nothing drawn for 100 ms"
  Address address = 0;
};

/// Registers. Set by instructions, kept from refresh to refresh.
struct ProcessorState {
  ProcessorStatus status = ProcessorStatus::kHalted;
  Address next = 0;              ///< the program counter
  Address start = 0;             ///< where the list begins that is shown
  std::vector<Address> calls;    ///< addresses of the calls that have not returned
  std::vector<Address> returns;  ///< where each returns to
  double x = 0, y = 0;           ///< device units
  float intensity = 1;
  std::array<float, 3> colour{1, 1, 1};
  bool blinks = false, pen_on = false;
  int scale = 16;                     ///< generic: sixteenths; DVG: the global scale
  std::optional<Address> characters;  ///< generic: where the table of characters lies, if told
  int character = 0;                  ///< generic: which of a word's characters comes next
  std::int64_t clock = 0;             ///< machine clocks since its beginning
  std::int64_t last_sign = 0;         ///< when it last drew or waited
};

/// What instruction sets work on.
class ProcessorCore {
 public:
  ProcessorCore(const VectorMachine& machine, DisplayMemory& memory)
      : machine_(machine), memory_(memory) {}

  const VectorMachine& machine() const { return machine_; }
  ProcessorState& state() { return state_; }
  const ProcessorState& state() const { return state_; }
  Seconds seconds(std::int64_t clocks) const {
    return Seconds(static_cast<double>(clocks) / machine_.clock_hz);
  }

  /// A word, or nothing and a fault.
  std::optional<Word> read(Address address);
  void spend(std::string_view instruction, double units = 0) {
    state_.clock += machine_.clocks(instruction, units);
  }
  void spend_clocks(std::int64_t clocks) { state_.clock += clocks; }
  /// Moves the beam for so many clocks, lit or dark, at a current.
  void move_beam(double x, double y, std::int64_t clocks, float intensity);
  void call(Address target, Address back);
  void come_back();
  /// Until the next tick of a clock.
  void wait_for(double hertz);
  void halt() { state_.status = ProcessorStatus::kHalted; }
  void fault(const std::string& what);

 protected:
  const VectorMachine& machine_;
  DisplayMemory& memory_;
  ProcessorState state_;
  Address at_ = 0;  // of the instruction being carried out
  std::vector<BeamMove>* moves_ = nullptr;
  std::optional<ProcessorFault> fault_;
  std::optional<BeamPen> pen_;
  std::optional<BeamPenHit> hit_;
};

class DisplayProcessor : private ProcessorCore {
 public:
  /// Both must outlive the processor.
  DisplayProcessor(const VectorMachine& machine, DisplayMemory& memory);

  /// Begins a list, from wherever the processor is.
  void start(Address address);
  /// Changes where the list begins once this one is through: for files in two buffers.
  void show(Address address) { state_.start = address; }
  /// Goes on after a pen's hit, with the instruction that follows.
  void resume();
  /// Carries out all instructions that begin before `end`, and adds what they ask of the beam. The
  /// last may end later. A stopped processor lets the time pass.
  void run(Seconds end, std::vector<BeamMove>& moves);

  using ProcessorCore::machine;
  using ProcessorCore::state;
  Seconds now() const { return seconds(state_.clock); }
  ProcessorStatus status() const { return state_.status; }
  const std::optional<ProcessorFault>& fault() const { return fault_; }
  /// @throws Error (bad input) if it has stopped by a fault, naming the address
  void throw_fault(const std::string& file) const;

  void hold_pen(const std::optional<BeamPen>& pen) { pen_ = pen; }
  /// The last hit since start() or resume().
  const std::optional<BeamPenHit>& hit() const { return hit_; }

  /// How often the list began, and the time from the last beginning but one to the last.
  std::int64_t refreshes() const { return refreshes_; }
  std::optional<Seconds> refresh_period() const;

 private:
  bool idle(std::int64_t end);
  void mark_refresh();

  const InstructionSet& set_;
  std::int64_t refreshes_ = 0, began_ = 0, began_before_ = 0;
};

}  // namespace kinescope
