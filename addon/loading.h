#pragma once
#include <napi.h>

#include <functional>
#include <memory>
#include <string>

#include "convert.h"
#include "handles.h"
#include "parts.h"
#include "state.h"
#include "telar/load.h"

namespace telar::addon {

/// A model or file as js/ names it: an absolute path, or bytes.
struct Source {
  explicit Source(const Napi::Value& value) {
    if (value.IsString()) {
      path = value.As<Napi::String>();
    } else {
      bytes = unwrap<BytesHandle>(value).detach();
    }
  }
  std::string path;
  std::shared_ptr<const FileBytes> bytes;
};

/// How the files of a model are found and read: {tolerant?: boolean, decodesLater?: boolean, parts?: Parts}.
struct Loading {
  Loading(const Napi::Value& value, const Limits& limits) {
    if (!value.IsObject()) return;
    const Napi::Object how = value.As<Napi::Object>();
    options.tolerant = how.Get("tolerant").ToBoolean();
    options.decodesLater = how.Get("decodesLater").ToBoolean();
    const Napi::Value parts = how.Get("parts");
    if (parts.IsUndefined()) return;
    files = std::make_shared<AskedFiles>(unwrap<PartsHandle>(parts).desk(), State::of(value.Env()).mailbox(), limits);
    options.files = files.get();
  }

  /// Runs where it may wait for JavaScript, if it has to.
  Napi::Value run(Napi::Env env, const std::shared_ptr<Job>& job, std::function<void()> work) const {
    State& state = State::of(env);
    return files ? state.runOnPatientPool(env, job, std::move(work)) : state.runOnPool(env, job, std::move(work));
  }

  LoadOptions options;
  std::shared_ptr<AskedFiles> files;
};

}  // namespace telar::addon
