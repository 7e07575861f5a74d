// Reads intermediate values of three's own shaders: a patched material writes one of them to a float target.

/** GLSL expressions in main() of three's shaders, by kind of material. */
const COLORED = {
  baseColor: 'diffuseColor.rgb',
  alpha: 'vec3(diffuseColor.a)',
  linear: 'outgoingLight',
  encoded: 'gl_FragColor.rgb',
};

/** MeshStandardMaterial and MeshPhysicalMaterial. */
const LIT = {
  ...COLORED,
  n: 'normal',
  metallic: 'vec3(material.metalness)',
  perceptualRoughness: 'vec3(material.roughness)',
  f0: 'material.specularColorBlended',
  NoV: 'vec3(dotNVms)',
  dfg: 'vec3(material.dfg, 0.0)',
  radiance: 'radiance',
  irradiance: 'irradiance + iblIrradiance',
  direct: 'telarDirect',
  indirect: 'telarIndirect',
  transmitted: 'transmitted.rgb',
  directDiffuse: 'reflectedLight.directDiffuse',
  directSpecular: 'reflectedLight.directSpecular',
  indirectDiffuse: 'reflectedLight.indirectDiffuse',
  indirectSpecular: 'reflectedLight.indirectSpecular',
  geometryNormal: 'nonPerturbedNormal',
  viewDirection: 'geometryViewDir',
  emitted: 'totalEmissiveRadiance',
};

/** Materials that telar's own text shades (js/three/shading/main.glsl). */
const SHADED = {
  ...COLORED,
  n: 'telarSurface.n',
  metallic: 'vec3(telarSurface.metallic)',
  perceptualRoughness: 'vec3(telarSurface.perceptualRoughness)',
  f0: 'telarSurface.f0',
  NoV: 'vec3(telarSurface.NoV)',
  dfg: 'vec3(telarSurface.dfg, 0.0)',
  radiance: 'telarIncident.radiance',
  irradiance: 'telarIncident.irradiance + telarIncident.environmentIrradiance',
  direct: 'telarDirectSum',
  indirect: 'telarIndirectSum',
  transmitted: 'transmitted.rgb',
  viewDirection: 'telarSurface.v',
  emitted: 'totalEmissiveRadiance',
};

/** The same for cloth, which has a table of its own in place of three's. */
const CLOTH = { ...SHADED, dfg: 'vec3(telarSurface.albedo.base, 0.0)' };

const SHADED_SUMS = `
vec3 telarDirectSum = telarDirect.diffuse + telarDirect.specular;
vec3 telarIndirectSum = telarIndirect.diffuse + telarIndirect.specular;
#ifdef USE_SHEEN
telarDirectSum += telarDirect.sheen;
telarIndirectSum += telarIndirect.sheen;
#endif
#ifdef USE_CLEARCOAT
telarDirectSum += telarDirect.coat * telarSurface.clearcoat;
telarIndirectSum += telarIndirect.coat * telarSurface.clearcoat;
#endif
`;

/** Sums over the layers, whose variables exist only where the material has the layer. */
const SUMS = `
vec3 telarDirect = reflectedLight.directDiffuse + reflectedLight.directSpecular;
vec3 telarIndirect = reflectedLight.indirectDiffuse + reflectedLight.indirectSpecular;
#ifdef USE_SHEEN
telarDirect += sheenSpecularDirect;
telarIndirect += sheenSpecularIndirect;
#endif
#ifdef USE_CLEARCOAT
telarDirect += clearcoatSpecularDirect * material.clearcoat;
telarIndirect += clearcoatSpecularIndirect * material.clearcoat;
#endif
`;

const SUMS_OF = new Map([
  [LIT, SUMS],
  [SHADED, SHADED_SUMS],
  [CLOTH, SHADED_SUMS],
]);

/** Define without which three's shader has no such variable. */
const NEEDS = { transmitted: 'USE_TRANSMISSION' };

const termNames = Object.keys(LIT);

