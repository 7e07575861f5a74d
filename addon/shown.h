#pragma once
#include <napi.h>

/// Where what a shot shows of a model lies (telar/part.h).
namespace telar::addon {

/// measurePart(scene, kind: "node" | "material", which: number | string, {variant, ghost: string}, token) ->
/// Promise<string>
Napi::Value measurePart(const Napi::CallbackInfo& info);

/// measureShown(scene, {variant, ghost: string}, token) -> Promise<string>
Napi::Value measureShown(const Napi::CallbackInfo& info);

/// rangesAlong(scene, axes: number[9], {variant, ghost: string}, token) -> Promise<string>
Napi::Value rangesAlong(const Napi::CallbackInfo& info);

}  // namespace telar::addon
