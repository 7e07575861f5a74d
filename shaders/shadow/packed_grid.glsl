// Fragment stage: shadows as three.js filters them before 0.182, over packed depths that are read one by one.
#include "shadow/packing.glsl"

// return 1 where nothing lies before this depth
float passes(sampler2D map, vec2 at, float depth) { return step(depth, unpackedDepth(texture(map, at))); }

#if FLAT_SHADOWS > 0
// The mean of the point itself, of the eight about it at `radius` and of the eight at half of it.
// at      map coordinates
// radius  in map coordinates
float gridVisibility(sampler2D map, vec2 at, float depth, vec2 radius) {
  float visible = passes(map, at, depth);
  for (int ring = 0; ring < 9; ++ring) {
    vec2 direction = vec2(ring % 3 - 1, ring / 3 - 1);
    if (ring == 4) continue;
    visible += passes(map, at + direction * radius, depth);
    visible += passes(map, at + direction * (radius * 0.5), depth);
  }
  return visible * (1.0 / 17.0);
}
#endif

#if CUBE_SHADOWS > 0
// Where a direction from the light lies in an atlas of 4 x 2 faces: -x -z +x +z above, -y and +y below the second and the
// fourth. Each face is narrowed by half a texel to each side.
// height  of a texel, where the atlas is 1 high
vec2 atlasPlace(vec3 direction, float height) {
  vec3 size = abs(direction);
  float toCube = 1.0 / max(size.x, max(size.y, size.z));
  vec3 narrowed = direction * (toCube * (1.0 - 2.0 * height));
  // Along an edge a point belongs to both faces: z goes before x, and x before y.
  bvec3 reaches = greaterThanEqual(size * toCube, vec3(1.0 - 1.5 * height));
  vec2 side = sign(narrowed.xy);
  // In halves of a face, from the middle of the face of -z.
  vec2 place = narrowed.xy;
  if (reaches.z) {
    if (narrowed.z > 0.0) place.x = 4.0 - narrowed.x;
  } else if (reaches.x) {
    place.x = narrowed.z * side.x + 2.0 * side.x;
  } else if (reaches.y) {
    place = vec2(narrowed.x + 2.0 * side.y + 2.0, narrowed.z * side.y - 2.0);
  }
  return place * vec2(0.125, 0.25) + vec2(0.375, 0.75);
}

// The mean over the direction and the corners of a cube about it.
// settings   radius in texels, texels on a side of a face, bias
// range      near and far, metres
// fromLight  metres
float atlasVisibility(sampler2D map, vec4 settings, vec2 range, vec3 fromLight) {
  float height = 1.0 / (settings.y * 2.0);
  float depth = (length(fromLight) - range.x) / (range.y - range.x) + settings.z;
  vec3 direction = normalize(fromLight);
  float visible = passes(map, atlasPlace(direction, height), depth);
  for (int corner = 0; corner < 8; ++corner) {
    vec3 away = vec3(ivec3(corner, corner >> 1, corner >> 2) & 1) * 2.0 - 1.0;
    visible += passes(map, atlasPlace(direction + away * (settings.x * height), height), depth);
  }
  return visible * (1.0 / 9.0);
}
#endif
