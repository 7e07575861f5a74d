// What a shader of three.js has under another name than shaders/: the tables by which js/build/shading translates.

/** Features that telar's text leaves to three.js, or that are always so there. */
export const FIXED = {
  UNLIT: 0, ALPHA_MASK: 0, ALPHA_OPAQUE: 0, BASE_COLOR_MAP: 0, VERTEX_COLOR: 0, EMISSIVE: 0, EMISSIVE_MAP: 0, TRANSMISSION: 0,
  TRANSMISSION_MAP: 0, THICKNESS_MAP: 0, VOLUME: 0, ATTENUATION: 0, DISPERSION: 0, ORTHOGRAPHIC: 0, AMBIENT: 1, DEBUG_OUTPUT: 0, OUTPUT_LINEAR: 0,
  ALL_TERMS: 0, SAMPLE_MASK: 0, FULL_DETAIL: 0, ENVIRONMENT_SAMPLES: 0, DISK_LIGHTS: 0,
  POINT_LIGHTS: 0, SPOT_LIGHTS: 0, DIRECTIONAL_LIGHTS: 0, CUBE_SHADOWS: 0, SPOT_SHADOWS: 0, FLAT_SHADOWS: 0,
};

/** Features of cloth, and the families of shadings that have them. */
export const OF_CLOTH = {
  NORMAL_VARIANCE: ['fabric'],
  ALPHA_TO_COVERAGE: ['fabric'],
  WEAVE: ['fabric'],
  WEAVE_MAP: ['fabric'],
  BACK: ['fabric'],
  BACK_COLOR_MAP: ['fabric'],
  FLATNESS: ['fabric', 'principled'],
  DIFFUSE_TRANSMISSION: ['fabric', 'principled'],
  DIFFUSE_TRANSMISSION_MAP: ['fabric', 'principled'],
  DIFFUSE_TRANSMISSION_COLOR_MAP: ['fabric', 'principled'],
};

/** Feature of surface.frag: the condition under which three.js has it, as its preprocessor knows it. */
export const FEATURES = {
  FLAT_SHADED: 'defined(FLAT_SHADED)',
  DOUBLE_SIDED: 'defined(DOUBLE_SIDED)',
  FLIP_SIDED: 'defined(FLIP_SIDED)',
  TANGENT: 'defined(USE_TANGENT)',
  TANGENT_FRAME_UV0: 'defined(USE_ANISOTROPY) || defined(USE_UV)',
  METALLIC_ROUGHNESS_MAP: 'defined(USE_ROUGHNESSMAP) || defined(USE_METALNESSMAP)',
  NORMAL_MAP: 'defined(USE_NORMALMAP_TANGENTSPACE)',
  OCCLUSION_MAP: 'defined(USE_AOMAP)',
  SPECULAR: 'defined(USE_SPECULAR)',
  SPECULAR_MAP: 'defined(USE_SPECULAR_INTENSITYMAP)',
  SPECULAR_COLOR_MAP: 'defined(USE_SPECULAR_COLORMAP)',
  CLEARCOAT: 'defined(USE_CLEARCOAT)',
  CLEARCOAT_MAP: 'defined(USE_CLEARCOATMAP)',
  CLEARCOAT_ROUGHNESS_MAP: 'defined(USE_CLEARCOAT_ROUGHNESSMAP)',
  CLEARCOAT_NORMAL_MAP: 'defined(USE_CLEARCOAT_NORMALMAP)',
  SHEEN: 'defined(USE_SHEEN)',
  SHEEN_COLOR_MAP: 'defined(USE_SHEEN_COLORMAP)',
  SHEEN_ROUGHNESS_MAP: 'defined(USE_SHEEN_ROUGHNESSMAP)',
  ANISOTROPY: 'defined(USE_ANISOTROPY)',
  ANISOTROPY_MAP: 'defined(USE_ANISOTROPYMAP)',
  IRIDESCENCE: 'defined(USE_IRIDESCENCE)',
  IRIDESCENCE_MAP: 'defined(USE_IRIDESCENCEMAP)',
  IRIDESCENCE_THICKNESS_MAP: 'defined(USE_IRIDESCENCE_THICKNESSMAP)',
  DIFFUSE_ROUGHNESS: 'defined(USE_DIFFUSE_ROUGHNESS)',
  DIFFUSE_ROUGHNESS_MAP: 'defined(USE_DIFFUSE_ROUGHNESSMAP)',
  ENVIRONMENT: 'defined(USE_ENVMAP) && defined(ENVMAP_TYPE_PMREM)',
};

/** Counts: three.js writes numbers in place of its own names. */
export const COUNTS = { HEMISPHERE_LIGHTS: 'NUM_HEMI_LIGHTS', RECT_LIGHTS: 'NUM_RECT_AREA_LIGHTS' };

