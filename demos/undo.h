// Earlier states of something, to be taken back one by one.
#pragma once

#include <cstddef>
#include <deque>
#include <utility>

namespace kinescope {

template <typename State>
class Undo {
 public:
  /// @param most states kept; older ones are forgotten
  explicit Undo(std::size_t most) : most_(most) {}

  void keep(const State& state) {
    before_.push_back(state);
    if (before_.size() > most_) before_.pop_front();
  }
  /// @return false, and leaves `state` alone, if there is nothing to take back
  bool take_back(State& state) {
    if (before_.empty()) return false;
    state = std::move(before_.back());
    before_.pop_back();
    return true;
  }
  void clear() { before_.clear(); }
  std::size_t most() const { return most_; }
  std::size_t size() const { return before_.size(); }

 private:
  std::size_t most_;
  std::deque<State> before_;
};

}  // namespace kinescope
