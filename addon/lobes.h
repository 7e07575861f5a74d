#pragma once
#include <napi.h>

/// What one material reflects, without a picture and without GL.
namespace telar::addon {

/// evaluateLobes(scene, {material: number, shot: string, viewAngle: number, directions: Float64Array, albedo: boolean},
///               token) -> Promise<{radiance: Float64Array, albedo: Float64Array}>
/// The lobes of telar/lobes.h: 15 numbers a direction (x, y, z in, RGB of diffuse, specular, sheen, coat and total
/// out); albedo holds 15 and the errors of these, or none where it was not asked for.
Napi::Value evaluateLobes(const Napi::CallbackInfo& info);

}  // namespace telar::addon
