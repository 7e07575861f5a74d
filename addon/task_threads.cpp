#include "task_threads.h"

#include <condition_variable>
#include <deque>
#include <mutex>

namespace telar::addon {

struct TaskThreads::Shared {
  std::mutex mutex;
  std::condition_variable wake, ended;
  std::deque<Task> queue;
  std::size_t maxQueued = 0;
  unsigned alive = 0;
  bool stopping = false;
  Task onExit;
};

TaskThreads::TaskThreads(unsigned threads, std::size_t maxQueued, Task onExit) : shared_(std::make_shared<Shared>()) {
  shared_->maxQueued = maxQueued;
  shared_->onExit = std::move(onExit);
  threads_.reserve(threads);
  try {
    for (unsigned i = 0; i < threads; ++i) {
      std::unique_lock lock(shared_->mutex);
      threads_.emplace_back(run, shared_);
      ++shared_->alive;
    }
  } catch (...) {
    abandon();
    for (std::thread& thread : threads_) thread.detach();
    throw;
  }
}

TaskThreads::~TaskThreads() {
  abandon();
  for (std::thread& thread : threads_) {
    if (thread.joinable()) thread.detach();
  }
}

void TaskThreads::run(const std::shared_ptr<Shared>& shared) {
  std::unique_lock lock(shared->mutex);
  for (;;) {
    shared->wake.wait(lock, [&] { return shared->stopping || !shared->queue.empty(); });
    if (shared->queue.empty()) break;
    Task task = std::move(shared->queue.front());
    shared->queue.pop_front();
    lock.unlock();
    task();
    task = nullptr;  // what it holds is freed outside of the lock
    lock.lock();
  }
  lock.unlock();
  if (shared->onExit) shared->onExit();
  lock.lock();
  --shared->alive;
  shared->ended.notify_all();
}

bool TaskThreads::post(Task task) {
  std::lock_guard lock(shared_->mutex);
  if (shared_->stopping || shared_->queue.size() >= shared_->maxQueued) return false;
  shared_->queue.push_back(std::move(task));
  shared_->wake.notify_one();
  return true;
}

bool TaskThreads::postFirst(Task task) {
  std::lock_guard lock(shared_->mutex);
  if (shared_->stopping) return false;
  shared_->queue.push_front(std::move(task));
  shared_->wake.notify_one();
  return true;
}

bool TaskThreads::finish(Task last) {
  std::lock_guard lock(shared_->mutex);
  if (shared_->stopping) return false;
  shared_->stopping = true;
  if (last) shared_->queue.push_back(std::move(last));
  shared_->wake.notify_all();
  return true;
}

void TaskThreads::abandon() {
  std::deque<Task> dropped;
  std::lock_guard lock(shared_->mutex);
  shared_->stopping = true;
  dropped.swap(shared_->queue);
  shared_->wake.notify_all();
}

bool TaskThreads::join(std::chrono::steady_clock::time_point deadline) {
  std::unique_lock lock(shared_->mutex);
  const bool all = shared_->ended.wait_until(lock, deadline, [&] { return shared_->alive == 0; });
  lock.unlock();
  for (std::thread& thread : threads_) {
    if (!thread.joinable()) continue;
    if (all) {
      thread.join();
    } else {
      thread.detach();
    }
  }
  threads_.clear();
  return all;
}

}  // namespace telar::addon
