// The sphere on a square texture: a read of it chooses no face, as one of a cube does. Every level has a gutter of one texel, in
// which the map goes on beyond its edge, so that a bilinear read meets no seam.
// src: Engelhardt & Dachsbacher 2008, "Octahedron Environment Maps"
#include "octahedron.glsl"

const float OCTAHEDRAL_LEAST_SIZE = 16.0;  // texels on an edge of the last level (renderer/ibl/octahedral_map.h)

// Texture coordinates in a level. size: texels on its edge, with the gutter
vec2 octahedralUv(vec3 direction, float size) { return 0.5 + octahedronPlace(direction) * (0.5 - 1.0 / size); }

// Beyond an edge lies what is beside it, turned round about the middle of the edge.
vec2 octahedralWrapped(vec2 place) {
  if (abs(place.x) > 1.0) place = vec2(sign(place.x) * 2.0 - place.x, -place.y);
  if (abs(place.y) > 1.0) place = vec2(-place.x, sign(place.y) * 2.0 - place.y);
  return place;
}
