import { featureDefines } from './terms.mjs';

/** What was made of a texture, for each renderer's `properties`: it lives on its GL, and three.js makes others when a lost context is back. */
const made = new WeakMap();

/** Of each kind, what is kept of one texture: cutoffs that a fade goes through are many. */
const MOST = 16;

/** Type of the texels that are made: as renderer/pass/texture/texture_bake has them. */
const TEXEL_TYPES = { relief: 'HalfFloatType', facets: 'HalfFloatType', yarns: 'HalfFloatType', coverage: 'UnsignedByteType', metal: 'UnsignedByteType' };

/** Level of the source that is level 0 of what is made, where it is not the first: as renderer/pass/texture/texture_bake has it. */
const FIRST_LEVELS = { yarns: 2 };

/** Programs and the triangle that they are drawn with, for each three.js module. */
const drawings = new WeakMap();

/**
 * Makes textures whose mip levels keep what plain averages of texels lose, by the shaders that the server runs
 * (shaders/texture). Kept as long as the texture; made anew where it was changed.
 * @param {typeof import('three')} THREE
 * @param {Record<string, string>} shaders - Module js/dist/shading/texture.mjs.
 * @param {import('three').WebGLRenderer} renderer - Which is not drawing into the texture; its target is put back.
 * @param {'relief' | 'facets' | 'yarns' | 'coverage' | 'metal'} kind
 *   - relief: of a normal map, RGB the mean of its unit normals, A that of how flat they lie.
 *   - facets: of a polished normal map, RG the slopes of its flat part and A their square, each times B, its share.
 *   - yarns: of a normal map, how flat warp and weft lie, along and across them.
 *   - coverage: of a colour map with holes, A the share of the texel that is there; RGB times A where it is blended.
 *   - metal: of a colour map, RGB the colour times metalness, A metalness times the share of the warp.
 * @param {import('three').Texture} source
 * @param {object} [other]
 * @param {number} [other.cutoff] - Alpha from which on a texel is there; 0 = alpha is the share that is there.
 * @param {import('three').Texture} [other.beside] - relief: of a material with holes, the map of that alpha; metal: the map of metalness; yarns: the weave map.
 * @param {import('three').Texture} [other.yarns] - metal: of a woven material, the weave map.
 * @returns {import('three').Texture | null} With the source's sampler; null while the source has no image.
 */
export function bakedTexture(THREE, shaders, renderer, kind, source, { cutoff = 0, beside = null, yarns = null } = {}) {
  if (!source?.image?.width) return null;
  const others = [beside, yarns];
  const key = [kind, cutoff, ...others.map((texture) => texture?.uuid ?? '')].join(' ');
  const make = () => ({ kind, target: bake(THREE, shaders, renderer, { kind, source, cutoff, beside, yarns }) });
  return madeOnce(renderer, [source, ...others], key, make).target.texture;
}

/**
 * The direction across the lines that a normal map's relief runs along: the axis of reliefTowards() (shaders/brdf/relief.glsl) in its tangent space.
 * Parameters and how long it is kept: as bakedTexture().
 * @returns {import('three').Vector2} of length 0 where there are no lines, and where the GL gives no pixels
 */
export function reliefAxis(THREE, shaders, renderer, source) {
  if (!source?.image?.width) return new THREE.Vector2();
  return madeOnce(renderer, [source], 'axis', () => {
    const target = new THREE.WebGLRenderTarget(1, 1, { depthBuffer: false });
    const putBack = setAside(renderer);
    drawingOf(THREE, shaders).draw(renderer, 'reliefAxis', { BESIDE: 0 }, { sourceMap: source }, target, 0, { x: 1, y: 1 });
    const texel = new Uint8Array(4);
    renderer.readRenderTargetPixels(target, 0, 0, 1, 1, texel);
    putBack();
    target.dispose();
    const components = [256 * texel[0] + texel[1], 256 * texel[2] + texel[3]];
    return { axis: components.includes(0) ? new THREE.Vector2() : new THREE.Vector2(...components).subScalar(32768).divideScalar(32767) };
  }).axis;
}

/** What was made of a texture and of others for a renderer, with its target if it has one; made anew where one of them was changed. */
function madeOnce({ properties }, [source, ...others], key, make) {
  if (!made.has(properties)) made.set(properties, new WeakMap());
  const ofRenderer = made.get(properties);
  if (!ofRenderer.has(source)) {
    const all = new Map();
    ofRenderer.set(source, all);
    source.addEventListener('dispose', () => {
      for (const { target } of all.values()) target?.dispose();
      all.clear();
    });
  }
  const known = ofRenderer.get(source);
  const last = known.get(key);
  const versions = [source, ...others].map((texture) => texture?.version).join(' ');
  const isSame = last?.versions === versions;
  if (!isSame) last?.target?.dispose();
  const result = isSame ? last : { ...make(), versions };
  // Last in order: what was wanted longest ago goes first.
  known.delete(key);
  known.set(key, result);
  if (!isSame) forgetOldest(known, result.kind);
  return result;
}

/** Of a kind that has more than MOST. */
function forgetOldest(known, kind) {
  const alike = [...known].filter(([, result]) => result.kind === kind);
  for (const [key, { target }] of alike.slice(0, -MOST)) {
    target?.dispose();
    known.delete(key);
  }
}

