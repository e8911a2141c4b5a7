#include "demos/machine.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>

namespace kinescope {
namespace {

/// A line "NAME: NUMBER kB" of one of the kernel's files, in bytes.
double kilobytes_in(const char* path, std::string_view name, double otherwise) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(name)) return 1024 * std::stod(line.substr(name.size()));
  }
  return otherwise;
}

double meminfo_available_bytes() {
  return kilobytes_in("/proc/meminfo", "MemAvailable:", std::numeric_limits<double>::infinity());
}

double number_in(const char* path, double otherwise) {
  std::ifstream file(path);
  double value = otherwise;
  return file >> value ? value : otherwise;  // "max" is no number
}

}  // namespace

double peak_memory_mib() {
  // Of this program alone: getrusage counts what its parent took before it became this one.
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double otherwise = 1024.0 * static_cast<double>(usage.ru_maxrss);
  return kilobytes_in("/proc/self/status", "VmHWM:", otherwise) / (1 << 20);
}

double available_memory_bytes() {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const double limit = number_in("/sys/fs/cgroup/memory.max", kNone);
  rlimit space{};
  getrlimit(RLIMIT_AS, &space);
  const double own = space.rlim_cur == RLIM_INFINITY ? kNone : static_cast<double>(space.rlim_cur);
  return std::min({meminfo_available_bytes(), limit, own});
}

void Stopwatch::stop() {
  ms_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start_).count());
}

double Stopwatch::total_ms() const { return std::accumulate(ms_.begin(), ms_.end(), 0.0); }

double Stopwatch::median_ms() const {
  if (ms_.empty()) return 0;
  std::vector<double> sorted = ms_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

void Stopwatch::write(JsonWriter& json) const {
  json.begin_object();
  if (!ms_.empty()) {
    json.member("min", *std::min_element(ms_.begin(), ms_.end()));
    json.member("median", median_ms());
    json.member("max", *std::max_element(ms_.begin(), ms_.end()));
  }
  json.end_object();
}

}  // namespace kinescope
