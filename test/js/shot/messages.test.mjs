import assert from 'node:assert/strict';
import { test } from 'node:test';
import { TelarError, resolveShot } from '../../../js/shot/index.mjs';
import { nearest } from '../../../js/shot/complain.mjs';
import { LAYERS as LAYER_TABLE } from '../../../js/shot/table/layers.mjs';
import { SHOT } from '../../../js/shot/table/index.mjs';
import { FORMATS } from '../../../js/shot/table/output.mjs';
import { TONE_MAPPINGS } from '../../../js/shot/table/tone_mappings.mjs';

const box = { min: [-1, 0, -0.2], max: [1, 2, 0.2] };
const facts = { bounds: box, variants: ['white', 'navy'], cameras: [{ name: 'shop' }], animations: [{ name: 'walk' }, { name: 'sit' }] };

/** Sets a dotted path in a shot: with('a.b', 1) is {a: {b: 1}}; `base` gives what must stand beside it. */
function withValue(path, value, base = {}) {
  const [key, ...rest] = path.split('.');
  return { ...base, [key]: rest.length > 0 ? withValue(rest.join('.'), value, base[key]) : value };
}

function complaintOf(shot, of = facts) {
  try {
    resolveShot(shot, of);
  } catch (error) {
    assert.ok(error instanceof TelarError, `${error.stack}`);
    return error;
  }
  return assert.fail(`${JSON.stringify(shot)} was accepted`);
}

/** Keys of the shot, and names of a list of the table, as messages write them. */
const KEYS = Object.keys(SHOT.shape).join(', ');
const LAYERS = ['beauty', ...Object.keys(LAYER_TABLE)].map((name) => JSON.stringify(name)).join(', ');
const oneOf = (table) => new Intl.ListFormat('en-GB', { type: 'disjunction' }).format(Object.keys(table).map((name) => JSON.stringify(name)));

const pixels = { expected: 'a whole number of pixels in [1, 8192]', good: [1, 8192], bad: [0, 8193, 1.5, -1] };
const EXPLICIT = { camera: { position: [0, 0, 5], target: [0, 0, 0] } };

/** Each numeric option: what it accepts at its ends and refuses just beyond. */
const NUMBERS = {
  'size.width': pixels,
  'size.height': pixels,
  'camera.fovY': { expected: 'a number of degrees in [0.001, 179.999]', good: [0.001, 179.999], bad: [0, -5, 180] },
  'camera.fit': { expected: 'a number in [0.000001, 100]', good: [1e-6, 1, 2.5, 100], bad: [0, 100.1] },
  'camera.azimuth': { expected: 'a number of degrees in [-360, 360]', good: [-360, 360], bad: [-361, 361] },
  'camera.elevation': { expected: 'a number of degrees in [-90, 90]', good: [-90, 90], bad: [-91, 91] },
  'camera.height': { expected: 'a height in metres in [1e-30, 1e30]', base: EXPLICIT, good: [1e-30, 1e-6, 1e6], bad: [0, -1, 2e30] },
  'camera.near': { expected: 'a distance in metres in [-1e30, 1e30]', base: EXPLICIT, good: [1e-6, 4], bad: [2e30] },
  'camera.far': { expected: 'a distance in metres in [-1e30, 1e30]', base: EXPLICIT, good: [1, 1e6], bad: [2e30] },
  'environment.intensity': { expected: 'a number in [0, 1e30]', good: [0, 1e6], bad: [-1, 2e30] },
  'environment.rotation': { expected: 'a number of degrees in [-360, 360]', good: [-360, 360], bad: [-361, 361] },
  'background.blur': { expected: 'a number in [0, 1]', good: [0, 0.5, 1], bad: [-0.1, 1.1] },
  exposure: { expected: 'a number in [0, 1e30]', good: [0, 100], bad: [-0.1, 2e30] },
  'output.quality': { expected: 'a whole number in [1, 100]', good: [1, 100], bad: [0, 101, 50.5] },
  'output.effort': { expected: 'a whole number in [0, 9]', good: [0, 9], bad: [-1, 10, 1.5] },
  'output.ppi': { expected: 'a number in [0, 65535]', good: [0, 65535], bad: [-1, 65536] },
};

