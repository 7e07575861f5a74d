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
 * @param {{shot: object, pixels: [number, number][], terms: string[] | null}} job - Pixels count from the top row.
 * @returns {Record<string, number[][]>} By term, one [r, g, b, a] per pixel; null where no physical material was drawn.
 */
export function measureTerms(THREE, { renderer, scene, camera }, { shot, pixels, terms }) {
  const { width, height } = shot.size;
  const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.FloatType, samples: 0 });
  scene.background = null;
  const materials = physicalMaterials(scene);
  const result = {};
  for (const name of terms ?? termNames) {
    if (!(name in TERMS)) throw new Error(`no term ${name}: expected one of ${termNames.join(' ')}`);
    for (const material of materials) writeTerm(material, name);
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    result[name] = pixels.map(([x, y]) => readPixel(renderer, target, x, height - 1 - y));
  }
  renderer.setRenderTarget(null);
  target.dispose();
  return result;
}

function physicalMaterials(scene) {
  const found = new Set();
  scene.traverse((object) => {
    for (const material of [object.material ?? []].flat()) if (material.isMeshStandardMaterial) found.add(material);
  });
  return found;
}

function writeTerm(material, name) {
  material.blending = 0; // NoBlending: values are read as written
  material.onBeforeCompile = (shader) => {
    const end = shader.fragmentShader.lastIndexOf('}');
    // Without an environment, or for terms of a chunk that this material lacks, the variable does not exist.
    shader.fragmentShader = `${shader.fragmentShader.slice(0, end)}gl_FragColor = vec4(${TERMS[name]}, 1.0);\n}`;
  };
  material.customProgramCacheKey = () => `telar-term-${name}`;
  material.needsUpdate = true;
}

function readPixel(renderer, target, x, y) {
  const value = new Float32Array(4);
  renderer.readRenderTargetPixels(target, x, y, 1, 1, value);
  return Array.from(value);
}
