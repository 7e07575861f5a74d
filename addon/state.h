#pragma once
#include <napi.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gl_thread.h"
#include "job.h"
#include "task_threads.h"

namespace telar::addon {

/// What the addon keeps for one Node environment (the main thread, or one worker). Nothing is shared between
/// environments.
class State {
 public:
  explicit State(Napi::Env env);
  static State& of(Napi::Env env) { return *env.GetInstanceData<State>(); }

  const std::shared_ptr<Mailbox>& mailbox() const { return mailbox_; }
  /// Threads that load and encode; started when first asked for.
  const std::shared_ptr<TaskThreads>& pool();
  /// Threads whose loads wait for JavaScript, so that they hold up no other load, and no encoding.
  const std::shared_ptr<TaskThreads>& patientPool();
  /// A new thread for a renderer. It is forgotten when it has ended.
  /// @throws std::system_error when the system has no more threads
  std::shared_ptr<GlThread> startGlThread(std::size_t maxQueued);
  /// Starts a job that runs on the pool; its promise. `work` runs there, and sets job->value.
  Napi::Value runOnPool(Napi::Env env, const std::shared_ptr<Job>& job, std::function<void()> work) {
    return runOn(&State::pool, env, job, std::move(work));
  }
  Napi::Value runOnPatientPool(Napi::Env env, const std::shared_ptr<Job>& job, std::function<void()> work) {
    return runOn(&State::patientPool, env, job, std::move(work));
  }

  /// Cancels every job and waits until the threads have ended, a few seconds at most. From here on jobs are refused.
  /// @return whether all have ended
  bool shutDown();

  Napi::FunctionReference sceneClass, rendererClass;

 private:
  using Pool = const std::shared_ptr<TaskThreads>& (State::*)();
  Napi::Value runOn(Pool which, Napi::Env env, const std::shared_ptr<Job>& job, std::function<void()> work);
  void forget(const GlThread* ended);

  std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>();
  std::shared_ptr<TaskThreads> pool_, patientPool_;
  std::vector<std::shared_ptr<GlThread>> glThreads_;
};

/// Makes the promise's value of the text that `make` returns on the pool.
Napi::Value textOnPool(Napi::Env env, const std::shared_ptr<Job>& job, std::function<std::string()> make);

}  // namespace telar::addon