const LIGHT_NUMBERS = {
  intensity: { type: 'ambient', expected: 'a number in [0, 1e30]', good: [0, 1e6], bad: [-1] },
  width: { type: 'rect', expected: 'a length in metres in (0, 1e6]', good: [1e-6, 1e6], bad: [0, -1, 2e6] },
  height: { type: 'rect', expected: 'a length in metres in (0, 1e6]', good: [1e-6, 1e6], bad: [0, -1, 2e6] },
  range: { type: 'point', expected: 'a distance in metres in [0, 1e30]', good: [0, 1e6], bad: [-1] },
  angle: { type: 'spot', expected: 'a number of radians in (0, PI / 2]', good: [1e-6, Math.PI / 2], bad: [0, 1.6] },
  penumbra: { type: 'spot', expected: 'a number in [0, 1]', good: [0, 1], bad: [-0.1, 1.1] },
};

const WRONG_NUMBERS = [
  [NaN, 'NaN'],
  [Infinity, 'Infinity'],
  [-Infinity, '-Infinity'],
  ['5', '"5"'],
  [null, 'null'],
  [true, 'true'],
  [[], '[]'],
  [{}, '{}'],
  [5n, 'a bigint'],
];

const shows = (value) => [value, String(value)];

test('numeric options: ends, beyond the ends, wrong types, NaN', () => {
  for (const [path, { expected, base, good, bad }] of Object.entries(NUMBERS)) {
    for (const value of good) resolveShot(withValue(path, value, base), facts);
    for (const [value, text] of [...bad.map(shows), ...WRONG_NUMBERS]) {
      const error = complaintOf(withValue(path, value, base));
      assert.equal(error.message.replace('1e+30', '1e30').replace('2e+30', '2e30'), `shot.${path}: expected ${expected}, got ${text.replace('e+', 'e')}`);
      assert.deepEqual([error.code, error.kind, error.exit, error.pointer], ['E_SHOT', 'usage', 2, `/${path.replaceAll('.', '/')}`]);
    }
  }
});

test('numbers of lights', () => {
  for (const [key, { type, expected, good, bad }] of Object.entries(LIGHT_NUMBERS)) {
    for (const value of good) assert.equal(resolveShot({ lights: [{ type, [key]: value }] }, facts).lights[0][key], value);
    for (const [value, text] of [...bad.map(shows), ...WRONG_NUMBERS]) {
      assert.equal(complaintOf({ lights: [{ type: 'ambient' }, { type, [key]: value }] }).message, `shot.lights[1].${key}: expected ${expected}, got ${text}`);
    }
  }
});

const COLOUR = 'a CSS colour without transparency (name, #hex, rgb(), hsl()) or a linear [r, g, b]';
const XYZ = 'three numbers [x, y, z] in metres';
const BACKGROUND = `"transparent", "environment", {type: "environment", blur}, ${COLOUR}`;
const MAP = '"studio", "none", a path that ends in .hdr or .exr, or bytes';
const VIEWS = '"front", "back", "left", "right", "top", "bottom" or "three-quarter"';

