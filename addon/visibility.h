#pragma once
#include <napi.h>

/// Ambient visibility of vertices (telar/visibility.h).
namespace telar::addon {

/// withVisibility(scene, rays: number, cache: {directory: string, bytes: number, version: string}, limits, token) ->
/// Promise<{scene, facts: string}>; the scene is gone afterwards
Napi::Value withVisibility(const Napi::CallbackInfo& info);

/// visibilityOf(scene, token) -> Promise<Array<{mesh: number, primitive: number, vertices: number, front: Buffer,
///                                              back: Buffer | null}>>
/// By index in the file: four normalized shorts a vertex, as glTF stores them, little endian.
Napi::Value visibilityOf(const Napi::CallbackInfo& info);

}  // namespace telar::addon
