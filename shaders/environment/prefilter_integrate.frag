// GGX lobe of one roughness at v = n by summing every texel of a small source level, for the rough levels of the cube.
// Opposite texels are paired: only the one in the hemisphere of n counts.
// src: weights from Walter et al. 2007, eq. 33, with NoH^2 = (1 + NoL) / 2 at v = n; order of three r187
precision highp float;
precision highp int;
precision highp samplerCube;

uniform samplerCube sourceMap;
uniform float perceptualRoughness;
uniform float sourceLod;
uniform int sourceSize;  // texels on an edge; a uniform so that the loops stay loops
in vec3 vDirection;
out vec4 fragmentColor;

void main() {
  vec3 n = normalize(vDirection);
  float alpha = perceptualRoughness * perceptualRoughness;
  float a2 = alpha * alpha;
  float texelSize = 2.0 / float(sourceSize);
  vec3 sum = vec3(0.0);
  float weightSum = 0.0;
  for (int face = 0; face < 3; ++face) {
    for (int y = 0; y < sourceSize; ++y) {
      for (int x = 0; x < sourceSize; ++x) {
        vec2 uv = (vec2(x, y) + 0.5) * texelSize - 1.0;
        vec3 l = face == 0 ? vec3(1.0, uv) : (face == 1 ? vec3(uv.x, 1.0, uv.y) : vec3(uv, 1.0));
        float inverseDistance = inversesqrt(1.0 + dot(uv, uv));
        float NoL = dot(n, l);
        l *= NoL < 0.0 ? -1.0 : 1.0;
        NoL = abs(NoL) * inverseDistance;
        float d = 1.0 + a2 + (a2 - 1.0) * NoL;
        float weight = NoL * inverseDistance * inverseDistance * inverseDistance / (d * d);
        sum += textureLod(sourceMap, l, sourceLod).rgb * weight;
        weightSum += weight;
      }
    }
  }
  fragmentColor = vec4(sum / weightSum, 1.0);
}
