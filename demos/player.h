// Plays a demo forward, and back: back is the trace's prefix played again from the nearest
// snapshot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "demos/demo.h"
#include "demos/trace.h"

namespace kinescope {

class Player {
 public:
  static constexpr std::size_t kSnapshotBytes = std::size_t{32} << 20;

  /// @param snapshot_bytes memory for snapshots; one is kept even if it is larger
  Player(const DemoInfo& info, const DemoSetup& setup, std::size_t snapshot_bytes = kSnapshotBytes);

  /// One step of simulated time, longer than 0.
  void forward(Seconds length, std::vector<InputEvent> events = {});
  /// One step back; the step is forgotten. @return false if only the first is left
  bool back();

  std::int64_t steps() const { return trace_.steps(); }
  Seconds now() const { return trace_.end(); }
  const Demo& demo() const { return *demo_; }
  /// As the last step left it; black before the first.
  const Image<Srgb8>& picture() const { return picture_; }
  /// How many snapshots are held, and how many steps all going back has played again (figures).
  std::size_t snapshots() const { return snapshots_.size(); }
  std::int64_t replayed() const { return replayed_; }

 private:
  struct Snapshot {
    std::int64_t steps;
    std::unique_ptr<Demo> demo;
  };
  void play(std::int64_t index);
  void remember(std::int64_t steps);
  void restore(std::int64_t steps);

  const DemoInfo& info_;
  DemoSetup setup_;
  std::size_t snapshot_bytes_;
  std::unique_ptr<Demo> demo_;
  Trace trace_;
  std::vector<Snapshot> snapshots_;  // sorted by steps
  Image<Srgb8> picture_;
  std::int64_t replayed_ = 0;
};

}  // namespace kinescope