/** [shot, message] */
const MESSAGES = [
  [null, 'shot: expected an object, got null'],
  [[], 'shot: expected an object, got []'],
  ['front', 'shot: expected an object, got "front"'],
  [{ size: 512 }, 'shot.size: expected an object, got 512'],
  [{ size: { widht: 5 } }, 'shot.size.widht: unknown key, did you mean width?'],
  [{ colour: 'red' }, `shot.colour: unknown key, expected one of ${KEYS}`],
  [{ Shading: 'three' }, 'shot.Shading: unknown key, did you mean shading?'],
  [JSON.parse('{"__proto__": {"size": 1}}'), `shot.__proto__: unknown key, expected one of ${KEYS}`],
  [{ 'a b\n': 1 }, `shot["a b\\n"]: unknown key, expected one of ${KEYS}`],
  [{ camera: 'front' }, 'shot.camera: expected an object, got "front"'],
  [{ camera: { view: 'up' } }, `shot.camera.view: expected ${VIEWS}, got "up"`],
  [{ camera: { veiw: 'front' } }, 'shot.camera.veiw: unknown key, did you mean view?'],
  [{ camera: { positon: [0, 0, 5], target: [0, 0, 0] } }, 'shot.camera.positon: unknown key, did you mean position?'],
  [{ camera: { position: [0, 0, 5], taget: [0, 0, 0] } }, 'shot.camera.taget: unknown key, did you mean target?'],
  [{ camera: { position: [0, 0, 5] } }, `shot.camera.target: expected ${XYZ}, got nothing`],
  [{ camera: { position: [0, 0], target: [0, 0, 0] } }, `shot.camera.position: expected ${XYZ}, got [0, 0]`],
  [{ camera: { position: [0, 0, '5'], target: [0, 0, 0] } }, 'shot.camera.position[2]: expected a number in [-1e30, 1e30], got "5"'],
  [{ camera: { position: [0, NaN, 5], target: [0, 0, 0] } }, 'shot.camera.position[1]: expected a number in [-1e30, 1e30], got NaN'],
  [{ camera: { position: [1, 2, 3], target: [1, 2, 3] } }, 'shot.camera.target: expected a point other than the position, got [1, 2, 3]'],
  [{ camera: { position: [0, 5, 0], target: [0, 0, 0] } }, 'shot.camera.up: expected a direction that is not along the view, got [0, 1, 0]'],
  [{ camera: { position: [0, 0, 5], target: [0, 0, 0], up: [0, 0, 0] } }, 'shot.camera.up: expected a direction that is not along the view, got [0, 0, 0]'],
  [{ camera: { view: 'front', azimuth: 3 } }, 'shot.camera.view: expected a named view, or azimuth and elevation, not both, got "front"'],
  [{ camera: { projection: 'isometric' } }, 'shot.camera.projection: expected "perspective" or "orthographic", got "isometric"'],
  [{ camera: { projection: 'orthographic', fovY: 30 } }, 'shot.camera.fovY: expected no fovY with the orthographic projection, got 30'],
  [{ camera: { ...EXPLICIT.camera, projection: 'perspective', height: 1 } }, 'shot.camera.height: expected no height with the perspective projection, got 1'],
  [
    { camera: { ...EXPLICIT.camera, projection: 'orthographic' } },
    'shot.camera.height: expected a height in metres for the orthographic projection, got nothing',
  ],
  [{ camera: { ...EXPLICIT.camera, near: 0 } }, 'shot.camera.near: expected a distance above 0, got 0'],
  [{ camera: { ...EXPLICIT.camera, near: 5, far: 5 } }, 'shot.camera.far: expected a distance beyond near (5), got 5'],
  [{ camera: { gltf: -1 } }, 'shot.camera.gltf: expected the index or the name of a camera in the model, got -1'],
  [{ camera: { gltf: 0, fovY: 3 } }, 'shot.camera.fovY: unknown key, expected one of gltf'],
  [{ environment: 'studoi' }, `shot.environment: expected ${MAP}, got "studoi"`],
  [{ environment: 3 }, `shot.environment: expected ${MAP}, got 3`],
  [{ environment: { map: 'a.png' } }, `shot.environment.map: expected ${MAP}, got "a.png"`],
  [{ environment: { mpa: 'a.hdr' } }, 'shot.environment.mpa: unknown key, did you mean map?'],
  [{ lights: {} }, 'shot.lights: expected a list of lights, got {}'],
  [{ lights: ['sun'] }, 'shot.lights[0]: expected an object, got "sun"'],
  [{ lights: [{}] }, 'shot.lights[0].type: expected "ambient", "hemisphere", "directional", "point", "spot", "rect" or "disk", got nothing'],
  [{ lights: [{ type: 'sun' }] }, 'shot.lights[0].type: expected "ambient", "hemisphere", "directional", "point", "spot", "rect" or "disk", got "sun"'],
  [{ lights: [{ type: 'point', colour: 'red' }] }, 'shot.lights[0].colour: unknown key, did you mean color?'],
  [{ lights: [{ type: 'point', color: 'rd' }] }, `shot.lights[0].color: expected ${COLOUR}, got "rd"`],
  [{ lights: [{ type: 'point', color: [1, 2] }] }, `shot.lights[0].color: expected ${COLOUR}, got [1, 2]`],
  [{ lights: [{ type: 'point', color: [1, 2, -1] }] }, 'shot.lights[0].color[2]: expected a number in [0, 1e30], got -1'],
  [{ lights: [{ type: 'ambient', position: [0, 0, 0] }] }, 'shot.lights[0].position: unknown key, expected one of type, color, intensity'],
  [{ lights: [{ type: 'spot', position: [0, 0, 0] }] }, 'shot.lights[0].target: expected a point other than the position, got [0, 0, 0]'],
  [{ lights: [{ type: 'ambient', castShadow: true }] }, 'shot.lights[0].castShadow: unknown key, expected one of type, color, intensity'],
  [{ lights: [{ type: 'spot', castShadow: 1 }] }, 'shot.lights[0].castShadow: expected true or false, got 1'],
  [{ lights: [{ type: 'spot', shadow: {} }] }, 'shot.lights[0].castShadow: expected true where `shadow` is given, got false'],
  [
    { lights: [{ type: 'spot', castShadow: true, shadow: { mapSize: 1e6 } }] },
    'shot.lights[0].shadow.mapSize: expected a whole number of texels in [16, 4096], got 1000000',
  ],
  [
    { lights: [{ type: 'spot', castShadow: true, shadow: { mapSize: 15 } }] },
    'shot.lights[0].shadow.mapSize: expected a whole number of texels in [16, 4096], got 15',
  ],
  [{ lights: [{ type: 'spot', castShadow: true, shadow: { bias: -2 } }] }, 'shot.lights[0].shadow.bias: expected a number in [-1, 1], got -2'],
  [{ lights: [{ type: 'spot', castShadow: true, shadow: { normalBias: -1 } }] }, 'shot.lights[0].shadow.normalBias: expected a number in [0, 1e30], got -1'],
  [{ lights: [{ type: 'spot', castShadow: true, shadow: { radius: 26 } }] }, 'shot.lights[0].shadow.radius: expected a number of texels in [0, 25], got 26'],
  [{ lights: [{ type: 'spot', castShadow: true, shadow: { near: 0 } }] }, 'shot.lights[0].shadow.near: expected a distance above 0, got 0'],
  [{ lights: [{ type: 'spot', castShadow: true, shadow: { near: 2, far: 1 } }] }, 'shot.lights[0].shadow.far: expected a distance beyond near (2), got 1'],
  [
    { lights: [{ type: 'spot', castShadow: true, range: 3, shadow: { far: 4 } }] },
    "shot.lights[0].shadow.far: expected 3, as three.js ends the map at the light's range, got 4",
  ],
  [
    { lights: [{ type: 'spot', castShadow: true, shadow: { left: 1 } }] },
    'shot.lights[0].shadow.left: unknown key, expected one of mapSize, radius, intensity, bias, normalBias, near, far, focus',
  ],
  [
    { lights: [{ type: 'directional', castShadow: true, shadow: { left: 1, right: 0 } }] },
    'shot.lights[0].shadow.right: expected a number above left (1), got 0',
  ],
  [
    { lights: [{ type: 'directional', castShadow: true, shadow: { bottom: 1, top: 1 } }] },
    'shot.lights[0].shadow.top: expected a number above bottom (1), got 1',
  ],
  [{ ground: 'floor' }, 'shot.ground: expected "none" or {shadow, opacity, gap}, got "floor"'],
  [{ ground: { shadow: false } }, 'shot.ground.shadow: expected true, got false'],
  [{ ground: { opacity: 1.5 } }, 'shot.ground.opacity: expected a number in [0, 1], got 1.5'],
  [{ ground: { size: [1, 0] } }, 'shot.ground.size[1]: expected two lengths [x, z] in metres, got 0'],
  [{ modelLights: 'no' }, 'shot.modelLights: expected true or false, got "no"'],
  [{ lights: [{ type: 'rect', position: [1, 1, 1], target: [1, 1, 1] }] }, 'shot.lights[0].target: expected a point other than the position, got [1, 1, 1]'],
  [{ lights: [{ type: 'rect', wdth: 1 }] }, 'shot.lights[0].wdth: unknown key, did you mean width?'],
  [{ background: 'bleu' }, `shot.background: expected ${BACKGROUND}, got "bleu"`],
  [{ background: 'rgba(1, 2, 3, 0.5)' }, `shot.background: expected ${BACKGROUND}, got "rgba(1, 2, 3, 0.5)"`],
  [{ background: null }, `shot.background: expected ${BACKGROUND}, got null`],
  [{ background: { blr: 0.5 } }, 'shot.background.blr: unknown key, did you mean blur?'],
  [{ background: { type: 'color' } }, 'shot.background.type: expected "environment", got "color"'],
  [
    { background: { blur: 0.5 }, environment: 'none' },
    'shot.background: expected "transparent" or a colour, as shot.environment is "none", got {"type", "blur"}',
  ],
  [{ background: 'environment', environment: 'none' }, 'shot.background: expected "transparent" or a colour, as shot.environment is "none", got "environment"'],
  [
    { background: 'transparent', output: { format: 'jpeg' } },
    'shot.background: expected a colour or "environment", as jpeg has no transparency, got "transparent"',
  ],
  [
    { shading: 'tree' },
    'shot.shading: expected "three", "fabric", "three-r115", "disney-2012", {base, <slot>: <term>} or {base: "three", revision}, got "tree"',
  ],
  [{ shading: { sheen: 'zeltner' } }, 'shot.shading.base: expected "three-r115" or "disney-2012", got nothing'],
  [{ shading: { base: 'three-r115', fresnel: 'zeltner' } }, 'shot.shading.fresnel: expected "schlick-exp2" or "schlick", got "zeltner"'],
  [{ shading: { base: 'disney-2012', shen: 'zeltner' } }, 'shot.shading.shen: unknown key, did you mean sheen?'],
  [{ toneMapping: 'filmic' }, `shot.toneMapping: expected ${oneOf(TONE_MAPPINGS)}, got "filmic"`],
  [
    { quality: 'best' },
    'shot.quality: expected "standard", "draft", "medium", "high", "reference", {samples, resolve, noise, environmentSamples, mergeQuads, ...}, {preset: "reference", ...}, {maxError} or {budgetMs}, got "best"',
  ],
  [{ quality: { samples: 2 } }, 'shot.quality.samples: expected 1, 4, 16, 64, 256 or 1024 samples a pixel, got 2'],
  [{ quality: { samples: 4, noise: 1 } }, 'shot.quality.noise: expected 0 with 4 samples or fewer, got 1'],
  [{ quality: { samples: 16, resolve: 'encoded' } }, 'shot.quality.resolve: expected "linear" with more than 4 samples, got "encoded"'],
  [{ quality: { environmentSamples: 0.5 } }, 'shot.quality.environmentSamples: expected a whole number of directions in [0, 4096], got 0.5'],
  [{ quality: { preset: 'standard', environmentSamples: 64 } }, 'shot.quality.environmentSamples: expected 0 with preset "standard", or no preset, got 64'],
  [{ quality: { textureSize: 16385 } }, 'shot.quality.textureSize: expected a whole number of texels in [0, 16384], got 16385'],
  [{ quality: { environmentSize: 100 } }, 'shot.quality.environmentSize: expected 0, 64, 128, 256, 512 or 1024 texels, got 100'],
  [{ quality: { prefilterSamples: 0 } }, 'shot.quality.prefilterSamples: expected 16, 32, 64, 128, 256, 512, 1024, 2048 or 4096 directions, got 0'],
  [{ quality: { maxLights: -1 } }, 'shot.quality.maxLights: expected a whole number of lights in [0, 4096], got -1'],
  [{ quality: { transmissionScale: 1.5 } }, 'shot.quality.transmissionScale: expected a number in [0.0625, 1], got 1.5'],
  [{ quality: { geometryError: -1 } }, 'shot.quality.geometryError: expected a number in [0, 64], got -1'],
  [{ quality: { preset: 'draft', textureSize: 512 } }, 'shot.quality.textureSize: expected 0 with preset "draft", or no preset, got 512'],
  [
    { quality: { preset: 'reference', textureSize: 512 } },
    'shot.quality.textureSize: unknown key, expected one of preset, samples, noise, seed, transport, bounces, threads',
  ],
  [{ quality: { preset: 'best' } }, 'shot.quality.preset: expected "standard", "draft", "medium", "high" or "reference", got "best"'],
  [{ quality: { maxError: 0 } }, 'shot.quality.maxError: expected a number in (0, 1], got 0'],
  [{ quality: { budgetMs: '1 s' } }, 'shot.quality.budgetMs: expected a number in (0, 1e9], got "1 s"'],
  [{ quality: { maxError: 0.1, budgetMs: 3 } }, 'shot.quality.budgetMs: unknown key, expected one of maxError'],
  [{ quality: { preset: 'reference', noise: 65 } }, 'shot.quality.noise: expected a number in [0, 64], got 65'],
  [{ quality: { preset: 'reference', samples: 0 } }, 'shot.quality.samples: expected a whole number of paths a pixel in [1, 65536], got 0'],
  [
    { quality: { preset: 'reference', resolve: 'linear' } },
    'shot.quality.resolve: unknown key, expected one of preset, samples, noise, seed, transport, bounces, threads',
  ],
  [{ quality: { preset: 'reference', sead: 1 } }, 'shot.quality.sead: unknown key, did you mean seed?'],
  [{ quality: { preset: 'reference', transport: 'all' } }, 'shot.quality.transport: expected "global", "occlusion" or "direct", got "all"'],
  [{ quality: { preset: 'reference', transport: 'direct', bounces: 2 } }, 'shot.quality.bounces: expected 0 with transport "direct", got 2'],
  [{ lens: {} }, 'shot.lens.aperture: expected an f-number in [0.1, 1000], got nothing'],
  [{ lens: { aperture: 8, focusDistance: 'nose' } }, 'shot.lens.focusDistance: expected a distance in metres in [1e-30, 1e30] or "target", got "nose"'],
  [{ lens: { aperture: 8, shutter: 0.01 } }, 'shot.lens.iso: expected a sensitivity beside shutter, got nothing'],
  [{ lens: { aperture: 8, iso: 100 } }, 'shot.lens.shutter: expected a number of seconds beside iso, got nothing'],
  [{ lens: { aperture: 8, shutter: null, iso: 100 } }, 'shot.lens.shutter: expected a number of seconds beside iso, got null'],
  [
    { lens: { aperture: 8, focusDistance: 2 }, camera: { projection: 'orthographic' } },
    'shot.lens.focusDistance: expected none with the orthographic projection, which has no lens to blur, got 2',
  ],
  [{ quality: { preset: 'draft', samples: 4 } }, 'shot.quality.samples: expected 1 with preset "draft", or no preset, got 4'],
  [{ variant: 3 }, 'shot.variant: expected the name of a variant, got 3'],
  [{ layers: 'beauty' }, `shot.layers: expected a list of ${LAYERS}, got "beauty"`],
  [{ layers: ['beauty', 'ambient'] }, `shot.layers[1]: expected ${LAYERS}, got "ambient"`],
  [{ output: { layers: { bitDepth: 32 } } }, 'shot.output.layers.bitDepth: expected 16 or 8 for png, got 32'],
  [{ output: { layers: { format: 'exr', bitDepth: 8 } } }, 'shot.output.layers.bitDepth: expected 32 or 16 for exr, got 8'],
  [
    { output: { layers: { format: 'exr', together: true } } },
    'shot.output.layers.together: expected false, as output.format and output.layers.format are not both "exr", got true',
  ],
  [{ scale: 'half' }, 'shot.scale: expected "none", or a scale as in "1:5", numbers from 0.001 to 10000, got "half"'],
  [{ scale: '1:5' }, 'shot.output.ppi: expected pixels per inch above 0 with scale "1:5", got 0'],
  [{ scale: '1:0', output: { ppi: 300 } }, 'shot.scale: expected "none", or a scale from "1000:1" to "1:10000", got "1:0"'],
  [
    { scale: '100:1', output: { ppi: 300 } },
    'shot.scale: expected a scale at which the picture has at most 8192 pixels a side; this one has 2624672 x 2624672, got "100:1"',
  ],
  [
    { scale: '1:5', output: { ppi: 254 }, camera: { position: [0, 0, 1], target: [0, 0, 0], height: 0.2, near: 0.1, far: 2 } },
    'shot.camera.height: expected 0.256 metres, as size, scale and output.ppi say, or none, got 0.2',
  ],
  [{ style: 'flat', background: 'environment' }, 'shot.background: expected "transparent" or a colour with style "flat", got "environment"'],
  [{ output: { format: 'jpg' } }, `shot.output.format: expected ${oneOf(FORMATS)}, got "jpg"`],
  [{ output: { format: 'jpeg', bitDepth: 16 } }, 'shot.output.bitDepth: expected 8 for jpeg, got 16'],
  [{ output: { bitDepth: 10 } }, 'shot.output.bitDepth: expected 8, 16 or 32 bits a channel, got 10'],
  [{ output: { format: 'webp', ppi: 72 } }, 'shot.output.ppi: expected 0, as webp holds no ppi, got 72'],
  [{ output: { format: 'raw', icc: true } }, 'shot.output.icc: expected false, as raw holds no profile here, got true'],
];

