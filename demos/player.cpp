#include "demos/player.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace kinescope {
namespace {

// Steps between snapshots while playing: a copy of a tube costs about as much as half a step.
constexpr std::int64_t kInterval = 24;

}  // namespace

Player::Player(const DemoInfo& info, const DemoSetup& setup, std::size_t snapshot_bytes)
    : info_(info),
      setup_(setup),
      snapshot_bytes_(snapshot_bytes),
      demo_(info.create(setup)),
      picture_(setup.width, setup.height) {}

void Player::forward(Seconds length, std::vector<InputEvent> events) {
  assert(length > Seconds(0));
  // Steps that left the picture as it was are played again for nothing.
  if (trace_.steps() > 0 && trace_.steps() % kInterval == 0 && !demo_->still()) {
    remember(trace_.steps());
  }
  trace_.add(length, std::move(events));
  play(trace_.steps() - 1);
}

bool Player::back() {
  if (trace_.steps() <= 1) return false;
  trace_.cut(trace_.steps() - 1);
  const std::int64_t last = trace_.steps() - 1;
  restore(last);
  play(last);
  return true;
}

void Player::play(std::int64_t index) { demo_->step(trace_.step(index), picture_); }

void Player::restore(std::int64_t steps) {
  while (!snapshots_.empty() && snapshots_.back().steps > steps) snapshots_.pop_back();
  std::int64_t from = 0;
  if (snapshots_.empty()) {
    demo_ = info_.create(setup_);
  } else {
    from = snapshots_.back().steps;
    demo_ = snapshots_.back().demo->clone();
  }
  // Snapshots on the way make the next steps back cheap.
  const std::int64_t gap = std::max<std::int64_t>(1, (steps - from) / 3);
  for (std::int64_t i = from; i < steps; ++i) {
    if (i > from && (steps - i) % gap == 0) remember(i);
    play(i);
    ++replayed_;
  }
}

/// Keeps the present state, and thins the others out the more, the older they are.
void Player::remember(std::int64_t steps) {
  if (!snapshots_.empty() && snapshots_.back().steps >= steps) return;
  const std::size_t room = std::max<std::size_t>(1, snapshot_bytes_ / (demo_->state_bytes() + 1));
  while (snapshots_.size() >= room) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t victim = 0;
    for (std::size_t i = 0; i < snapshots_.size(); ++i) {
      const std::int64_t before = i == 0 ? 0 : snapshots_[i - 1].steps;
      const std::int64_t after = i + 1 == snapshots_.size() ? steps : snapshots_[i + 1].steps;
      const double loss =
          static_cast<double>(after - before) / static_cast<double>(steps - snapshots_[i].steps);
      if (loss < least) least = loss, victim = i;
    }
    snapshots_.erase(snapshots_.begin() + static_cast<std::ptrdiff_t>(victim));
  }
  snapshots_.push_back({steps, demo_->clone()});
}

}  // namespace kinescope
