// Reads intermediate values of three's own shader: each term is written to a float target by a patched material.

/** GLSL expressions in main() of three's meshphysical shader, in the order in which to look for a difference. */
const TERMS = {
  normal: 'normal',
  nonPerturbedNormal: 'nonPerturbedNormal',
  viewDir: 'geometryViewDir',
  baseColor: 'diffuseColor.rgb',
  alpha: 'vec3(diffuseColor.a)',
  roughness: 'vec3(material.roughness)',
  geometryRoughness: 'vec3(geometryRoughness)',
  metalness: 'vec3(material.metalness)',
  NoV: 'vec3(saturate(dot(geometryNormal, geometryViewDir)))',
  dfg: 'vec3(material.dfg, 0.0)',
  irradiance: 'irradiance',
  iblIrradiance: 'iblIrradiance',
  radiance: 'radiance',
  directDiffuse: 'reflectedLight.directDiffuse',
  directSpecular: 'reflectedLight.directSpecular',
  indirectDiffuse: 'reflectedLight.indirectDiffuse',
  indirectSpecular: 'reflectedLight.indirectSpecular',
  emissive: 'totalEmissiveRadiance',
  outLinear: 'outgoingLight',
  fragCoord: 'vec3(gl_FragCoord.xyz)',
};

export const termNames = Object.keys(TERMS);

/**
 * @param {typeof import('three')} THREE
 * @param {{renderer: object, scene: object, camera: object}} prepared
 * @param {{shot: object, terms: string[] | null}} job
 * @returns {Generator<[string, Float32Array]>} By term: RGBA fp32 of the whole picture, bottom row first; 0 where nothing is.
 */
export function* measureTerms(THREE, { renderer, scene, camera }, { shot, terms }) {
  const { width, height } = shot.size;
  const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.FloatType, samples: 0 });
  scene.background = null;
  const materials = physicalMaterials(scene);
  for (const name of terms ?? termNames) {
    if (!(name in TERMS)) throw new Error(`no term ${name}: expected one of ${termNames.join(' ')}`);
    for (const material of materials) writeTerm(THREE, material, name);
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    const values = new Float32Array(width * height * 4);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, values);
    yield [name, values];
  }
  renderer.setRenderTarget(null);
  target.dispose();
}

function physicalMaterials(scene) {
  const found = new Set();
  scene.traverse((object) => {
    for (const material of [object.material ?? []].flat()) if (material.isMeshStandardMaterial) found.add(material);
  });
  return found;
}

function writeTerm(THREE, material, name) {
  material.blending = THREE.NoBlending; // values are read as written
  material.onBeforeCompile = (shader) => {
    const end = shader.fragmentShader.lastIndexOf('}');
    shader.fragmentShader = `${shader.fragmentShader.slice(0, end)}gl_FragColor = vec4(${TERMS[name]}, 1.0);\n}`;
  };
  material.customProgramCacheKey = () => `telar-term-${name}`;
  material.needsUpdate = true;
}
