#include "raster/base/workers.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#ifndef KINESCOPE_STD_THREADS
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace kinescope {

#ifdef KINESCOPE_STD_THREADS

struct Workers::Backend {
  explicit Backend(int) {}

  /// Runs loop(worker) on `count` threads at once.
  template <typename Loop>
  void spawn(int count, const Loop& loop) {
    std::exception_ptr failure;
    std::mutex mutex;
    const auto guarded = [&](int worker) {
      try {
        loop(worker);
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
      }
    };
    std::vector<std::thread> threads;
    for (int worker = 1; worker < count; ++worker) threads.emplace_back(guarded, worker);
    guarded(0);
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
  }
};

#else

struct Workers::Backend {
  // The control outlives the arena, so N workers exist even on fewer cores. Only then: of all
  // controls alive the smallest holds for the whole process.
  explicit Backend(int count) : arena(count) {
    if (count > tbb::info::default_concurrency()) {
      control.emplace(tbb::global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(count));
    }
  }

  template <typename Loop>
  void spawn(int count, const Loop& loop) {
    arena.execute([&] {
      tbb::parallel_for(
          0, count, 1, [&](int worker) { loop(worker); }, tbb::simple_partitioner{});
    });
  }

  std::optional<tbb::global_control> control;
  tbb::task_arena arena;
};

#endif

Workers::Workers(int threads)
    : count_(threads > 0 ? threads
                         : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
      backend_(std::make_unique<Backend>(count_)) {}

Workers::~Workers() = default;

void Workers::run(int tasks, const std::function<void(int, int)>& body) {
  const int loops = std::min(count_, tasks);
  if (loops <= 1) {
    for (int task = 0; task < tasks; ++task) body(task, 0);
    return;
  }
  std::atomic<int> next{0};
  backend_->spawn(loops, [&](int worker) {
    for (int task = next++; task < tasks; task = next++) body(task, worker);
  });
}

}  // namespace kinescope
