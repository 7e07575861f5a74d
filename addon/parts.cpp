#include "parts.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <new>

namespace telar::addon {
namespace {

using Outcome = PartsDesk::Outcome;

/// Between two looks at the cancel token.
constexpr std::chrono::milliseconds PATIENCE{10};

}  // namespace

Napi::Function PartsHandle::define(Napi::Env env) {
  return DefineClass(env, "Parts",
                     {InstanceMethod("answer", &PartsHandle::answer), InstanceMethod("fail", &PartsHandle::fail),
                      InstanceMethod("close", &PartsHandle::close)});
}

PartsHandle::PartsHandle(const Napi::CallbackInfo& info) : ObjectWrap(info) {
  if (!info[0].IsFunction()) throw Napi::TypeError::New(info.Env(), "native telar expected a function");
  ask_ = Napi::Persistent(info[0].As<Napi::Function>());
  desk_->handle = this;
  info.This().As<Napi::Object>().TypeTag(&TAG);
}

PartsHandle::~PartsHandle() { desk_->handle = nullptr; }

void PartsHandle::ask(Napi::Env env, double question, const std::string& uri) {
  if (ask_.IsEmpty()) return settle(question, Outcome::kFailed);
  try {
    ask_.Call({Napi::Number::New(env, question), Napi::String::New(env, uri)});
  } catch (const Napi::Error&) {
    settle(question, Outcome::kFailed);
  }
}

void PartsHandle::answer(const Napi::CallbackInfo& info) {
  const double question = info[0].ToNumber().DoubleValue();
  if (info[1].IsUndefined()) return settle(question, Outcome::kMissing);
  if (!info[1].IsTypedArray()) throw Napi::TypeError::New(info.Env(), "native telar expected a Uint8Array");
  const Napi::Uint8Array given = info[1].As<Napi::Uint8Array>();
  Outcome outcome = Outcome::kGiven;
  {
    const std::lock_guard lock(desk_->mutex);
    if (desk_->question != question || desk_->outcome != Outcome::kAsked) return;  // nobody waits for it any more
    desk_->size = static_cast<double>(given.ByteLength());
    if (desk_->size > desk_->room) {
      outcome = Outcome::kTooLarge;
    } else {
      try {
        desk_->bytes.resize(given.ByteLength());
        if (!desk_->bytes.empty()) std::memcpy(desk_->bytes.data(), given.Data(), desk_->bytes.size());
      } catch (const std::bad_alloc&) {
        outcome = Outcome::kNoMemory;
      }
    }
  }
  settle(question, outcome);
}

void PartsHandle::fail(const Napi::CallbackInfo& info) { settle(info[0].ToNumber().DoubleValue(), Outcome::kFailed); }

void PartsHandle::settle(double question, Outcome outcome) {
  const std::lock_guard lock(desk_->mutex);
  if (desk_->question != question || desk_->outcome != Outcome::kAsked) return;
  desk_->outcome = outcome;
  desk_->answered.notify_all();
}

std::vector<std::byte> AskedFiles::read(const std::string& path, const std::string& where, const CancelToken& cancel) {
  checkSum("L_EXTERNAL_FILES", static_cast<double>(limits_.externalFiles), static_cast<double>(++files_), where);
  std::unique_lock lock(desk_->mutex);
  const double question = ++desk_->question;
  desk_->outcome = Outcome::kAsked;
  desk_->room = static_cast<double>(std::min(limits_.fileBytes, limits_.externalBytes - bytes_));
  mailbox_->call([desk = desk_, question, path](Napi::Env env) {
    if (desk->handle) desk->handle->ask(env, question, path);
  });
  while (desk_->outcome == Outcome::kAsked) {
    cancel.check();
    desk_->answered.wait_for(lock, PATIENCE);
  }
  const auto fail = [&](const char* code, const std::string& what) {
    throw Error(code, "the option resolve " + what + " for the uri " + telar::quoted(path)).at(where);
  };
  switch (desk_->outcome) {
    case Outcome::kMissing:
      fail("E_URI_MISSING", "has no file");
      break;
    case Outcome::kFailed:
      fail("X_RESOLVE", "failed");
      break;
    case Outcome::kNoMemory:
      throw std::bad_alloc();
    default:
      break;
  }
  const double sum = static_cast<double>(bytes_) + desk_->size;
  checkLimit("L_FILE_BYTES", static_cast<double>(limits_.fileBytes), desk_->size, where);
  checkSum("L_EXTERNAL_BYTES", static_cast<double>(limits_.externalBytes), sum, where);
  bytes_ += desk_->bytes.size();
  return std::move(desk_->bytes);
}

}  // namespace telar::addon
