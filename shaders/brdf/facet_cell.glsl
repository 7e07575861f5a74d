// A place of a polished relief about which the normal turns: its highlight from one light. Shared text: see README.md.

// Highlight of a place: D V NoL of a GGX lobe whose normal turns evenly about n, less what bumpTerminator() takes, [1/sr]. Turns widen
// the lobe as slopes of that variance do.
// surface  unit, of the geometry      n  unit      alpha2  square of the width, (0, 1]
// across, down  by how much n turns from one side of the place to the other      v, l, h  unit
// src: Yan et al. 2016, "Position-Normal Distributions for Efficient Rendering of Specular Microstructure", for lobes that are as
//      wide as the normal turns; Olano & Baker 2010, "LEAN Mapping", for their widths
float facetCellLobe(vec3 surface, vec3 n, float alpha2, vec3 across, vec3 down, vec3 v, vec3 l, vec3 h) {
  float NoH = max(dot(n, h), 1.0e-2);
  vec3 slope = h / NoH - n;
  vec3 turnX = across - n * dot(n, across);
  vec3 turnY = down - n * dot(n, down);
  // alpha2 and the second moments of the parallelogram that the turns span: that of one side is a twelfth of its square, and a width
  // has twice the variance. Times 6, in the axes of the turns; (x, y) is the slope there, by least squares.
  float even = 6.0 * alpha2;
  float xx = dot(turnX, turnX) + even;
  float yy = dot(turnY, turnY) + even;
  float xy = dot(turnX, turnY);
  float determinant = max(xx * yy - xy * xy, pow2(even));
  float ofX = dot(turnX, slope);
  float ofY = dot(turnY, slope);
  float x = (yy * ofX - xy * ofY) / determinant;
  float y = (xx * ofY - xy * ofX) / determinant;
  float square = max(dot(slope, slope) - ofX * x - ofY * y, 0.0) / alpha2;
  float distribution = 6.0 * RECIPROCAL_PI * inversesqrt(determinant) / pow2((1.0 + square) * pow2(NoH));
  // Of the normals there, the one that mirrors best.
  vec3 m = normalize(n + turnX * clamp(x, -0.5, 0.5) + turnY * clamp(y, -0.5, 0.5));
  float lobe = distribution * V_SmithGGXCosine(sqrt(alpha2), saturate(dot(m, v)), saturate(dot(m, l)));
  return lobe * bumpTerminator(bumpAlpha2(surface, m), dot(surface, l));
}
