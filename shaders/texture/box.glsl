// The box filter between two mip levels of any size: texel i of a level covers i * ratio .. (i + 1) * ratio of the
// larger one, ratio 1 .. 3, the outer texels by the part of them that is covered.
// HALVES 1: both sides are halved exactly: four texels of the larger level count the same.
uniform vec2 sourceSize;  // texels of the larger level
uniform vec2 targetSize;  // texels of the level that is drawn

// What is averaged, at a texel of the larger level.
vec4 momentsAt(ivec2 at);

#if HALVES
vec4 boxMean(vec2 texel) {
  ivec2 at = 2 * ivec2(texel);
  return 0.25 * (momentsAt(at) + momentsAt(at + ivec2(1, 0)) + momentsAt(at + ivec2(0, 1)) + momentsAt(at + ivec2(1)));
}
#else
// Part of texel `at` that lies within from .. to.
float covered(float at, float from, float to) {
  return max(min(at + 1.0, to) - max(at, from), 0.0);
}

// texel  of the level that is drawn, its lower corner
vec4 boxMean(vec2 texel) {
  vec2 from = texel * sourceSize / targetSize;
  vec2 to = (texel + 1.0) * sourceSize / targetSize;
  ivec2 first = ivec2(from);
  ivec2 reach = ivec2(ceil(sourceSize / targetSize));  // 2 where a side halves: a third texel has no weight, and its cost
  vec4 sum = vec4(0.0);
  float area = 0.0;
  for (int j = 0; j < reach.y; ++j) {
    for (int i = 0; i < reach.x; ++i) {
      ivec2 at = first + ivec2(i, j);
      float weight = covered(float(at.x), from.x, to.x) * covered(float(at.y), from.y, to.y);
      if (weight > 0.0) sum += weight * momentsAt(min(at, ivec2(sourceSize) - 1));
      area += weight;
    }
  }
  return sum / area;
}
#endif
