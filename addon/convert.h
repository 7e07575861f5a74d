#pragma once
#include <napi.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "telar/limits.h"
#include "telar/renderer.h"
#include "telar/zeroed_bytes.h"

/// Node-API values to C++ structs and back. js/ has validated what users gave; what stands here only keeps a mistake in
/// js/ from becoming a crash: it throws Napi::TypeError.
namespace telar::addon {

using Bytes = std::vector<std::byte>;
/// Of a file, in memory that the next one may have.
using FileBytes = std::vector<std::byte, ZeroedAllocator<std::byte>>;

/// {L_FILE_BYTES: 67108864, ...}: the defaults, and by their keys the names.
Napi::Object limitsToJs(Napi::Env env, const Limits& limits);
/// The defaults, less what the object (or undefined) sets.
Limits limitsFromJs(const Napi::Value& value);

/// {backend, assetDirectory, cacheDirectory, cacheBytes, limits, allFeatures}
RendererOptions rendererOptionsFromJs(const Napi::Object& object);

std::string stringFromJs(const Napi::Value& value, const char* what);

/// Copies a Uint8Array or Buffer, over shared memory too. @throws Error{L_FILE_BYTES}
std::shared_ptr<const FileBytes> copyBytes(const Napi::Value& value, double maxBytes);

/// Hands the bytes to JavaScript without a copy where the runtime allows that.
Napi::Buffer<std::uint8_t> bytesToJs(Napi::Env env, Bytes bytes);

}  // namespace telar::addon