test('exact messages', () => {
  for (const [shot, message] of MESSAGES) {
    const error = complaintOf(shot);
    assert.equal(error.message, message);
    assert.equal(error.code, 'E_SHOT');
  }
});

test('what the model does not have', () => {
  const cases = [
    [{ pose: { animation: 2 } }, 'E_POSE', 'shot.pose.animation: the model has no animation 2; it has 0 "walk", 1 "sit"'],
    [{ pose: { animation: 'wall' } }, 'E_POSE', 'shot.pose.animation: the model has no animation "wall"; did you mean "walk"?'],
    [{ pose: { animation: 'fly off' } }, 'E_POSE', 'shot.pose.animation: the model has no animation "fly off"; it has 0 "walk", 1 "sit"'],
    [{ variant: 'navi' }, 'E_VARIANT', 'shot.variant: the model has no variant "navi"; did you mean "navy"?'],
    [{ variant: 'crimson' }, 'E_VARIANT', 'shot.variant: the model has no variant "crimson"; it has "white", "navy"'],
    [{ camera: { gltf: 1 } }, 'E_CAMERA', 'shot.camera.gltf: the model has no camera 1; it has 0 "shop"'],
    [{ camera: { gltf: 'sale' } }, 'E_CAMERA', 'shot.camera.gltf: the model has no camera "sale"; it has 0 "shop"'],
    [{ camera: { gltf: 'shops' } }, 'E_CAMERA', 'shot.camera.gltf: the model has no camera "shops"; did you mean "shop"?'],
  ];
  for (const [shot, code, message] of cases) {
    const error = complaintOf(shot);
    assert.deepEqual([error.code, error.message, error.exit], [code, message, 3]);
  }
  assert.match(complaintOf({ variant: 'x' }, { bounds: box, variants: [] }).message, /it has none$/);
  assert.match(complaintOf({ camera: { gltf: 0 } }, box).message, /it has none$/);
});