function bake(THREE, shaders, renderer, { kind, source, cutoff, beside, yarns }) {
  const { width, height } = source.image;
  const levels = Math.floor(Math.log2(Math.max(width, height))) + 1;
  const first = Math.min(FIRST_LEVELS[kind] ?? 0, levels - 1);
  const { x, y } = sizeAt(THREE, source, first);
  const out = new THREE.WebGLRenderTarget(x, y, {
    ...samplerOf(source),
    type: THREE[TEXEL_TYPES[kind]],
    colorSpace: TEXEL_TYPES[kind] === 'UnsignedByteType' ? source.colorSpace : THREE.NoColorSpace,
    depthBuffer: false,
    generateMipmaps: false,
  });
  out.texture.mipmaps = Array.from({ length: levels - first }, () => ({}));
  const drawing = drawingOf(THREE, shaders);
  const fits = beside !== null && [beside, yarns].every((map) => map === null || (map.image?.width === width && map.image.height === height));
  const featuresAt = (fromImage, halves) =>
    featureDefines({ FROM_IMAGE: fromImage, HALVES: halves, BESIDE: beside !== null, BESIDE_FITS: fits, YARNS: yarns !== null });
  const putBack = setAside(renderer);
  let larger = null; // moments of the level before
  for (let level = 0; level < levels; level++) {
    const size = sizeAt(THREE, source, level);
    if (level > 0) {
      const moments = momentTarget(THREE, renderer, size);
      const before = sizeAt(THREE, source, level - 1);
      const uniforms = {
        sourceMap: larger?.texture ?? source,
        sourceSize: before,
        targetSize: size,
        cutoff,
        besideMap: beside,
        yarnMap: yarns,
      };
      const halves = before.x === 2 * size.x && before.y === 2 * size.y;
      drawing.draw(renderer, `${kind}Moments`, featuresAt(level === 1, halves), uniforms, moments, 0, size);
      larger?.dispose();
      larger = moments;
    }
    if (level < first) continue;
    drawing.draw(
      renderer,
      `${kind}Level`,
      featuresAt(level === 0, false),
      { sourceMap: larger?.texture ?? source, cutoff, besideMap: beside, yarnMap: yarns },
      out,
      level - first,
      size,
    );
  }
  larger?.dispose();
  putBack();
  return out;
}

/** Between two draws of the client's own: @returns {() => void} puts the renderer back as it was. */
function setAside(renderer) {
  const target = [renderer.getRenderTarget(), renderer.getActiveCubeFace(), renderer.getActiveMipmapLevel()];
  const {
    autoClear,
    xr: { enabled },
    shadowMap: { autoUpdate },
  } = renderer;
  renderer.autoClear = renderer.xr.enabled = renderer.shadowMap.autoUpdate = false;
  return () => {
    Object.assign(renderer, { autoClear });
    Object.assign(renderer.xr, { enabled });
    Object.assign(renderer.shadowMap, { autoUpdate });
    renderer.setRenderTarget(...target);
  };
}

const sizeAt = (THREE, { image }, level) => new THREE.Vector2(Math.max(1, image.width >> level), Math.max(1, image.height >> level));

/** Sums of squares need the precision where the GL draws floats: a variance is a small difference of them. */
const momentTarget = (THREE, renderer, { x, y }) =>
  new THREE.WebGLRenderTarget(x, y, {
    type: renderer.extensions.has('EXT_color_buffer_float') ? THREE.FloatType : THREE.HalfFloatType,
    depthBuffer: false,
    generateMipmaps: false,
    minFilter: THREE.NearestFilter,
    magFilter: THREE.NearestFilter,
  });

const samplerOf = ({ wrapS, wrapT, minFilter, magFilter, anisotropy }) => ({ wrapS, wrapT, minFilter, magFilter, anisotropy });

/** Draws one mip level at a time, by a triangle over the viewport. */
function drawingOf(THREE, shaders) {
  if (drawings.has(THREE)) return drawings.get(THREE);
  const geometry = new THREE.BufferGeometry();
  // Its vertices are numbered, not read; three.js counts them by this.
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(new Float32Array(9), 3));
  const mesh = new THREE.Mesh(geometry);
  mesh.frustumCulled = false;
  const scene = new THREE.Scene().add(mesh);
  const camera = new THREE.Camera();
  const materials = new Map();
  const materialOf = (name, defines) => {
    const key = [name, ...Object.values(defines)].join(' ');
    if (!materials.has(key)) {
      materials.set(
        key,
        new THREE.RawShaderMaterial({
          glslVersion: THREE.GLSL3,
          vertexShader: shaders.vertex,
          fragmentShader: shaders[name],
          defines,
          uniforms: Object.fromEntries(
            ['sourceMap', 'sourceSize', 'targetSize', 'cutoff', 'besideMap', 'yarnMap'].map((uniform) => [uniform, { value: null }]),
          ),
          depthTest: false,
          depthWrite: false,
          blending: THREE.NoBlending,
        }),
      );
    }
    return materials.get(key);
  };
  const draw = (renderer, name, defines, uniforms, target, level, { x, y }) => {
    mesh.material = materialOf(name, defines);
    for (const [uniform, value] of Object.entries(uniforms)) mesh.material.uniforms[uniform].value = value;
    mesh.material.uniformsNeedUpdate = true;
    target.viewport.set(0, 0, x, y);
    renderer.setRenderTarget(target, 0, level);
    renderer.render(scene, camera);
  };
  drawings.set(THREE, { draw });
  return { draw };
}
