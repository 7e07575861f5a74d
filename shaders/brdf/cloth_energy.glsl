// How much light a GGX lobe sends back, in closed form, so that what it leaves can be given to the lobes below.
// Shared text: see README.md. Fitted by test/fits to the exact integrals; both sides of every lobe use the same curve,
// so that coupling stays reciprocal whatever the fit's error.

// Curves of one roughness.   perceptualRoughness  [PERCEPTUAL_ROUGHNESS_MIN, 1]
GlossCurve glossCurve(float perceptualRoughness) {
  float r = perceptualRoughness;
  float r2 = r * r;
  float m0 = 0.06518462 + r * (1.494943 + r * (-4.359943 + r * 6.610314));
  float m1 = -1.440055 + r * (6.777599 + r * (-13.48625 + r * 10.3631));
  float k0 = 0.05953027 + r * (2.367656 - r * 1.430093);
  float k1 = -0.001245756 + r * (-0.1251754 + r * 2.7079);
  float n1 = 0.3086852 + r * (-1.087755 - r * 1.810349);
  float q0 = 0.6575425 + r * (2.926053 - r * 2.101567);
  float q1 = 0.7249064 + r * (-0.9762387 - r * 5.999367);
  float q2 = 2.954265 + r * (-9.954358 + r * 16.31452);
  float missing = 0.005586504 + r * (-0.1913906 + r * (0.934524 + r * (-2.006923 + r * (6.663561 + r * (-7.620988 + r * 2.800668)))));
  float grazing = 0.03786439 + r * (0.2786931 + r * (-0.7742853 + r * (-1.523518 + r * (6.466171 + r * (-6.921042 + r * 2.440246)))));
  return GlossCurve(vec4(r2 * m0, r2 * m1, r2 * r * pow2(k0), r * pow2(k1)), vec4(pow2(n1), 1.0 + r * pow2(q0), pow2(q1), pow2(q2)),
                    vec2(max(missing, 0.001), grazing));
}

// x: share of light of this direction that a lobe of f0 = f90 = 1 does not reflect at once; y: share of its albedo that
// belongs to f90. The albedo is f0 (1 - x - y) + f90 y; each [0, 1].
// cosine  [0, 1]
vec2 glossAlbedo(GlossCurve curve, float cosine) {
  float missing = cosine * (curve.missing.x + curve.missing.y * cosine) / (curve.missing.z + cosine * (curve.missing.w + cosine));
  float root = (1.0 - cosine) * (1.0 + curve.grazing.x * cosine) / (curve.grazing.y + cosine * (curve.grazing.z + cosine * curve.grazing.w));
  return vec2(max(missing, 0.0), pow2(root));
}

// Share of the light that leaves after two and more bounces between the microfacets, of all that does not after one.
// f0, f90  [0, 1]      averageMissing  of a GlossCurve
// src: Kulla & Conty 2017, "Revisiting Physically Based Shading at Imageworks", with the first bounce's colour as in Hill
//      2018, "A Multi-Faceted Exploration (Part 2)"
vec3 returningShare(vec3 f0, float f90, float averageMissing) {
  vec3 average = f0 + (f90 - f0) * (1.0 / 21.0);
  return average * average * (1.0 - averageMissing) / (1.0 - average * averageMissing);
}

// Whole albedo of a rough interface, linear Rec.709, [0, 1].
// albedo  of glossAlbedo()      returning  of returningShare()
vec3 interfaceAlbedo(vec3 f0, float f90, vec3 returning, vec2 albedo) {
  return f0 * (1.0 - albedo.x - albedo.y) + f90 * albedo.y + returning * albedo.x;
}
