#pragma once
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace telar::addon {

/// A few threads of our own that run tasks in order of arrival. libuv's pool is left to Node: a render of half a second
/// there would hold up every fs and dns call of the process.
/// A task must not throw. Safe to call from any thread; the destructor never blocks.
class TaskThreads {
 public:
  using Task = std::function<void()>;

  /// @param maxQueued tasks that may wait; running ones do not count
  /// @param onExit    run by each thread as the last thing it does
  /// @throws std::system_error when the system has no more threads
  TaskThreads(unsigned threads, std::size_t maxQueued, Task onExit = {});
  ~TaskThreads();
  TaskThreads(const TaskThreads&) = delete;
  TaskThreads& operator=(const TaskThreads&) = delete;

  /// @return false when the queue is full or the threads were told to stop: the task was not taken
  bool post(Task task);
  /// Ahead of all that wait, and past the queue's bound: for the second stage of work that was let in already.
  bool postFirst(Task task);

  /// Takes no more tasks; the threads end after those that wait, and `last`.
  /// @return false when they were told to stop before: `last` will not run
  bool finish(Task last = {});
  /// Takes no more tasks, and drops those that wait.
  void abandon();
  /// Waits until every thread has ended, at most until the deadline; a thread that is late is left to end by itself.
  /// @return whether all have ended
  bool join(std::chrono::steady_clock::time_point deadline);

 private:
  struct Shared;
  static void run(const std::shared_ptr<Shared>& shared);

  std::shared_ptr<Shared> shared_;  // the threads' too: they may outlive this object
  std::vector<std::thread> threads_;
};

}  // namespace telar::addon
