#include "raster/base/input_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "raster/base/error.h"

namespace kinescope {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;
constexpr int kPatience_ms = 50;  // until it is asked again whether anybody still waits

}  // namespace

InputFile::InputFile(const std::string& path)
    : name_(path == "-" ? "standard input" : path), owned_(path != "-") {
  descriptor_ = owned_ ? open(path.c_str(), O_RDONLY | O_CLOEXEC) : STDIN_FILENO;
  if (descriptor_ < 0) fail();
}

InputFile::InputFile(std::span<const std::uint8_t> bytes, std::string name)
    : name_(std::move(name)), ahead_(bytes) {}

InputFile::~InputFile() {
  if (owned_ && descriptor_ >= 0) close(descriptor_);
}

void InputFile::fail() const {
  throw_bad_input(std::string("cannot be read: ") + std::strerror(errno), name_);
}

/// @return false if interrupted
bool InputFile::wait_for_bytes() const {
  pollfd asked{descriptor_, POLLIN, 0};
  while (!interrupted_) {
    // What poll cannot tell, read will.
    if (poll(&asked, 1, kPatience_ms) != 0) return true;
  }
  return false;
}

std::size_t InputFile::read_some(std::uint8_t* to, std::size_t count) {
  if (!wait_for_bytes()) return 0;
  ssize_t got;
  do {
    got = ::read(descriptor_, to, count);
  } while (got < 0 && errno == EINTR);
  if (got < 0) fail();
  return static_cast<std::size_t>(got);
}

bool InputFile::fill() {
  if (descriptor_ < 0) return false;
  const std::size_t kept = ahead_.size();
  if (kept != 0) std::memmove(storage_.data(), ahead_.data(), kept);
  if (storage_.size() < kept + kPiece) storage_.resize(kept + kPiece);
  const std::size_t got = read_some(storage_.data() + kept, storage_.size() - kept);
  ahead_ = {storage_.data(), kept + got};
  return got != 0;
}

void InputFile::take(std::size_t count) {
  ahead_ = ahead_.subspan(count);
  position_ += count;
}

std::span<const std::uint8_t> InputFile::peek(std::size_t count) {
  while (ahead_.size() < count && fill()) {
  }
  return ahead_;
}

bool InputFile::read_line(std::string& line, std::size_t most) {
  std::size_t searched = 0;
  for (;;) {
    const auto begin = ahead_.begin(), end = begin + std::min(ahead_.size(), most);
    const auto newline = std::find(begin + std::min(searched, most), end, '\n');
    if (newline != end) {
      line.assign(begin, newline);
      take(line.size() + 1);
      return true;
    }
    searched = ahead_.size();
    if (searched >= most || !fill()) return false;
  }
}

std::size_t InputFile::append_to(std::vector<std::uint8_t>& bytes, std::size_t count) {
  const std::size_t before = bytes.size(), wanted = before + count;
  const std::size_t first = std::min(count, ahead_.size());
  bytes.insert(bytes.end(), ahead_.begin(), ahead_.begin() + static_cast<std::ptrdiff_t>(first));
  take(first);
  std::size_t have = bytes.size();
  while (have < wanted && descriptor_ >= 0) {
    // At most twice what has come so far: a header that lies takes no memory.
    if (have == bytes.size()) bytes.resize(std::min(wanted, std::max(2 * have, have + kPiece)));
    const std::size_t got = read_some(bytes.data() + have, bytes.size() - have);
    if (got == 0) break;
    have += got;
    position_ += got;
  }
  bytes.resize(have);
  return have - before;
}

std::vector<std::uint8_t> InputFile::rest(std::size_t max_bytes) {
  const auto check = [&](std::size_t size) {
    if (size <= max_bytes) return;
    throw_bad_input("larger than the " + std::to_string(max_bytes) + " bytes that can be read",
                    name_);
  };
  struct stat info {};
  std::vector<std::uint8_t> bytes;
  if (descriptor_ >= 0 && fstat(descriptor_, &info) == 0 && S_ISREG(info.st_mode)) {
    check(static_cast<std::size_t>(info.st_size));
    bytes.reserve(static_cast<std::size_t>(info.st_size) + 1);
  }
  append_to(bytes, max_bytes);
  if (!peek(1).empty()) check(max_bytes + 1);  // grown since, or a pipe
  return bytes;
}

std::vector<std::uint8_t> read_file(const std::string& path, std::size_t max_bytes) {
  return InputFile(path).rest(max_bytes);
}

}  // namespace kinescope
