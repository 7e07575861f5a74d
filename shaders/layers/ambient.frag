// Ambient occlusion of a pixel from MAPS more directions, added to what was found before.
precision highp float;
precision highp int;
precision highp sampler2DShadow;

uniform highp sampler2D placeMap;   // A metres along the view
uniform highp sampler2D numberMap;  // R part, 0 = nothing is seen; BA geometric normal on an octahedron
uniform highp sampler2D sumMap;     // R weights whose light arrives, G all weights
uniform sampler2DShadow depthMap[MAPS];
uniform mat4 toMap[MAPS];      // view space to map coordinates, 0..1
uniform vec3 direction[MAPS];  // view space, unit, to where the light comes from
uniform mat4 projectionMatrix;
uniform vec2 pictureSize;  // pixels
uniform float lift;        // metres above the surface

out vec4 sums;

// Inverse of octahedral() in layers.frag.
vec3 fromOctahedron(vec2 p) {
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  return normalize(n);
}

// depth  metres along the view
vec3 viewPosition(float depth) {
  vec2 ndc = 2.0 * gl_FragCoord.xy / pictureSize - 1.0;
  float w = -projectionMatrix[2][3] * depth + projectionMatrix[3][3];
  vec2 offset = vec2(projectionMatrix[2][0], projectionMatrix[2][1]) * -depth + projectionMatrix[3].xy;
  return vec3((ndc * w - offset) / vec2(projectionMatrix[0][0], projectionMatrix[1][1]), -depth);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 number = texelFetch(numberMap, at, 0);
  sums = texelFetch(sumMap, at, 0);
  if (number.x == 0.0) return;
  vec3 n = fromOctahedron(number.zw);
  vec4 point = vec4(viewPosition(texelFetch(placeMap, at, 0).a) + n * lift, 1.0);
  float weight;
#repeat MAPS
  weight = max(dot(n, direction[INDEX]), 0.0);
  if (weight > 0.0) {
    sums.x += weight * texture(depthMap[INDEX], (toMap[INDEX] * point).xyz);
    sums.y += weight;
  }
#end
}
