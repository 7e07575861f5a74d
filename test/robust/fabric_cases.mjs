// Hostile values of KHR_materials_diffuse_transmission and TELAR_materials_fabric.
const EXTENSION = '/materials/0/extensions/TELAR_materials_fabric';
const EXTRAS = '/materials/0/extras/TELAR_materials_fabric';

const cloth = (fabric) => (m) => {
  m.doc.materials = [{ ...m.doc.materials?.[0], extensions: { TELAR_materials_fabric: fabric } }];
};
const thin = (values) => (m) => {
  m.doc.materials = [{ extensions: { KHR_materials_diffuse_transmission: values } }];
};
const extras = (value) => (m) => {
  m.doc.materials = [{ extras: value }];
};

/** @param {(change: (model: object) => void) => Buffer} changed - GLB of the good model after a change. */
export const fabricCases = (changed) => [
  { name: 'fabric-list.glb', bytes: changed(cloth([])), code: 'E_SCHEMA', pointer: EXTENSION },
  { name: 'fabric-preset-number.glb', bytes: changed(cloth({ preset: 7 })), code: 'E_SCHEMA', pointer: `${EXTENSION}/preset` },
  { name: 'fabric-preset-unknown.glb', bytes: changed(cloth({ preset: '../../etc/passwd' })), code: '', warning: 'W_ENUM' },
  { name: 'fabric-preset-prototype.glb', bytes: changed(cloth({ preset: '__proto__' })), code: '', warning: 'W_ENUM' },
  { name: 'fabric-preset-long.glb', bytes: changed(cloth({ preset: 'x'.repeat(100_000) })), code: '', warning: 'W_ENUM' },
  { name: 'fabric-flatness-1e308.glb', bytes: changed(cloth({ flatness: 1e308 })), code: '', warning: 'W_RANGE' },
  { name: 'fabric-threads-negative.glb', bytes: changed(cloth({ weave: { threadsPerUv: [-1, 1e300] } })), code: '', warning: 'W_RANGE' },
  {
    name: 'fabric-threads-three.glb',
    bytes: changed(cloth({ weave: { threadsPerUv: [1, 2, 3] } })),
    code: 'E_SCHEMA',
    pointer: `${EXTENSION}/weave/threadsPerUv`,
  },
  { name: 'fabric-coverage-two.glb', bytes: changed(cloth({ weave: { warp: { coverage: 1 }, weft: { coverage: 1 } } })), code: '', warning: 'W_RANGE' },
  { name: 'fabric-coverage-zero.glb', bytes: changed(cloth({ weave: { warp: { coverage: 0 }, weft: { coverage: 0 } } })), code: '' },
  {
    name: 'fabric-weave-texture-missing.glb',
    bytes: changed(cloth({ weave: { weaveTexture: { index: 2 ** 31 } } })),
    code: 'E_REF',
    pointer: `${EXTENSION}/weave/weaveTexture/index`,
  },
  {
    name: 'fabric-back-texture-text.glb',
    bytes: changed(cloth({ back: { baseColorTexture: { index: '0' } } })),
    code: 'E_SCHEMA',
    pointer: `${EXTENSION}/back/baseColorTexture/index`,
  },
  { name: 'fabric-back-empty.glb', bytes: changed(cloth({ back: {}, weave: {} })), code: '' },
  { name: 'fabric-everything-deep.glb', bytes: changed(cloth({ weave: { warp: { warp: { warp: {} } } }, unknown: { preset: [] } })), code: '' },
  { name: 'fabric-extras-list.glb', bytes: changed(extras({ TELAR_materials_fabric: [1] })), code: 'E_SCHEMA', pointer: EXTRAS },
  { name: 'fabric-extras-text.glb', bytes: changed(extras('TELAR_materials_fabric')), code: '' },
  { name: 'fabric-extras-null.glb', bytes: changed(extras(null)), code: '' },
  {
    name: 'fabric-extras-texture.glb',
    bytes: changed(extras({ TELAR_materials_fabric: { weave: { weaveTexture: { index: 99 } } } })),
    code: 'E_REF',
    pointer: `${EXTRAS}/weave/weaveTexture/index`,
  },
  {
    name: 'fabric-copies-unreachable.glb',
    bytes: changed((m) => {
      cloth({ preset: 'denim' })(m);
      m.doc.meshes[0].primitives[0].material = 1;
    }),
    code: 'E_REF',
    pointer: '/meshes/0/primitives/0/material',
  },
  {
    name: 'fabric-presets-4k.glb',
    bytes: changed((m) => {
      m.doc.materials = Array.from({ length: 4096 }, () => ({ extensions: { TELAR_materials_fabric: { preset: 'satin' } } }));
    }),
    code: '',
  },
  {
    name: 'thin-factor-text.glb',
    bytes: changed(thin({ diffuseTransmissionFactor: '1' })),
    code: 'E_SCHEMA',
    pointer: '/materials/0/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionFactor',
  },
  {
    name: 'thin-factor-1e308.glb',
    bytes: changed(thin({ diffuseTransmissionFactor: 1e308, diffuseTransmissionColorFactor: [-1, 2, 1e308] })),
    code: '',
    warning: 'W_RANGE',
  },
  {
    name: 'thin-texture-missing.glb',
    bytes: changed(thin({ diffuseTransmissionFactor: 1, diffuseTransmissionTexture: { index: 9 } })),
    code: 'E_REF',
    pointer: '/materials/0/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionTexture/index',
  },
];
