// Light from a polygon, by linearly transformed cosines: the lobe is the cosine lobe seen through a matrix, so that the
// polygon is brought into the space of the cosine, where its integral is known. Shared text: see README.md.
// src: Heitz, Dupuy, Hill & Neubelt 2016, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines"; order of
//      three r187

// Where the tables of 64 x 64 texels hold a GGX lobe: u by roughness, v by the angle of the viewer, [0.5/64, 63.5/64].
// perceptualRoughness, NoV  [0, 1]
vec2 ltcCoordinates(float perceptualRoughness, float NoV) {
  return vec2(perceptualRoughness, sqrt(1.0 - NoV)) * 0.984375 + 0.0078125;
}

// Matrix from the frame of ltcFrame to the space of the cosine.
// fit  texel of the first table: its four entries that are not 0 or 1
mat3 ltcInverse(vec4 fit) {
  return mat3(vec3(fit.x, 0.0, fit.y), vec3(0.0, 1.0, 0.0), vec3(fit.z, 0.0, fit.w));
}

// Rotation into the frame of the tables: the viewer in the plane of x and z, the normal along z.
// Seen head-on a lobe is round, and any x will do; three.js divides 0 by 0 there and loses the light.
// n, v  unit
mat3 ltcFrame(vec3 n, vec3 v) {
  vec3 across = v - n * dot(v, n);
  vec3 t = dot(across, across) > HEAD_ON_EPSILON ? safeNormalize(across, n) : anyTangent(n);
  return transpose(mat3(t, -cross(n, t), n));
}

// Part of the vector form factor of a polygon that one edge gives, [1/sr, a full sphere = 1].
// a, b  unit, to the ends of the edge
vec3 ltcEdge(vec3 a, vec3 b) {
  float x = dot(a, b);
  float y = abs(x);
  float numerator = 0.8543985 + (0.4965155 + 0.0145206 * y) * y;
  float denominator = 3.4175940 + (4.1616724 + y) * y;
  float angleOverSine = numerator / denominator;
  return cross(a, b) * (x > 0.0 ? angleOverSine : 0.5 * inversesqrt(max(1.0 - x * x, 1.0e-7)) - angleOverSine);
}

// Form factor, [0, 1], of what of a polygon is above the horizon z = 0, from its vector form factor: that of a sphere
// with the same one.
// src: Hill & Heitz 2016, "Real-Time Area Lighting: a Journey from Research to Production", p. 102
float ltcAboveHorizon(vec3 f) {
  float l = length(f);
  return max((l * l + f.z) / (l + 1.0), 0.0);
}

// Share of the lobe that a rectangle fills, [0, 1].
// toLobe  ltcInverse * ltcFrame, or ltcFrame for the cosine itself
// a, b, c, d  corners as seen from the shaded point, in the order in which they lie around the side that shines
float ltcRectangle(mat3 toLobe, vec3 a, vec3 b, vec3 c, vec3 d) {
  vec3 up = vec3(0.0, 0.0, 1.0);
  vec3 u = safeNormalize(toLobe * a, up);
  vec3 v = safeNormalize(toLobe * b, up);
  vec3 w = safeNormalize(toLobe * c, up);
  vec3 x = safeNormalize(toLobe * d, up);
  vec3 sum = ltcEdge(u, v);
  sum += ltcEdge(v, w);
  sum += ltcEdge(w, x);
  sum += ltcEdge(x, u);
  return ltcAboveHorizon(sum);
}

// Share of the lobe that a disk fills, [0, 1]: by an octagon of the same area, whose error is below that of the lobe's fit.
// centre  as seen from the shaded point      x, y  from the centre to the rim, square with each other; it shines towards cross(y, x)
float ltcDisk(mat3 toLobe, vec3 centre, vec3 x, vec3 y) {
  vec3 c = toLobe * centre;
  vec3 ax = toLobe * x * 0.97368914;
  vec3 bx = toLobe * x * 0.40331525;
  vec3 ay = toLobe * y * 0.97368914;
  vec3 by = toLobe * y * 0.40331525;
  vec3 up = vec3(0.0, 0.0, 1.0);
  vec3 p0 = safeNormalize(c + ax + by, up);
  vec3 p1 = safeNormalize(c + ax - by, up);
  vec3 p2 = safeNormalize(c + bx - ay, up);
  vec3 p3 = safeNormalize(c - bx - ay, up);
  vec3 p4 = safeNormalize(c - ax - by, up);
  vec3 p5 = safeNormalize(c - ax + by, up);
  vec3 p6 = safeNormalize(c - bx + ay, up);
  vec3 p7 = safeNormalize(c + bx + ay, up);
  vec3 sum = ltcEdge(p0, p1) + ltcEdge(p1, p2) + ltcEdge(p2, p3) + ltcEdge(p3, p4);
  sum += ltcEdge(p4, p5) + ltcEdge(p5, p6) + ltcEdge(p6, p7) + ltcEdge(p7, p0);
  return ltcAboveHorizon(sum);
}

// Albedo of a GGX lobe with Schlick's Fresnel, linear Rec.709.
// scaleAndBias  texel of the second table
// src: Hill & Heitz 2016, as above
vec3 ltcAlbedo(vec3 f0, float f90, vec2 scaleAndBias) {
  return f0 * scaleAndBias.x + (f90 - f0) * scaleAndBias.y;
}
