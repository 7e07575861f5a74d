// A map beside the source, over the same square: its level 0 is read.
// BESIDE 0: there is none. A software GL would look it up all the same.
// BESIDE_FITS 1: it has as many texels as the source, and so have others; 0: of any size.
#if BESIDE
uniform sampler2D besideMap;
#endif

#if !BESIDE_FITS
// Blended here, and so alike whatever filter the map has; repeated.   place  of the square, 0..1
vec4 besideAt(sampler2D map, vec2 place) {
  ivec2 size = textureSize(map, 0);
  vec2 at = place * vec2(size) - 0.5, low = floor(at), part = at - low;
  ivec2 a = (ivec2(low) + size) % size, b = (ivec2(low) + 1) % size;
  vec4 row = mix(texelFetch(map, a, 0), texelFetch(map, ivec2(b.x, a.y), 0), part.x);
  vec4 next = mix(texelFetch(map, ivec2(a.x, b.y), 0), texelFetch(map, b, 0), part.x);
  return mix(row, next, part.y);
}
#endif

// At a texel of the source.   count  texels of the source
vec4 besideTexel(sampler2D map, ivec2 at, ivec2 count) {
#if BESIDE_FITS
  return texelFetch(map, at, 0);
#else
  return besideAt(map, (vec2(at) + 0.5) / vec2(count));
#endif
}