/**
 * @param {typeof import('three')} THREE
 * @param {{renderer: object, scene: object, camera: object}} prepared
 * @param {object} job
 * @param {object} job.shot
 * @param {string[] | null} job.terms - Names, or null for all.
 * @param {{x: number, y: number, width: number, height: number} | undefined} job.region - Part to read, from the bottom
 *   left; the whole picture where it is left out.
 * @returns {Generator<[string, Float32Array]>} By term: RGBA fp32, bottom row first; alpha 1 where the material has the
 *   term, else all 0.
 */
export function* measureTerms(THREE, { renderer, scene, camera }, { shot, terms, region }) {
  const { x, y, width, height } = { x: 0, y: 0, ...shot.size, ...region };
  const target = new THREE.WebGLRenderTarget(shot.size.width, shot.size.height, { type: THREE.FloatType, samples: 0 });
  // three compiles tone mapping and sRGB encoding for such a target as for the canvas.
  target.isXRRenderTarget = true;
  target.texture.colorSpace = renderer.outputColorSpace;
  if (region) {
    // What is not read is not shaded.
    target.scissor.set(x, y, width, height);
    target.scissorTest = true;
  }
  const choice = { value: 0 };
  let wanted = 0;
  // What is drawn behind a transmissive surface, into a target of three's own, stays as it is.
  writeTerms(scene, choice, () => (choice.value = renderer.getRenderTarget() === target ? wanted : -1));
  const draw = (name) => {
    wanted = termNames.indexOf(name);
    if (wanted < 0) throw new Error(`no term ${name}: expected one of ${termNames.join(' ')}`);
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    const values = new Float32Array(width * height * 4);
    renderer.readRenderTargetPixels(target, x, y, width, height, values);
    return values;
  };
  // The ground that catches shadows has none of these terms.
  scene.traverse((object) => {
    if (object.material?.isShadowMaterial) object.visible = false;
  });
  // The background stays, for the surfaces that let it through, but is no surface itself.
  const { background } = scene;
  scene.background = null;
  const model = background ? draw('alpha') : null;
  scene.background = background;
  for (const name of terms ?? termNames) {
    const values = draw(name);
    yield [name, model ? values.map((value, i) => (model[i | 3] === 1 ? value : 0)) : values];
  }
  renderer.setRenderTarget(null);
  target.dispose();
}

/** Makes every material of a scene write the term whose position `choice.value` holds, its own colour where that is -1. */
function writeTerms(scene, choice, beforeDraw) {
  const materials = new Set();
  scene.traverse((object) => {
    if (!object.material) return;
    for (const material of [object.material].flat()) materials.add(material);
    const before = object.onBeforeRender;
    object.onBeforeRender = (...args) => {
      before.apply(object, args);
      beforeDraw();
    };
  });
  for (const material of materials) patch(material, choice);
}

function expressionsOf(material) {
  if (material.isTelarShadingMaterial) return material.isFabricMaterial ? CLOTH : SHADED;
  if (material.isMeshStandardMaterial) return LIT;
  if (material.isMeshBasicMaterial || material.isPointsMaterial || material.isLineBasicMaterial) return COLORED;
  return null;
}

function patch(material, choice) {
  const expressions = expressionsOf(material);
  if (!expressions) {
    material.visible = false; // a ground that only catches shadows
    return;
  }
  const writes = termNames
    .filter((name) => expressions[name])
    .map((name) => {
      const write = `if (telarTerm == ${termNames.indexOf(name)}) telarValue = vec4(${expressions[name]}, 1.0);\n`;
      return NEEDS[name] ? `#ifdef ${NEEDS[name]}\n${write}#endif\n` : write;
    })
    .join('');
  const before = material.onBeforeCompile;
  material.onBeforeCompile = (shader, renderer) => {
    before.call(material, shader, renderer);
    shader.uniforms.telarTerm = choice;
    const end = shader.fragmentShader.lastIndexOf('}');
    shader.fragmentShader = `uniform int telarTerm;\n${shader.fragmentShader.slice(0, end)}
if (telarTerm >= 0) {\n${SUMS_OF.get(expressions) ?? ''}vec4 telarValue = vec4(0.0);\n${writes}gl_FragColor = telarValue;\n}\n}`;
  };
  const key = material.customProgramCacheKey();
  material.customProgramCacheKey = () => `telar-terms ${key}`;
  material.needsUpdate = true;
}