/** Uniform or varying of shaders/: what stands for it in three.js. Its declaration is left out. */
export const INPUTS = {
  baseColorFactor: 'vec4(diffuse, opacity)',
  alphaCutoff: 'alphaTest',
  baseColorMap: 'telar_coverageMap', // the cut-out cloth's; other base colours are read by three.js
  vBaseColorUv: 'vMapUv',
  metallicRoughnessMap: 'roughnessMap',
  vMetallicRoughnessUv: 'vRoughnessMapUv',
  metallicFactor: 'metalness',
  roughnessFactor: 'roughness',
  emissiveFactor: 'emissive',
  occlusionMap: 'aoMap',
  occlusionStrength: 'aoMapIntensity',
  vOcclusionUv: 'vAoMapUv',
  normalMap: 'normalMap',
  normalScale: 'normalScale',
  vNormalUv: 'vNormalMapUv',
  vUv0: 'vUv',
  vViewPosition: 'vViewPosition',
  vNormal: 'vNormal',
  vTangent: 'vTangent',
  vBitangent: 'vBitangent',
  ior: 'ior',
  specularFactor: 'specularIntensity',
  specularColorFactor: 'specularColor',
  specularMap: 'specularIntensityMap',
  vSpecularUv: 'vSpecularIntensityMapUv',
  specularColorMap: 'specularColorMap',
  vSpecularColorUv: 'vSpecularColorMapUv',
  clearcoatFactor: 'clearcoat',
  clearcoatMap: 'clearcoatMap',
  vClearcoatUv: 'vClearcoatMapUv',
  clearcoatRoughnessFactor: 'clearcoatRoughness',
  clearcoatRoughnessMap: 'clearcoatRoughnessMap',
  vClearcoatRoughnessUv: 'vClearcoatRoughnessMapUv',
  clearcoatNormalMap: 'clearcoatNormalMap',
  clearcoatNormalScale: 'clearcoatNormalScale',
  vClearcoatNormalUv: 'vClearcoatNormalMapUv',
  sheenColorFactor: 'sheenColor',
  sheenColorMap: 'sheenColorMap',
  vSheenColorUv: 'vSheenColorMapUv',
  sheenRoughnessFactor: 'sheenRoughness',
  sheenRoughnessMap: 'sheenRoughnessMap',
  vSheenRoughnessUv: 'vSheenRoughnessMapUv',
  anisotropyVector: 'anisotropyVector',
  anisotropyMap: 'anisotropyMap',
  vAnisotropyUv: 'vAnisotropyMapUv',
  iridescenceFactor: 'iridescence',
  iridescenceMap: 'iridescenceMap',
  vIridescenceUv: 'vIridescenceMapUv',
  iridescenceIor: 'iridescenceIOR',
  iridescenceThickness: 'vec2(iridescenceThicknessMinimum, iridescenceThicknessMaximum)',
  iridescenceThicknessMap: 'iridescenceThicknessMap',
  vIridescenceThicknessUv: 'vIridescenceThicknessMapUv',
  diffuseRoughnessFactor: 'diffuseRoughness',
  diffuseRoughnessMap: 'diffuseRoughnessMap',
  vDiffuseRoughnessUv: 'vDiffuseRoughnessMapUv',
  dfgMap: 'dfgLUT',
  viewMatrix: 'viewMatrix',
  ambientIrradiance: 'ambientLightColor',
  environmentMap: 'envMap',
  environmentMaxLod: 'float(ENVMAP_MAX_LOD)',
  environmentIntensity: 'envMapIntensity',
  environmentRotation: 'envMapRotation',
  ltcInverseMap: 'ltc_1',
  ltcAlbedoMap: 'ltc_2',
};

/** Array of shaders/: [array of structs of three.js, member]. */
export const ARRAYS = {
  hemisphereUp: ['hemisphereLights', 'direction'],
  hemisphereSky: ['hemisphereLights', 'skyColor'],
  hemisphereGround: ['hemisphereLights', 'groundColor'],
  rectPosition: ['rectAreaLights', 'position'],
  rectHalfWidth: ['rectAreaLights', 'halfWidth'],
  rectHalfHeight: ['rectAreaLights', 'halfHeight'],
  rectColor: ['rectAreaLights', 'color'],
};

/** Expressions that read what three.js holds in another form; each stands in the text. */
export const EXPRESSIONS = {
  'texture(metallicRoughnessMap, vMetallicRoughnessUv)': 'metallicRoughnessTexel()',
  'texture(normalMap, vNormalUv).xyz': 'normalTexel()',
  'return normalize(vViewPosition);': 'return isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(vViewPosition);',
};

/** The same of cloth alone: maps made anew by js/three/shading/texture_bake.mjs, and samples that are covered in turn. */
export const CLOTH_EXPRESSIONS = {
  'vec4 varied = texture(normalMap, vNormalUv);': 'vec4 varied = texture(normalVarianceMap, vNormalUv);',
  'vec4 variedCoat = texture(clearcoatNormalMap, vClearcoatNormalUv);': 'vec4 variedCoat = texture(clearcoatNormalVarianceMap, vClearcoatNormalUv);',
  'const int coverageSamples = 1;': '',
  'if (mask == 0) discard;': 'if (mask == 0 || mask != coverageMask) discard;',
};

/** Files of shaders/ that three.js has its own of. */
export const LEFT_OUT = [
  'brdf/tone_mapping.glsl', 'brdf/color.glsl', 'output.glsl', 'debug_output.glsl', 'shadow/filter.glsl',
  'brdf/transmission.glsl', 'light/punctual.glsl', 'light/transmission.glsl',
];
