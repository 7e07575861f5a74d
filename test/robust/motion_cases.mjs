// Hostile skins, morph targets, animations and instances.
import { addView, floats, glb, quad } from './glb.mjs';

const FLOAT = 5126;
const BYTE = 5121;
const EXTENSION = 'EXT_mesh_gpu_instancing';

const bytes = (...values) => Buffer.from(values);

/** Appends an accessor on these bytes; returns its index. */
function accessor(model, data, componentType, count, type) {
  model.doc.accessors.push({ bufferView: addView(model, data), componentType, count, type });
  return model.doc.accessors.length - 1;
}

/** An accessor of zeros without a byte behind it. */
function zeros(model, count, type) {
  model.doc.accessors.push({ componentType: FLOAT, count, type });
  return model.doc.accessors.length - 1;
}

const scalars = (model, ...values) => accessor(model, floats(...values), FLOAT, values.length, 'SCALAR');
const vectors = (model, ...values) => accessor(model, floats(...values), FLOAT, values.length / 3, 'VEC3');

/** The quad after `change(model, primitive)`, as a GLB. */
function changed(change) {
  const model = quad();
  change(model, model.doc.meshes[0].primitives[0]);
  return glb(model);
}

/** The quad on one joint, after `change(model, attributes)`. */
const skinned = (change) =>
  changed((model, { attributes }) => {
    attributes.JOINTS_0 = accessor(model, bytes(...Array(16).fill(0)), BYTE, 4, 'VEC4');
    attributes.WEIGHTS_0 = accessor(model, floats(...Array(4).fill([1, 0, 0, 0]).flat()), FLOAT, 4, 'VEC4');
    model.doc.nodes.push({});
    model.doc.scenes[0].nodes.push(1);
    model.doc.skins = [{ joints: [1] }];
    model.doc.nodes[0].skin = 0;
    change(model, attributes);
  });

/** The quad that moves, after `change(model, animation)`. */
const animated = (change) =>
  changed((model) => {
    const animation = {
      channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }],
      samplers: [{ input: scalars(model, 0, 1), output: vectors(model, 0, 0, 0, 1, 0, 0) }],
    };
    model.doc.animations = [animation];
    change(model, animation);
  });

/** The quad at two places, after `change(model, attributes)`. */
const instanced = (change) =>
  changed((model) => {
    const attributes = { TRANSLATION: vectors(model, 0, 0, 0, 3, 0, 0) };
    model.doc.nodes[0].extensions = { [EXTENSION]: { attributes } };
    model.doc.extensionsUsed = [EXTENSION];
    change(model, attributes);
  });

const PRIMITIVE = '/meshes/0/primitives/0';
const SAMPLER = '/animations/0/samplers/0';
const INSTANCES = `/nodes/0/extensions/${EXTENSION}`;

// biome-ignore format: one row a line, read as a table
const skinCases = () => [
  { name: 'skin-good.glb', bytes: skinned(() => {}), code: '' },
  { name: 'skin-joint-255.glb', bytes: skinned((m, a) => { a.JOINTS_0 = accessor(m, bytes(...Array(16).fill(255)), BYTE, 4, 'VEC4'); }), code: 'E_SKIN', pointer: `${PRIMITIVE}/attributes/JOINTS_0` },
  { name: 'skin-weights-nan.glb', bytes: skinned((m, a) => { a.WEIGHTS_0 = accessor(m, floats(...Array(16).fill(NaN)), FLOAT, 4, 'VEC4'); }), code: '', warning: 'W_NONFINITE' },
  { name: 'skin-weights-huge.glb', bytes: skinned((m, a) => { a.WEIGHTS_0 = accessor(m, floats(...Array(16).fill(3e38)), FLOAT, 4, 'VEC4'); }), code: '' },
  { name: 'skin-weights-2e9.glb', bytes: skinned((m, a) => { a.WEIGHTS_0 = zeros(m, 2e9, 'VEC4'); }), code: 'E_ACCESSOR', pointer: `${PRIMITIVE}/attributes/WEIGHTS_0` },
  { name: 'skin-bind-too-few.glb', bytes: skinned((m) => { m.doc.skins[0] = { joints: [1, 0], inverseBindMatrices: zeros(m, 1, 'MAT4') }; }), code: 'E_SKIN', pointer: '/skins/0/inverseBindMatrices' },
  { name: 'skin-bind-2p50.glb', bytes: skinned((m) => { m.doc.skins[0].inverseBindMatrices = zeros(m, 2 ** 50, 'MAT4'); }), code: 'E_NO_GEOMETRY' },
  { name: 'skin-no-joints.glb', bytes: skinned((m) => { m.doc.skins[0].joints = []; }), code: 'E_SKIN', pointer: '/skins/0/joints' },
  { name: 'skin-joint-missing.glb', bytes: skinned((m) => { m.doc.skins[0].joints = [7]; }), code: 'E_REF', pointer: '/skins/0/joints/0' },
  { name: 'skin-joint-cycle.glb', bytes: skinned((m) => { m.doc.nodes[1].children = [1]; }), code: 'E_GRAPH', pointer: '/nodes/1' },
  { name: 'skin-joint-elsewhere.glb', bytes: skinned((m) => { m.doc.scenes[0].nodes = [0]; }), code: '', warning: 'W_SKIN' },
  { name: 'skin-joint-1e38.glb', bytes: skinned((m) => { m.doc.nodes[1].scale = [1e200, 1e200, 1e200]; }), code: 'E_NO_GEOMETRY' },
];

