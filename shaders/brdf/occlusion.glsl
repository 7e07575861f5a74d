// Baked ambient occlusion, for indirect light only. Shared text: see README.md.

// Factor on indirect diffuse light, [0, 1].
// texel  [0, 1]  occlusion texture, R      strength  [0, 1]
// src: Khronos glTF 2.0 specification, section 3.9.3; order of three r187
float diffuseOcclusion(float texel, float strength) {
  return (texel - 1.0) * strength + 1.0;
}

// Factor on indirect specular light, [0, 1].
// perceptualRoughness  [0, 1]      occlusion  [0, 1]  diffuseOcclusion()      NoV  [0, 1]
// src: Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering 3.0", listing 26; order of three r187
float specularOcclusion(float perceptualRoughness, float occlusion, float NoV) {
  return saturate(pow(NoV + occlusion, exp2(-16.0 * perceptualRoughness - 1.0)) - 1.0 + occlusion);
}
