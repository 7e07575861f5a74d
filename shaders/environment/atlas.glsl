// Reading an environment atlas: what three.js to 0.186 prefilters an environment to. Shared by its surfaces and by the passes that
// make it.
// A level of edge e holds the six faces of a cube as tiles of e x e texels: +x +y +z from the left, -x -y -z above them. A face
// has a border of one texel that continues it beyond its edges, so that a bilinear read stays within its tile. Levels stand above
// each other, the sharpest at the bottom, down to e = 16: level "mip" has e = 2^mip. The six rougher ones, mip 3 to -2, have
// e = 16 too and stand to the right of the level of mip 4.
// Precision is that of the text that includes this: where it is mediump Mesa rounds every operation to half floats, and so their
// order is that of three r150 to r186.
const float ATLAS_EDGE_MIN = 16.0;
const float ATLAS_MIP_MIN = 4.0;      // log2 of that
const float ATLAS_MIP_ROUGHEST = -2.0;

// Place in the atlas, in texels, where a level is read in a direction, which need not be unit.
// maxMip  that of the sharpest level
highp vec2 atlasPlace(vec3 direction, float mip, float maxMip) {
  vec3 size = abs(direction);
  vec3 p;  // across the face, up on it, and along its axis
  float column;
  if (size.x > max(size.y, size.z)) {
    p = vec3(direction.x > 0.0 ? direction.z : -direction.z, direction.yx);
    column = 0.0;
  } else if (size.z > size.y) {
    p = vec3(direction.z > 0.0 ? -direction.x : direction.x, direction.yz);
    column = 2.0;
  } else {
    p = vec3(-direction.x, direction.y > 0.0 ? -direction.z : direction.z, direction.y);
    column = 1.0;
  }
  float edge = exp2(max(mip, ATLAS_MIP_MIN));
  vec2 st = 0.5 * (p.xy / abs(p.z) + 1.0);
  highp vec2 place = st * (edge - 2.0) + 1.0;
  if (p.z <= 0.0) place.y += edge;
  place.x += column * edge;
  place.x += max(ATLAS_MIP_MIN - mip, 0.0) * 3.0 * ATLAS_EDGE_MIN;
  place.y += 4.0 * (exp2(maxMip) - edge);
  return place;
}

// texel  1 / size of the atlas
vec3 atlasLevel(sampler2D atlas, highp vec2 texel, float maxMip, vec3 direction, float mip) {
  return textureLod(atlas, atlasPlace(direction, mip, maxMip) * texel, 0.0).rgb;
}
