// Light through a transmissive surface: the picture of everything that does not transmit, refracted and blurred.
// World space.
uniform sampler2D transmissionTarget;  // linear Rec.709 radiance, A coverage; mipmapped
uniform mat4 projectionMatrix;
uniform vec3 cameraPosition;           // world space
#if VOLUME
uniform vec3 thicknessScale;           // mesh units to metres, by axis
#endif

// Coordinates are clamped this far outside of the picture: only its border is read there.
#define SCREEN_UV_MAX 16.0

struct Transmitted {
  vec4 light;          // radiance and coverage of what lies behind
  vec3 transmittance;  // of the volume
};

// Picture coordinates of a point, [0, 1] within it. A point in the camera's plane has none.
vec2 screenUv(vec3 world) {
  vec4 clip = projectionMatrix * viewMatrix * vec4(world, 1.0);
  vec2 uv = vec2(clip) / clip.w;
  uv += 1.0;
  uv /= 2.0;
  return any(isnan(uv)) ? vec2(0.5) : clamp(uv, -SCREEN_UV_MAX, SCREEN_UV_MAX);
}

// size  of the level, pixels. Mesa gives 0 for a level beyond the last, and llvmpipe gives one size for several pixels at a
//       time: a corner of the picture is read then, as in three.js there, but never at infinity.
vec4 bicubicTexture(vec2 uv, vec2 size, float lod) {
  vec2 texel = min(1.0 / size, vec2(SCREEN_UV_MAX));
  vec2 at = uv * size + 0.5;
  vec2 base = floor(at);
  BicubicTaps x = bicubicTaps(fract(at.x));
  BicubicTaps y = bicubicTaps(fract(at.y));
  vec2 p0 = (vec2(base.x + x.lowOffset, base.y + y.lowOffset) - 0.5) * texel;
  vec2 p1 = (vec2(base.x + x.highOffset, base.y + y.lowOffset) - 0.5) * texel;
  vec2 p2 = (vec2(base.x + x.lowOffset, base.y + y.highOffset) - 0.5) * texel;
  vec2 p3 = (vec2(base.x + x.highOffset, base.y + y.highOffset) - 0.5) * texel;
  return y.lowWeight * (x.lowWeight * textureLod(transmissionTarget, p0, lod) + x.highWeight * textureLod(transmissionTarget, p1, lod)) +
         y.highWeight * (x.lowWeight * textureLod(transmissionTarget, p2, lod) + x.highWeight * textureLod(transmissionTarget, p3, lod));
}

vec2 levelSize(float level) { return vec2(textureSize(transmissionTarget, int(level))); }

vec4 behind(vec2 uv, float perceptualRoughness, float ior) {
  float lod = transmissionLod(perceptualRoughness, ior, log2(levelSize(0.0).x));
  vec4 sharper = bicubicTexture(uv, levelSize(lod), floor(lod));
  vec4 softer = bicubicTexture(uv, levelSize(lod + 1.0), ceil(lod));
  return mix(sharper, softer, fract(lod));
}

Transmitted through(float perceptualRoughness, vec3 n, vec3 v, float ior, float thickness) {
  Transmitted result;
  vec3 path = vec3(0.0);
#if VOLUME
  path = refractedDirection(n, v, ior) * thickness * thicknessScale;
#endif
  result.light = behind(screenUv(vWorldPosition + path), perceptualRoughness, ior);
#if ATTENUATION
  result.transmittance = volumeTransmittance(length(path), attenuationColor, attenuationDistance);
#else
  result.transmittance = vec3(1.0);
#endif
  return result;
}

// Radiance that comes through the surface, and its opacity.
vec4 transmittedLight(SurfaceInfo s) {
  vec3 n = normalize(vec3(vec4(s.n, 0.0) * viewMatrix));
  vec3 v = safeNormalize(cameraPosition - vWorldPosition, n);
  float thickness = 0.0;
#if VOLUME
  thickness = thicknessFactor;
#if THICKNESS_MAP
  thickness *= texture(thicknessMap, vThicknessUv).g;
#endif
#endif
#if DISPERSION
  vec3 iors = dispersedIor(ior, dispersion);
  Transmitted red = through(s.perceptualRoughness, n, v, iors.r, thickness);
  Transmitted green = through(s.perceptualRoughness, n, v, iors.g, thickness);
  Transmitted blue = through(s.perceptualRoughness, n, v, iors.b, thickness);
  vec4 light = vec4(red.light.r, green.light.g, blue.light.b, (red.light.a + green.light.a + blue.light.a) / 3.0);
  vec3 transmittance = s.diffuse * vec3(red.transmittance.r, green.transmittance.g, blue.transmittance.b);
#else
  Transmitted all = through(s.perceptualRoughness, n, v, ior, thickness);
  vec4 light = all.light;
  vec3 transmittance = s.diffuse * all.transmittance;
#endif
  // From the eye, also under parallel projection, as three.js has it.
  vec2 dfg = splitSum(s.perceptualRoughness, saturate(dot(n, v)));
  vec3 reflected = s.f0 * dfg.x + s.f90 * dfg.y;
  vec3 attenuated = transmittance * light.rgb;
#if THREE_GLASS_ALPHA_TERM == THREE_GLASS_ALPHA_ADDED_TENTH
  return vec4((1.0 - reflected) * attenuated, light.a);
#else
  return vec4((1.0 - reflected) * attenuated, transmittedAlpha(transmittance, light.a));
#endif
}

float transmissionWeight() {
#if TRANSMISSION_MAP
  return transmissionFactor * texture(transmissionMap, vTransmissionUv).r;
#else
  return transmissionFactor;
#endif
}
