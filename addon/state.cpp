#include "state.h"

#include <algorithm>
#include <limits>

namespace telar::addon {
namespace {

constexpr unsigned POOL_THREADS = 2;
constexpr unsigned PATIENT_THREADS = 4;
constexpr std::size_t POOL_QUEUE = 1024;
/// How long an ending environment waits for its threads. Cancelled work stops within milliseconds; what takes this long
/// is stuck in a driver, and is left behind.
constexpr std::chrono::seconds SHUT_DOWN_WAIT{5};

}  // namespace

State::State(Napi::Env env) {
  mailbox_->open(env);
  // Hooks run last in, first out: this one runs before Node closes the thread-safe function that the mailbox opened.
  env.AddCleanupHook([this] { shutDown(); });
}

const std::shared_ptr<TaskThreads>& State::pool() {
  if (!pool_) pool_ = std::make_shared<TaskThreads>(POOL_THREADS, POOL_QUEUE);
  return pool_;
}

const std::shared_ptr<TaskThreads>& State::patientPool() {
  if (!patientPool_) patientPool_ = std::make_shared<TaskThreads>(PATIENT_THREADS, POOL_QUEUE);
  return patientPool_;
}

std::shared_ptr<GlThread> State::startGlThread(std::size_t maxQueued) {
  // The identity that forget() looks for is known only after the thread has begun, which may by then have ended.
  auto self = std::make_shared<std::weak_ptr<GlThread>>();
  auto thread = std::make_shared<GlThread>(maxQueued, [this, self, mailbox = mailbox_] {
    mailbox->call([this, self](Napi::Env) { forget(self->lock().get()); });
  });
  *self = thread;
  glThreads_.push_back(thread);
  return thread;
}

Napi::Value State::runOn(Pool which, Napi::Env env, const std::shared_ptr<Job>& job, std::function<void()> work) {
  const Napi::Value promise = mailbox_->begin(env, job);
  std::shared_ptr<TaskThreads> threads;
  try {
    threads = (this->*which)();
  } catch (...) {
    job->fault = Fault::current();
    mailbox_->deliver(job);
    return promise;
  }
  const bool taken = threads->post([mailbox = mailbox_, job, work = std::move(work)] {
    mailbox->perform(job, [&] {
      work();
      return true;
    });
  });
  if (!taken) {
    job->fault = Fault{"X_BUSY", "too many jobs wait for the loading threads; try again later", {}, {}, {}};
    mailbox_->deliver(job);
  }
  return promise;
}

void State::forget(const GlThread* ended) {
  std::erase_if(glThreads_, [&](const std::shared_ptr<GlThread>& thread) {
    if (thread.get() != ended) return false;
    thread->join(std::chrono::steady_clock::time_point::max());
    return true;
  });
}

bool State::shutDown() {
  mailbox_->cancelAll();
  mailbox_->close();
  for (const std::shared_ptr<GlThread>& thread : glThreads_) thread->abandon();
  for (const auto& pool : {pool_, patientPool_}) {
    if (pool) pool->abandon();
  }
  const auto deadline = std::chrono::steady_clock::now() + SHUT_DOWN_WAIT;
  bool all = true;
  for (const std::shared_ptr<GlThread>& thread : glThreads_) all = thread->join(deadline) && all;
  for (const auto& pool : {pool_, patientPool_}) {
    if (pool) all = pool->join(deadline) && all;
  }
  return all;
}

Napi::Value textOnPool(Napi::Env env, const std::shared_ptr<Job>& job, std::function<std::string()> make) {
  return State::of(env).runOnPool(env, job, [job, make = std::move(make)] {
    job->value = [text = make()](Napi::Env to) { return Napi::String::New(to, text); };
  });
}

}  // namespace telar::addon
