// Small algebra. Shared text: see README.md.

// return x^2
float pow2(float x) { return x * x; }

// return x^4, as the square of the square. three r187
float pow4(float x) {
  float x2 = x * x;
  return x2 * x2;
}

// return the largest component
float max3(vec3 v) { return max(max(v.x, v.y), v.z); }

// return the smallest component
float min3(vec3 v) { return min(v.x, min(v.y, v.z)); }

// return x held in [0, 1]
float saturate(float x) { return clamp(x, 0.0, 1.0); }

// return each component held in [0, 1]
vec3 saturate(vec3 v) { return clamp(v, 0.0, 1.0); }

// return x / |x|, or `fallback` where x has no direction
vec3 safeNormalize(vec3 x, vec3 fallback) {
  float squaredLength = dot(x, x);
  return squaredLength > 1.0e-30 ? x * inversesqrt(squaredLength) : fallback;
}

// Some unit direction square with unit n.
vec3 anyTangent(vec3 n) {
  return normalize(abs(n.x) < 0.7 ? cross(n, vec3(1.0, 0.0, 0.0)) : cross(n, vec3(0.0, 1.0, 0.0)));
}

// Two axes that are square with unit n: columns x, y, n.
// src: Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1)
mat3 basisAbout(vec3 n) {
  float side = n.z < 0.0 ? -1.0 : 1.0;
  float a = -1.0 / (side + n.z);
  float b = n.x * n.y * a;
  return mat3(vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x), vec3(b, side + n.y * n.y * a, -n.y), n);
}
