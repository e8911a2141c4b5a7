#include "display/vector/input/pseudo_terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "raster/base/error.h"

namespace kinescope {
namespace {

[[noreturn]] void fail() {
  throw Error(ErrorKind::kUsage, std::string("there is no pseudo-terminal: ") + strerror(errno),
              "--pty");
}

/// Raw, which lasts although nobody has it open yet.
bool set_up(const char* name) {
  const int slave = open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (slave < 0) return false;
  termios state{};
  const bool done =
      tcgetattr(slave, &state) == 0 && (cfmakeraw(&state), tcsetattr(slave, TCSANOW, &state) == 0);
  close(slave);
  return done;
}

}  // namespace

PseudoTerminal::PseudoTerminal() {
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
  if (master_ < 0) fail();
  char name[128];
  if (grantpt(master_) != 0 || unlockpt(master_) != 0 ||
      ptsname_r(master_, name, sizeof name) != 0 || !set_up(name)) {
    close(master_);
    fail();
  }
  name_ = name;
}

PseudoTerminal::~PseudoTerminal() { close(master_); }

std::size_t PseudoTerminal::read(std::vector<std::uint8_t>& to, int milliseconds) {
  pollfd waiting{master_, POLLIN, 0};
  poll(&waiting, 1, milliseconds);
  std::size_t total = 0;
  std::uint8_t block[1 << 14];
  constexpr std::size_t kMost = 1 << 22;  // so that a writer without end does not stop the window
  while (total < kMost) {
    const ssize_t got = ::read(master_, block, sizeof block);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    to.insert(to.end(), block, block + got);
    total += static_cast<std::size_t>(got);
  }
  // The hang-up is over when somebody opens it again.
  left_ = total == 0 && (waiting.revents & POLLHUP) != 0;
  used_ = used_ || total > 0;
  // A terminal that nobody has open hangs up at once: do not spin.
  if (left_ && milliseconds > 0) poll(nullptr, 0, milliseconds);
  return total;
}

void PseudoTerminal::write(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t done = ::write(master_, text.data() + at, text.size() - at);
    if (done <= 0) return;
    at += static_cast<std::size_t>(done);
  }
}

}  // namespace kinescope
