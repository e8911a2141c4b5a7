#include "raster/base/output_file.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <utility>

#include "raster/base/error.h"

namespace kinescope {
namespace {

// The names of unfinished files, where a signal handler can find them: hence fixed, lock-free, and
// the one piece of process-wide state here.
struct Slot {
  enum State { kFree, kClaimed, kArmed };
  std::atomic<int> state{kFree};
  std::array<char, PATH_MAX> path{};
};
static_assert(std::atomic<int>::is_always_lock_free);
constexpr int kSlots = 16;
std::array<Slot, kSlots> unfinished;

int claim_slot(const std::string& path) {
  if (path.size() >= PATH_MAX) return -1;
  for (int i = 0; i < kSlots; ++i) {
    Slot& slot = unfinished[static_cast<std::size_t>(i)];
    int expected = Slot::kFree;
    if (!slot.state.compare_exchange_strong(expected, Slot::kClaimed)) continue;
    std::memcpy(slot.path.data(), path.c_str(), path.size() + 1);
    slot.state = Slot::kArmed;
    return i;
  }
  return -1;
}

void free_slot(int& slot) {
  if (slot >= 0) unfinished[static_cast<std::size_t>(slot)].state = Slot::kFree;
  slot = -1;
}

// Turns SIGPIPE into the error EPIPE for the writes of this thread, whatever the program does with
// the signal elsewhere.
class NoBrokenPipeSignal {
 public:
  NoBrokenPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~NoBrokenPipeSignal() {
    const int kept = errno;
    const timespec at_once{};
    if (!was_pending_) sigtimedwait(&pipe_, nullptr, &at_once);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = kept;
  }
  NoBrokenPipeSignal(const NoBrokenPipeSignal&) = delete;
  NoBrokenPipeSignal& operator=(const NoBrokenPipeSignal&) = delete;

 private:
  sigset_t pipe_;
  sigset_t before_;
  bool was_pending_;
};

std::string shown(const std::string& path) { return path == "-" ? "standard output" : path; }

// A link stays a link: what it points to is replaced.
std::string resolved(const std::string& path) {
  std::array<char, PATH_MAX> buffer;
  return realpath(path.c_str(), buffer.data()) ? std::string(buffer.data()) : path;
}

[[noreturn]] void abandon(int descriptor, const std::string& temporary, const std::string& name) {
  close(descriptor);
  unlink(temporary.c_str());
  throw Error(ErrorKind::kCannotWrite, "too many files are being written at once", name);
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path) {
  int descriptor = -1;
  struct stat info {};
  const bool exists = path != "-" && stat(path.c_str(), &info) == 0;
  const bool no_name = path.empty() || path.back() == '/';
  // Asked now: what only the rename would find, hours of work might have been lost to.
  if (path != "-" && !exists && (errno != ENOENT || no_name)) fail("be written");
  if (path == "-") {
    descriptor = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
  } else if (exists && !S_ISREG(info.st_mode)) {
    descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  } else if (exists && access(path.c_str(), W_OK) != 0) {
    fail("be written");
  } else {
    target_ = resolved(path);
    const std::string stem = folder_of(target_) + ".kinescope-" + std::to_string(getpid()) + "-";
    for (int n = 0; descriptor < 0; ++n) {
      temporary_ = stem + std::to_string(n) + ".part";
      descriptor = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor < 0 && errno != EEXIST) break;
    }
    if (descriptor < 0) {
      temporary_.clear();
    } else {
      slot_ = claim_slot(temporary_);
      if (slot_ < 0) abandon(descriptor, temporary_, shown(path_));
      if (exists) (void)fchmod(descriptor, info.st_mode & 07777);
    }
  }
  if (descriptor >= 0) stream_ = fdopen(descriptor, "wb");
  if (!stream_) fail("be written");
}

OutputFile::~OutputFile() {
  if (stream_) {
    const NoBrokenPipeSignal quiet;
    std::fclose(stream_);
  }
  if (!temporary_.empty()) unlink(temporary_.c_str());
  free_slot(slot_);
}

void OutputFile::fail(const char* doing) {
  const std::string reason = std::strerror(errno);
  throw Error(ErrorKind::kCannotWrite, std::string("cannot ") + doing + ": " + reason,
              shown(path_));
}

void OutputFile::write(std::span<const std::uint8_t> bytes) {
  const NoBrokenPipeSignal quiet;
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) fail("be written");
}

void OutputFile::write(const std::string& text) {
  write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void OutputFile::commit() {
  {
    const NoBrokenPipeSignal quiet;
    std::FILE* const closing = std::exchange(stream_, nullptr);
    const bool flushed = std::fflush(closing) == 0;
    const int reason = errno;
    const bool closed = std::fclose(closing) == 0;
    if (!flushed) errno = reason;
    if (!flushed || !closed) fail("be written");
  }
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail("be renamed into place");
  temporary_.clear();
  free_slot(slot_);
}

void OutputFile::remove_unfinished() noexcept {
  for (Slot& slot : unfinished) {
    if (slot.state == Slot::kArmed) unlink(slot.path.data());
  }
}

}  // namespace kinescope
