// A fixed team of threads that shares out numbered tasks. The only file behind which TBB stands.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>

namespace kinescope {

/// A team of `count()` workers. Results must not depend on which worker runs a task.
class Workers {
 public:
  /// @param threads how many threads take part, the caller among them; 0 means one a core.
  explicit Workers(int threads = 0);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int count() const { return count_; }

  /// Calls body(task, worker) once for each task in [0, tasks) and returns when all are done.
  /// Tasks start in increasing order; each worker, numbered in [0, count()), sees its own tasks in
  /// increasing order, one at a time. An exception in a task reaches the caller.
  void run(int tasks, const std::function<void(int task, int worker)>& body);

 private:
  struct Backend;
  int count_;
  std::unique_ptr<Backend> backend_;
};

/// Calls row(y) for each y in [0, rows), many rows a task.
template <typename Row>
void run_rows(Workers& workers, int rows, const Row& row) {
  constexpr int kRowsATask = 64;
  workers.run((rows + kRowsATask - 1) / kRowsATask, [&](int task, int) {
    const int end = std::min(rows, (task + 1) * kRowsATask);
    for (int y = task * kRowsATask; y < end; ++y) row(y);
  });
}

}  // namespace kinescope
