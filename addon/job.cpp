#include "job.h"

namespace telar::addon {
void Mailbox::open(Napi::Env env) {
  wake_ = Wake::New(env, "telar", 0, 1, this);
  wake_.Unref(env);
  std::lock_guard lock(mutex_);
  open_ = true;
}

void Mailbox::close() {
  std::vector<std::shared_ptr<Job>> done;
  std::vector<std::function<void(Napi::Env)>> actions;
  std::lock_guard lock(mutex_);
  if (!open_) return;
  open_ = false;
  done.swap(done_);
  actions.swap(actions_);
  live_.clear();
  wake_.Release();
}

Napi::Value Mailbox::begin(Napi::Env env, const std::shared_ptr<Job>& job) {
  // Only this thread writes open_.
  if (!open_) throw Napi::Error::New(env, "this Node environment is ending");
  napi_value promise = nullptr;
  NAPI_THROW_IF_FAILED(env, napi_create_promise(env, &job->deferred_, &promise), {});
  if (live_.empty()) wake_.Ref(env);
  live_.insert(job);
  return {env, promise};
}

void Mailbox::deliver(std::shared_ptr<Job> job) {
  std::lock_guard lock(mutex_);
  if (!open_) return;
  done_.push_back(std::move(job));
  wake_.NonBlockingCall();
}

void Mailbox::call(std::function<void(Napi::Env)> action) {
  std::lock_guard lock(mutex_);
  if (!open_) return;
  actions_.push_back(std::move(action));
  wake_.NonBlockingCall();
}

bool Mailbox::perform(const std::shared_ptr<Job>& job, const std::function<bool()>& work) {
  try {
    const CancelToken::Work time(job->cancel);
    job->cancel.check();
    if (!work()) return true;
  } catch (...) {
    job->fault = Fault::current();
  }
  deliver(job);
  return false;
}

void Mailbox::cancelAll() {
  for (const std::shared_ptr<Job>& job : live_) job->cancel.cancel();
}

void Mailbox::onWake(Napi::Env env, Napi::Function, Mailbox* self, void*) {
  // A null environment is torn down already, and the mailbox with it.
  if (env != nullptr) self->drain(env);
}

// A status that is not napi_ok means that the environment is being torn down: nobody listens to the promise any more.
void Mailbox::settle(Napi::Env env, const Job& job) {
  napi_value reason = nullptr;
  try {
    if (!job.fault) {
      napi_resolve_deferred(env, job.deferred_, job.value ? job.value(env) : env.Undefined());
      return;
    }
    reason = job.fault->toJs(env);
  } catch (const Napi::Error& error) {
    reason = error.Value();
  } catch (...) {
    reason = Fault::current().toJs(env);
  }
  napi_reject_deferred(env, job.deferred_, reason);
}

void Mailbox::drain(Napi::Env env) {
  std::vector<std::shared_ptr<Job>> done;
  std::vector<std::function<void(Napi::Env)>> actions;
  {
    std::lock_guard lock(mutex_);
    done.swap(done_);
    actions.swap(actions_);
  }
  for (const auto& action : actions) {
    Napi::HandleScope scope(env);
    action(env);
  }
  for (const std::shared_ptr<Job>& job : done) {
    Napi::HandleScope scope(env);
    live_.erase(job);
    settle(env, *job);
  }
  if (!done.empty() && live_.empty()) wake_.Unref(env);
}

}  // namespace telar::addon
