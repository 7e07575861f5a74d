// The direction across the lines that the relief of a normal map runs along, if it does: the axis of reliefTowards() (brdf/relief.glsl) in its
// tangent space. From places that are strewn over the map.
// RG the first component, BA the second: from -1 to 1 as 16 bits, the high ones first, of which 32768 is 0 and none is 0.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/relief.glsl"

const int PLACES = 1024;
const float FLAT = 1.0e-3;  // squared sine: what leans no more, as 8 bits round it, has no lines

uniform sampler2D sourceMap;

out vec4 fragmentColor;

// x  [-1, 1]
vec2 bytesOf(float x) {
  float whole = floor(x * 32767.0 + 32768.5);
  float high = floor(whole / 256.0);
  return vec2(high, whole - 256.0 * high) / 255.0;
}

void main() {
  vec2 size = vec2(textureSize(sourceMap, 0));
  vec2 sum = vec2(0.0);
  vec3 squares = vec3(0.0);  // of x, of y, and x y
  for (int i = 0; i < PLACES; ++i) {
    // src: Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", R2
    vec2 place = fract(float(i) * vec2(0.7548776662, 0.5698402910));
    vec2 n = vec2(reliefOfTexel(texelFetch(sourceMap, ivec2(place * size), 0).rgb));
    sum += n;
    squares += n.xyx * n.xyy;
  }
  // About the mean, as the relief is.
  vec3 variance = squares / float(PLACES) - sum.xyx * sum.xyy / float(PLACES * PLACES);
  // Twice the angle of the axis, in a vector as long as the axis.
  vec2 turned = vec2(variance.x - variance.y, 2.0 * variance.z) / (variance.x + variance.y + FLAT);
  float stretch = min(length(turned), 1.0);
  float angle = stretch > 0.0 ? 0.5 * atan(turned.y, turned.x) : 0.0;
  fragmentColor = vec4(bytesOf(stretch * cos(angle)), bytesOf(stretch * sin(angle)));
}
