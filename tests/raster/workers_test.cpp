#include "raster/base/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace kinescope {
namespace {

class WorkersOf : public ::testing::TestWithParam<int> {};

TEST_P(WorkersOf, RunEachTaskOnce) {
  Workers workers(GetParam());
  EXPECT_EQ(workers.count(), GetParam());
  for (const int tasks : {0, 1, 2, 7, 1000}) {
    std::vector<std::atomic<int>> runs(static_cast<std::size_t>(tasks));
    workers.run(tasks, [&](int task, int) { ++runs[static_cast<std::size_t>(task)]; });
    for (const auto& count : runs) EXPECT_EQ(count, 1);
  }
}

TEST_P(WorkersOf, NumberWorkersAndShowEachItsTasksInOrderOneAtATime) {
  Workers workers(GetParam());
  std::vector<int> last(static_cast<std::size_t>(GetParam()), -1);
  std::vector<std::atomic<bool>> busy(static_cast<std::size_t>(GetParam()));
  std::atomic<int> faults{0};
  workers.run(2000, [&](int task, int worker) {
    if (worker < 0 || worker >= GetParam()) {
      ++faults;
      return;
    }
    const auto w = static_cast<std::size_t>(worker);
    if (busy[w].exchange(true)) ++faults;
    if (task <= last[w]) ++faults;
    last[w] = task;
    busy[w] = false;
  });
  EXPECT_EQ(faults, 0);
}

// Every task waits until as many threads as asked for have met: so they exist, at one time.
TEST_P(WorkersOf, AreThatManyThreadsEvenOnFewerCores) {
  Workers workers(GetParam());
  std::atomic<int> waiting{0};
  std::atomic<int> missed{0};
  workers.run(GetParam(), [&](int, int) {
    ++waiting;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (waiting < GetParam()) {
      if (std::chrono::steady_clock::now() > deadline) {
        ++missed;
        return;
      }
      std::this_thread::yield();
    }
  });
  EXPECT_EQ(missed, 0);
  EXPECT_EQ(waiting, GetParam());
}

TEST_P(WorkersOf, HandAnExceptionToTheCallerAndGoOnLiving) {
  Workers workers(GetParam());
  EXPECT_THROW(workers.run(100,
                           [](int task, int) {
                             if (task == 37) throw std::runtime_error("task 37");
                           }),
               std::runtime_error);
  std::atomic<int> runs{0};
  workers.run(50, [&](int, int) { ++runs; });
  EXPECT_EQ(runs, 50);
}

INSTANTIATE_TEST_SUITE_P(Counts, WorkersOf, ::testing::Values(1, 2, 3, 8));

TEST(Workers, ZeroMeansOneACore) {
  EXPECT_EQ(Workers(0).count(), std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
}

TEST(Workers, ASmallTeamDoesNotNarrowALargerOne) {
  Workers one(1);
  Workers two(2);
  std::atomic<int> met{0};
  std::atomic<int> missed{0};
  two.run(2, [&](int, int) {
    ++met;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (met < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    if (met < 2) ++missed;
  });
  EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace kinescope
