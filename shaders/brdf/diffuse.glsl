// Diffuse lobes, before the cosine of the light. Shared text: see README.md.

// Lambert's lobe, [1/sr], linear Rec.709.
// diffuse  albedo, linear Rec.709 [0, 1]
// src: Lambert 1760, "Photometria"
vec3 Fd_Lambert(vec3 diffuse) {
  return RECIPROCAL_PI * diffuse;
}