// biome-ignore format: one row a line, read as a table
const morphCases = () => [
  { name: 'morph-good.glb', bytes: changed((m, p) => { p.targets = [{ POSITION: 0 }]; m.doc.meshes[0].weights = [1]; }), code: '' },
  { name: 'morph-count.glb', bytes: changed((m, p) => { p.targets = [{ POSITION: vectors(m, 0, 0, 1) }]; }), code: 'E_ACCESSOR', pointer: `${PRIMITIVE}/targets/0/POSITION` },
  { name: 'morph-type.glb', bytes: changed((m, p) => { p.targets = [{ NORMAL: 1 }]; }), code: 'E_ACCESSOR', pointer: `${PRIMITIVE}/targets/0/NORMAL` },
  { name: 'morph-nan.glb', bytes: changed((m, p) => { p.targets = [{ POSITION: vectors(m, ...Array(12).fill(NaN)) }]; m.doc.meshes[0].weights = [1]; }), code: 'E_NO_GEOMETRY' },
  { name: 'morph-weights-many.glb', bytes: changed((m, p) => { p.targets = [{ POSITION: 0 }]; m.doc.nodes[0].weights = Array(100_000).fill(1); }), code: '' },
  { name: 'morph-weight-text.glb', bytes: changed((m, p) => { p.targets = [{ POSITION: 0 }]; m.doc.meshes[0].weights = ['1']; }), code: 'E_SCHEMA', pointer: '/meshes/0/weights/0' },
  { name: 'morph-targets-300.glb', bytes: changed((m, p) => { p.targets = Array(300).fill({ POSITION: 0 }); }), code: 'L_MORPH_TARGETS', pointer: `${PRIMITIVE}/targets` },
  { name: 'morph-of-zeros.glb', bytes: changed((m, p) => { m.doc.accessors[0] = { componentType: FLOAT, count: 1e5, type: 'VEC3' }; p.attributes = { POSITION: 0 }; p.targets = Array(200).fill({ POSITION: 0 }); }), code: 'L_VERTICES', pointer: PRIMITIVE },
];

