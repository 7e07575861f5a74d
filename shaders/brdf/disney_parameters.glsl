// glTF's parameters as those of the principled model of 2012. Shared text: see README.md.
// What has no row here is the same in both: base colour, metalness, roughness, weight of the coat.

// How much of the hue of `color` is that of the base colour, [0, 1]: the tint in [1, tint of the base] that is nearest to it.
// color, baseColor  linear Rec.709
float tintAmountDisney(vec3 color, vec3 baseColor) {
  vec3 axis = tintDisney(baseColor) - 1.0;
  float length2 = dot(axis, axis);
  return length2 > 1.0e-6 ? saturate(dot(tintDisney(color) - 1.0, axis) / length2) : 0.0;
}

// Normal reflectance, linear Rec.709: the brightness of the dielectric's is kept up to 0.08, its hue as far as a tint goes.
// f0Dielectric  of KHR_materials_ior and KHR_materials_specular, linear Rec.709
vec3 specularF0FromGltf(vec3 baseColor, float metallic, vec3 f0Dielectric) {
  float specular = saturate(luminanceDisney(f0Dielectric) / 0.08);
  return specularF0Disney(baseColor, metallic, specular, tintAmountDisney(f0Dielectric, baseColor));
}

// Sheen times its tint, linear Rec.709: the brightness of the colour is kept, its hue as far as a tint goes.
// sheenColor  of KHR_materials_sheen, linear Rec.709
vec3 sheenFromGltf(vec3 baseColor, vec3 sheenColor) {
  return Fr_SheenDisney(baseColor, luminanceDisney(sheenColor), tintAmountDisney(sheenColor, baseColor), 0.0);
}

// anisotropic, [0, 1], with which the highlight is as many times longer than wide as glTF's, up to 10 times. Disney's
// keeps its area, where glTF's grows with its length.
// perceptualRoughness  [0, 1]      strength  of KHR_materials_anisotropy [0, 1]
float anisotropicFromGltf(float perceptualRoughness, float strength) {
  float alpha = max(pow2(perceptualRoughness), 0.001);
  float alphaT = mix(alpha, 1.0, pow2(strength));
  return min((1.0 - alpha / alphaT) / 0.9, 1.0);
}

// gloss, [0, 1], of the coat whose width is nearest to that of KHR_materials_clearcoat: Disney's goes from 0.001 to 0.1.
// perceptualRoughness  of the coat [0, 1]
float glossFromGltf(float perceptualRoughness) {
  return saturate((0.1 - pow2(perceptualRoughness)) / 0.099);
}
