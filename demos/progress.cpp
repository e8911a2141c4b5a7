#include "demos/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace kinescope {

Progress::Progress(std::string what, int total, bool shown)
    : what_(std::move(what)), total_(total), shown_(shown && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) fmt::print(stderr, "\r{:{}}\r", "", 79);
}

void Progress::done(int count) {
  const Clock::time_point now = Clock::now();
  using std::chrono::milliseconds;
  if (!shown_ || now - start_ < milliseconds(500) || now - last_ < milliseconds(100)) return;
  last_ = now;
  drawn_ = true;
  if (total_ == 0) {
    fmt::print(stderr, "\r{} {}  ", what_, count);
    std::fflush(stderr);
    return;
  }
  constexpr int kWidth = 30;
  const int filled = static_cast<int>(static_cast<long long>(kWidth) * count / total_);
  const double left_s =
      std::chrono::duration<double>(now - start_).count() * (total_ - count) / count;
  fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {}/{} {:.0f} s left  ", what_, "", filled, "",
             kWidth - filled, count, total_, left_s);
  std::fflush(stderr);
}

}  // namespace kinescope
