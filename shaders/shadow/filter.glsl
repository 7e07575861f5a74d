// Fragment stage: how much of a light gets past the model, filtered as PCFShadowMap of three.js 0.187. Five taps of the
// hardware's bilinear comparison on a disk that turns from pixel to pixel. Before 0.182 see packed_grid.glsl.
#if THREE_SHADOW_FILTER_TERM == THREE_SHADOW_FILTER_PACKED_GRID
#define FlatShadowMap sampler2D
#define CubeShadowMap sampler2D
#include "shadow/packed_grid.glsl"
#else
#define FlatShadowMap sampler2DShadow
#define CubeShadowMap samplerCubeShadow
precision highp sampler2DShadow;
precision highp samplerCubeShadow;
#endif

#include "shadow/varyings.glsl"
#if FLAT_SHADOWS > 0
uniform FlatShadowMap flatShadowMap[FLAT_SHADOWS];
uniform vec4 flatShadow[FLAT_SHADOWS];  // radius in texels, texels on a side, bias, part of the light that it takes
#endif
#if CUBE_SHADOWS > 0
uniform CubeShadowMap cubeShadowMap[CUBE_SHADOWS];
uniform vec4 cubeShadow[CUBE_SHADOWS];
uniform vec2 cubeShadowRange[CUBE_SHADOWS];  // near and far, metres
#endif

#if THREE_SHADOW_FILTER_TERM == THREE_SHADOW_FILTER_DEPTH_DISK
const float TURN = 6.283185307179586;
const float GOLDEN_ANGLE = 2.399963229728653;
const int TAPS = 5;

// Angle of the disk at this pixel.
float diskAngle() { return interleavedGradientNoise(pixelCentre()) * TURN; }

// One of TAPS points spread evenly over the unit disk: Vogel's spiral.
vec2 diskPoint(int tap, float angle) {
  float r = sqrt((float(tap) + 0.5) / float(TAPS));
  float theta = float(tap) * GOLDEN_ANGLE + angle;
  return vec2(cos(theta), sin(theta)) * r;
}
#endif

#if FLAT_SHADOWS > 0
// coord  map coordinates times w
// return part of the light that arrives, 0..1; 1 beside the map
float flatVisibility(FlatShadowMap map, vec4 settings, vec4 coord) {
  coord.xyz /= coord.w;
  coord.z += settings.z;
  if (!(coord.x >= 0.0 && coord.x <= 1.0 && coord.y >= 0.0 && coord.y <= 1.0 && coord.z <= 1.0)) return 1.0;
  vec2 radius = settings.x * (vec2(1.0) / vec2(settings.y));
#if THREE_SHADOW_FILTER_TERM == THREE_SHADOW_FILTER_PACKED_GRID
  return mix(1.0, gridVisibility(map, coord.xy, coord.z, radius), settings.w);
#else
  float angle = diskAngle();
  float visible = texture(map, vec3(coord.xy + diskPoint(0, angle) * radius, coord.z));
  for (int tap = 1; tap < TAPS; ++tap) visible += texture(map, vec3(coord.xy + diskPoint(tap, angle) * radius, coord.z));
  return mix(1.0, visible * 0.2, settings.w);
#endif
}

float flatShadowVisibility(int i) {
  switch (i) {
#repeat FLAT_SHADOWS
    case INDEX: return flatVisibility(flatShadowMap[INDEX], flatShadow[INDEX], vFlatShadowCoord[INDEX]);
#end
  }
  return 1.0;
}
#endif

#if CUBE_SHADOWS > 0
// fromLight  vector from the light, metres; a face of the cube holds the depth along its own axis
float cubeVisibility(CubeShadowMap map, vec4 settings, vec2 range, vec3 fromLight) {
  float near = range.x;
  float far = range.y;
#if THREE_SHADOW_FILTER_TERM == THREE_SHADOW_FILTER_PACKED_GRID
#if THREE_POINT_SHADOW_TERM != THREE_POINT_SHADOW_RANGE_COMPARED
  float reach = length(fromLight);
  if (!(reach - far <= 0.0 && reach - near >= 0.0)) return 1.0;
#endif
  return mix(1.0, atlasVisibility(map, settings, range, fromLight), settings.w);
#else
  vec3 size = abs(fromLight);
  float axisDistance = max(max(size.x, size.y), size.z);
#if THREE_POINT_SHADOW_TERM != THREE_POINT_SHADOW_RANGE_COMPARED
  if (!(axisDistance - far <= 0.0 && axisDistance - near >= 0.0)) return 1.0;
#endif
  vec3 direction = normalize(fromLight);
#if THREE_POINT_SHADOW_TERM == THREE_POINT_SHADOW_OWN_FACE
  // Depth is offset + scale / axis distance.
  float offset = far / (far - near) + settings.z;
  float scale = -near * far / ((far - near) * length(fromLight));
#else
  // The depth on the face of the point itself, wherever a tap falls.
  float depth = far * (axisDistance - near) / (axisDistance * (far - near)) + settings.z;
#endif
  float radius = settings.x / settings.y;
  vec3 steep = abs(direction);
  vec3 tangent = normalize(cross(direction, steep.x > steep.z ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 bitangent = cross(direction, tangent);
  float angle = diskAngle();
  float visible = 0.0;
  for (int tap = 0; tap < TAPS; ++tap) {
    vec2 point = diskPoint(tap, angle);
    vec3 towards = direction + (tangent * point.x + bitangent * point.y) * radius;
#if THREE_POINT_SHADOW_TERM == THREE_POINT_SHADOW_OWN_FACE
    vec3 along = abs(towards);
    visible += texture(map, vec4(towards, offset + scale / max(max(along.x, along.y), along.z)));
#else
    visible += texture(map, vec4(towards, depth));
#endif
  }
  return mix(1.0, visible * 0.2, settings.w);
#endif
}

float cubeShadowVisibility(int i) {
  switch (i) {
#repeat CUBE_SHADOWS
    case INDEX: return cubeVisibility(cubeShadowMap[INDEX], cubeShadow[INDEX], cubeShadowRange[INDEX], vCubeShadowCoord[INDEX].xyz);
#end
  }
  return 1.0;
}
#endif
