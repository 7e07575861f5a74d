#pragma once
#include <napi.h>

#include <condition_variable>
#include <memory>
#include <mutex>

#include "convert.h"
#include "job.h"
#include "telar/load.h"

namespace telar::addon {

class PartsHandle;

/// One question at a time, from a loading thread to JavaScript, and its answer.
struct PartsDesk {
  enum class Outcome { kAsked, kMissing, kGiven, kTooLarge, kNoMemory, kFailed };

  PartsHandle* handle = nullptr;  ///< JavaScript thread only; null when it was collected

  std::mutex mutex;  // guards what follows
  std::condition_variable answered;
  double question = 0;  ///< number of the one that is open
  Outcome outcome = Outcome::kFailed;
  double room = 0, size = 0;  ///< bytes that may be taken, and that are offered
  Bytes bytes;
};

/// new Parts(ask): the files that a model names, as JavaScript hands them over. ask(id: number, uri: string) is called
/// on the JavaScript thread; answer(id, bytes: Uint8Array | undefined = there is none) or fail(id) ends the loader's
/// wait. close() lets go of `ask`, which holds whatever answers: until then neither is collected.
class PartsHandle : public Napi::ObjectWrap<PartsHandle> {
 public:
  static constexpr napi_type_tag TAG{0x74656c6172000005, 0x9a3f5c1e7b2d4860};
  static Napi::Function define(Napi::Env env);
  explicit PartsHandle(const Napi::CallbackInfo& info);
  ~PartsHandle() override;

  const std::shared_ptr<PartsDesk>& desk() const { return desk_; }
  /// JavaScript thread: puts the question that is open.
  void ask(Napi::Env env, double question, const std::string& uri);

 private:
  void answer(const Napi::CallbackInfo& info);
  void fail(const Napi::CallbackInfo& info);
  void close(const Napi::CallbackInfo&) { ask_.Reset(); }
  void settle(double question, PartsDesk::Outcome outcome);

  std::shared_ptr<PartsDesk> desk_ = std::make_shared<PartsDesk>();
  Napi::FunctionReference ask_;
};

/// What a loader reads of them. Waits for JavaScript, so it must not run on a thread that others need.
class AskedFiles : public ExternalFiles {
 public:
  AskedFiles(std::shared_ptr<PartsDesk> desk, std::shared_ptr<Mailbox> mailbox, const Limits& limits)
      : desk_(std::move(desk)), mailbox_(std::move(mailbox)), limits_(limits) {}

  /// @throws Error{X_RESOLVE} where JavaScript called fail(); std::bad_alloc
  std::vector<std::byte> read(const std::string& path, const std::string& where, const CancelToken& cancel) override;
  std::uint64_t bytesRead() const override { return bytes_; }

 private:
  std::shared_ptr<PartsDesk> desk_;
  std::shared_ptr<Mailbox> mailbox_;
  Limits limits_;
  std::uint64_t files_ = 0, bytes_ = 0;
};

}  // namespace telar::addon