test('a model without geometry', () => {
  const message = 'shot.camera: the model has nothing to frame; give an explicit camera with near and far';
  assert.equal(complaintOf({}, { bounds: null }).message, message);
  assert.equal(complaintOf({}, null).message, message);
  assert.equal(complaintOf(EXPLICIT, null).code, 'E_NO_GEOMETRY');
});

test('wrong facts', () => {
  for (const wrong of [
    { min: [0, 0], max: [1, 1, 1] },
    { min: [0, 0, NaN], max: [1, 1, 1] },
    { min: [2, 0, 0], max: [1, 1, 1] },
    { min: ['0', 0, 0], max: [1, 1, 1] },
    { bounds: {} },
    { bounds: { min: [0, 0, 0] } },
  ]) {
    assert.equal(complaintOf({}, wrong).code, 'E_OPTION', JSON.stringify(wrong));
  }
});

test('messages stay short and clean whatever they quote', () => {
  const { message } = complaintOf({ toneMapping: `\u001b[31m${'x'.repeat(5000)}` });
  assert.ok(message.length < 160);
  assert.doesNotMatch(message, /[\u0000-\u001f]/);
});

test('a name that objects do not keep is refused, as JSON may have it', () => {
  for (const cloth of ['{"preset":"denim"}', '{"nokey":1}', '7']) {
    const { code, message, pointer } = complaintOf(JSON.parse(`{"materials":{"Body":{},"__proto__":${cloth}}}`));
    assert.deepEqual([code, pointer], ['E_SHOT', '/materials/__proto__']);
    assert.match(message, /^shot\.materials\.__proto__: expected another name, got /);
  }
  // The prototype itself is no key.
  assert.deepEqual(Object.keys(resolveShot({ materials: { __proto__: { preset: 'denim' }, Body: {} } }, facts).materials), ['Body']);
});

