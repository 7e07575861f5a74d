#pragma once
#include <napi.h>

/// Image files in and out for telar/compare, which has pictures but no renderer. Both run on the pool.
namespace telar::addon {

/// decodeImage(file: Bytes, limits, token) -> Promise<{width, height, data: Buffer}>: RGBA8, straight alpha, top row
/// first
Napi::Value decodeImage(const Napi::CallbackInfo& info);

/// encodePng(rgba8: Bytes, width, height, token) -> Promise<Buffer>
Napi::Value encodePng(const Napi::CallbackInfo& info);

}  // namespace telar::addon
