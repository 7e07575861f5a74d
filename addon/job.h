#pragma once
#include <napi.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_set>
#include <vector>

#include "fault.h"
#include "telar/cancel.h"

namespace telar::addon {

/// One promise and the work behind it. Made and settled on the JavaScript thread, worked on elsewhere by one thread at
/// a time.
struct Job {
  explicit Job(CancelToken token) : cancel(std::move(token)) {}

  const CancelToken cancel;
  /// Makes the value that the promise resolves to; set by the work, called on the JavaScript thread.
  std::function<Napi::Value(Napi::Env)> value;
  std::optional<Fault> fault;  ///< set = the promise rejects

 private:
  friend class Mailbox;
  napi_deferred deferred_ = nullptr;  // JavaScript thread only
};

/// Way of finished jobs back to the JavaScript thread: a list and one thread-safe function that wakes the event loop,
/// which it keeps alive only while jobs are live.
class Mailbox : public std::enable_shared_from_this<Mailbox> {
 public:
  /// JavaScript thread: opens the way. @throws Napi::Error
  void open(Napi::Env env);
  /// JavaScript thread: from here on nothing is delivered and the environment is not touched any more.
  void close();

  /// JavaScript thread: a job begins; its promise. Every job that begins is delivered once, or the mailbox is closed.
  /// @throws Napi::Error when it is closed
  Napi::Value begin(Napi::Env env, const std::shared_ptr<Job>& job);
  /// Any thread: the job is done, settle its promise.
  void deliver(std::shared_ptr<Job> job);
  /// Any thread: run this on the JavaScript thread. Does not keep the event loop alive.
  void call(std::function<void(Napi::Env)> action);

  /// Any thread: runs `work` on the job's time, and delivers the job unless the work returned false: it goes on in
  /// another task.
  /// @return whether it goes on
  bool perform(const std::shared_ptr<Job>& job, const std::function<bool()>& work);

  /// JavaScript thread: cancels every live job.
  void cancelAll();

 private:
  static void onWake(Napi::Env env, Napi::Function, Mailbox* self, void*);
  using Wake = Napi::TypedThreadSafeFunction<Mailbox, void, &Mailbox::onWake>;
  void drain(Napi::Env env);
  static void settle(Napi::Env env, const Job& job);

  std::mutex mutex_;  // guards open_, done_, actions_ and calls of wake_
  bool open_ = false;
  std::vector<std::shared_ptr<Job>> done_;
  std::vector<std::function<void(Napi::Env)>> actions_;
  Wake wake_;
  std::unordered_set<std::shared_ptr<Job>> live_;  // JavaScript thread only
};

}  // namespace telar::addon