test('the nearest word', () => {
  assert.equal(nearest('wdth', ['width', 'height']), 'width');
  assert.equal(nearest('zzz', ['width', 'height']), undefined);
  assert.equal(nearest('x', []), undefined);
});

test('what is too small to be drawn is a fault of the model', () => {
  const tiny = (size) => ({ min: [0, 0, 0], max: [size, size, 0] });
  for (const size of [1e-45, 1e-39, 1e-35, 1e-31]) {
    for (const camera of [{}, { projection: 'orthographic' }, { position: [0, 0, size], target: [0, 0, 0] }]) {
      const error = complaintOf({ camera }, tiny(size));
      assert.deepEqual([error.code, error.kind], ['E_EXTENT', 'input'], `${size} ${JSON.stringify(camera)}`);
      assert.match(error.message, /^what is framed is [\d.e-]+ m across, too small to be drawn; glTF is in metres/);
    }
  }
  for (const camera of [{}, { projection: 'orthographic' }]) resolveShot({ camera }, tiny(1e-29));
  const cameras = [{ projection: 'orthographic', position: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], height: 1e-31, near: 1, far: 9 }];
  const error = complaintOf({ camera: { gltf: 0 } }, { bounds: box, cameras });
  assert.deepEqual([error.code, error.message], ['E_CAMERA', "shot.camera.gltf: the model's camera 0 shows 1e-31 m; expected at least 1e-30"]);
});