// biome-ignore format: one row a line, read as a table
const animationCases = () => [
  { name: 'animation-good.glb', bytes: animated(() => {}), code: '' },
  { name: 'animation-times-fall.glb', bytes: animated((m, a) => { a.samplers[0].input = scalars(m, 1, 0); }), code: 'E_ANIMATION', pointer: `${SAMPLER}/input` },
  { name: 'animation-times-nan.glb', bytes: animated((m, a) => { a.samplers[0].input = scalars(m, 0, NaN); }), code: 'E_ANIMATION', pointer: `${SAMPLER}/input` },
  { name: 'animation-times-are-vectors.glb', bytes: animated((m, a) => { a.samplers[0].input = 0; }), code: 'E_ANIMATION', pointer: `${SAMPLER}/input` },
  { name: 'animation-count.glb', bytes: animated((m, a) => { a.samplers[0].output = vectors(m, 0, 0, 0); }), code: 'E_ANIMATION', pointer: `${SAMPLER}/output` },
  { name: 'animation-spline-count.glb', bytes: animated((m, a) => { a.samplers[0].interpolation = 'CUBICSPLINE'; }), code: 'E_ANIMATION', pointer: `${SAMPLER}/output` },
  { name: 'animation-values-2p50.glb', bytes: animated((m, a) => { a.samplers[0].output = zeros(m, 2 ** 50, 'VEC3'); }), code: 'E_ANIMATION', pointer: `${SAMPLER}/output` },
  { name: 'animation-times-2p50.glb', bytes: animated((m, a) => { a.samplers[0].input = zeros(m, 2 ** 50, 'SCALAR'); }), code: 'L_KEYFRAME_VALUES', pointer: `${SAMPLER}/input` },
  { name: 'animation-shared-times.glb', bytes: animated((m, a) => {
    Object.assign(a.samplers[0], { input: zeros(m, 1e6, 'SCALAR'), output: zeros(m, 1e6, 'VEC3') });
    a.channels = ['translation', 'scale'].map((path) => ({ sampler: 0, target: { node: 0, path } }));
    m.doc.animations = Array(20).fill(a);
  }), code: 'L_KEYFRAME_VALUES' },
  { name: 'animation-sampler-missing.glb', bytes: animated((m, a) => { a.channels[0].sampler = 1; }), code: 'E_REF', pointer: '/animations/0/channels/0/sampler' },
  { name: 'animation-twice.glb', bytes: animated((m, a) => { a.channels.push(a.channels[0]); }), code: 'E_ANIMATION', pointer: '/animations/0/channels/1/target' },
  { name: 'animation-path.glb', bytes: animated((m, a) => { a.channels[0].target.path = '__proto__'; }), code: '', warning: 'W_ANIMATION' },
  { name: 'animation-no-path.glb', bytes: animated((m, a) => { a.channels[0].target = {}; }), code: '' },
  { name: 'animation-channels-50k.glb', bytes: animated((m, a) => { a.channels = Array(50_000).fill({ sampler: 0, target: { node: 0, path: 'x' } }); }), code: '', warning: 'W_ANIMATION' },
];

// biome-ignore format: one row a line, read as a table
const instanceCases = () => [
  { name: 'instances-good.glb', bytes: instanced(() => {}), code: '' },
  { name: 'instances-count.glb', bytes: instanced((m, a) => { a.SCALE = vectors(m, 1, 1, 1); }), code: 'E_INSTANCING' },
  { name: 'instances-type.glb', bytes: instanced((m, a) => { a.ROTATION = a.TRANSLATION; }), code: 'E_INSTANCING', pointer: `${INSTANCES}/attributes/ROTATION` },
  { name: 'instances-2p50.glb', bytes: instanced((m, a) => { a.TRANSLATION = zeros(m, 2 ** 50, 'VEC3'); }), code: 'L_INSTANCES', pointer: '/nodes/0' },
  { name: 'instances-200k-of-triangles.glb', bytes: instanced((m, a) => { a.TRANSLATION = zeros(m, 200_000, 'VEC3'); m.doc.accessors[2] = { componentType: BYTE, count: 600, type: 'SCALAR' }; }), code: 'L_TRIANGLES', pointer: PRIMITIVE },
  { name: 'instances-nan.glb', bytes: instanced((m, a) => { a.TRANSLATION = vectors(m, 0, 0, 0, NaN, 0, 0); }), code: '', warning: 'W_NONFINITE' },
  { name: 'instances-all-nan.glb', bytes: instanced((m, a) => { a.TRANSLATION = vectors(m, ...Array(6).fill(NaN)); }), code: 'E_NO_GEOMETRY' },
  { name: 'instances-far.glb', bytes: instanced((m, a) => { a.TRANSLATION = vectors(m, 3e38, 0, 0, 0, 0, 0); }), code: 'E_NO_GEOMETRY' },
  { name: 'instances-none.glb', bytes: instanced((m) => { m.doc.nodes[0].extensions[EXTENSION] = {}; }), code: 'E_SCHEMA', pointer: `${INSTANCES}/attributes` },
];

export const motionCases = () => [...skinCases(), ...morphCases(), ...animationCases(), ...instanceCases()];
