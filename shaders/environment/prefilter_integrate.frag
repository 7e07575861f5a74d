// The same as prefilter_sample.frag by quadrature, for the rough levels of the cube: every texel of a small level of the
// source counts by what a GGX mirror reflects of it.
// src: Karis 2013, "Real Shading in Unreal Engine 4", the first half of the split sum; Walter et al. 2007, "Microfacet Models
//      for Refraction through Rough Surfaces", eq. 33. The order of the sum is that of three r187.
precision highp float;
precision highp int;
precision highp samplerCube;

uniform samplerCube sourceMap;
uniform float perceptualRoughness;
uniform float sourceLod;
uniform int sourceSize;  // texels on an edge; a uniform so that the loops stay loops
in vec3 vDirection;
out vec4 fragmentColor;

// A point of the face +x, +y or +z of the cube [-1, 1]^3.
vec3 onFace(int face, vec2 st) {
  vec3 p = vec3(st, 1.0);
  return face == 2 ? p : face == 1 ? p.xzy : p.zxy;
}

// Weight of a texel, up to a factor that all texels share. The half vector of n and l has NoH^2 = (1 + NoL) / 2, so D of GGX is
// proportional to 1 / d^2. The solid angle of a texel is proportional to nearness^3.
// nearness  1 / distance of the texel from the centre of the cube
float weightOf(float NoL, float nearness, float alpha2) {
  float d = 1.0 + alpha2 + (alpha2 - 1.0) * NoL;
  return NoL * nearness * nearness * nearness / (d * d);
}

void main() {
  vec3 n = normalize(vDirection);
  float alpha = perceptualRoughness * perceptualRoughness;
  float pitch = 2.0 / float(sourceSize);
  vec4 sum = vec4(0.0);  // weighted radiance, weights
  for (int face = 0; face < 3; ++face) {
    for (int row = 0; row < sourceSize; ++row) {
      for (int column = 0; column < sourceSize; ++column) {
        vec2 st = (vec2(column, row) + 0.5) * pitch - 1.0;
        vec3 p = onFace(face, st);
        float facing = dot(n, p);
        // p and -p are texels of opposite faces. One of them lies in front.
        vec3 seen = facing < 0.0 ? -p : p;
        float nearness = inversesqrt(1.0 + dot(st, st));
        float weight = weightOf(abs(facing) * nearness, nearness, alpha * alpha);
        sum += vec4(textureLod(sourceMap, seen, sourceLod).rgb * weight, weight);
      }
    }
  }
  fragmentColor = vec4(sum.rgb / sum.a, 1.0);
}
