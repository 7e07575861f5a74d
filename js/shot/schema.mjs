import * as z from '../dist/zod.mjs';
import { HUGE, TINY, boolean, choice, colour, expectedColour, indexOrName, number, object, text, vector } from './fields.mjs';
import { FITS, VIEWS } from './frame.mjs';
import { lensSchema } from './lens.mjs';
import { referenceQuality } from './reference.mjs';
import { BASES, SLOTS, WITHOUT_TERMS } from './shading_terms.mjs';

/**
 * The one declaration of the shot: the API, the CLI, the HTTP service, the JSON Schema, the TypeScript types and the option
 * tables all derive from it. Defaults that depend on other keys or on the model are written out in resolve.mjs.
 */

const degrees = (doc, min, max) => number(doc, { what: 'a number of degrees', min, max });
const pixels = (doc) => number(doc, { what: 'a whole number of pixels', min: 1, max: 8192, integer: true }).default(512);

const size = object('Size of the image', { width: pixels('Pixels'), height: pixels('Pixels') }).prefault({});

const projection = choice('Perspective with `fovY`, or orthographic', ['perspective', 'orthographic']);
const fovY = degrees('Vertical field of view in degrees, perspective only; default 30', 0.001, 179.999);
const fit = number('Part of the frame that the model takes in its tighter dimension; more than 1 cuts it', { min: 1e-6, max: 100 });

const PART_NODE = 'the index or the name of a node in the model';
const PART_MATERIAL = 'the index or the name of a material in the model';
const FRAME = '"scene", "model", {node} or {material}';
/** What a view frames: parseable on its own, as what a part measures must be known before the rest of the shot. */
export const frameSchema = z.union([
  z.enum(['scene', 'model'], { error: FRAME }),
  object('The nodes of this name, with all beneath them', { node: indexOrName('Index or name of a node', PART_NODE) }),
  object('All that is drawn with the materials of this name', { material: indexOrName('Index or name of a material', PART_MATERIAL) }),
], { error: FRAME }).describe('What is framed: "scene", the model with the shadow that it throws on the ground, where that is at most three times as '
  + 'long as the model; "model", without the shadow; or a part of the model by name').default('scene');

const viewCamera = object('A view that frames the model', {
  view: choice('Named view; the front faces +Z, "right" is seen from +X', Object.keys(VIEWS)).optional(),
  azimuth: degrees('Instead of `view`: degrees about +Y, 0 = from +Z, 90 = from +X', -360, 360).optional(),
  elevation: degrees('Instead of `view`: degrees above the horizon, 90 = from +Y', -90, 90).optional(),
  projection: projection.default('perspective'),
  fovY: fovY.optional(),
  fit: fit.default(0.9),
  frame: frameSchema,
  fitTo: choice('What must fit: this "view"; every turn about the vertical axis at this elevation, "turntable"; or "all" directions. Views of one '
    + 'model that share it share one scale', FITS).default('view'),
});

const explicitCamera = object('A camera placed by the caller', {
  projection: projection.optional(),
  position: vector('Where the camera stands, metres'),
  target: vector('The point at the centre of the frame, metres'),
  up: vector('Direction that is up in the image', 'three numbers [x, y, z]').default([0, 1, 0]),
  fovY: fovY.optional(),
  height: number('Height of the frame in metres, orthographic only', { what: 'a height in metres', min: TINY }).optional(),
  near: number('Distance of the near plane in metres; fitted to the model by default',
    { what: 'a distance in metres', min: -HUGE }).optional(),
  far: number('Distance of the far plane in metres; fitted to the model by default',
    { what: 'a distance in metres', min: -HUGE }).optional(),
});

const CAMERA_INDEX = 'the index or the name of a camera in the model';
const gltfCamera = object('A camera of the model', {
  gltf: indexOrName('Index or name of a camera in the model', CAMERA_INDEX),
});

const camera = z.union([explicitCamera, gltfCamera, viewCamera], { error: 'an object' })
  .describe('A named view or angles that frame the model, an explicit camera, or one of the model\'s').prefault({});

const MAP = '"studio", "none", a path that ends in .hdr or .exr, or bytes';
const environmentMap = z.union([
  z.string({ error: MAP }).regex(/^(?:studio|none|[^\u0000-\u001f\u007f\ud800-\udfff]*\.(?:hdr|exr|HDR|EXR))$/u, { error: MAP }),
  z.custom((value) => value instanceof Uint8Array, { error: MAP }).meta({ tsType: 'Uint8Array' }),
], { error: MAP }).describe('"studio" (bundled), "none", or an equirectangular .hdr or .exr map: path, or bytes in JavaScript. '
  + 'What texels have above 65504 lights every shading but "three"');

const environment = z.union([environmentMap, object('Environment with settings', {
  map: environmentMap.default('studio'),
  intensity: number('Factor on its radiance', { min: 0 }).default(1),
  rotation: degrees('Degrees about +Y', -360, 360).default(0),
})], { error: MAP }).describe('Light from all around').default('studio');

const light = {
  color: colour('CSS colour (sRGB) or linear [r, g, b]').prefault('white'),
  intensity: (unit) => number(`Intensity in ${unit}`, { min: 0 }).default(1),
  position: (xyz) => vector('Metres').default(xyz),
  target: vector('Point that the light shines at, metres').default([0, 0, 0]),
  range: number('Distance in metres at which the light ends; 0 = never', { what: 'a distance in metres', min: 0 }).default(0),
};
const lightOf = (type, doc, shape) => object(doc, { type: z.literal(type).describe(doc), color: light.color, ...shape }, 'a light');

/** Largest edge or radius of an area light: its area and its squared distances stay inside the range of 32-bit floats. */
const EDGE_MAX_M = 1e6;
const edge = (doc) => number(doc, { what: 'a length in metres', above: 0, max: EDGE_MAX_M }).default(10);

/** Least part of a spot's cone: the tangent of half of it divides. */
const FOCUS_MIN = 1e-9;

const TEXELS = 'a whole number of texels';
const metres = (doc) => number(doc, { what: 'a number of metres', min: -HUGE }).optional();
const shadow = (doc, shape) => object(doc, {
  mapSize: number('Texels on a side of the map; default 1024', { what: TEXELS, min: 16, max: 4096, integer: true }).optional(),
  radius: number('Softness: radius of the filter in texels; default 2', { what: 'a number of texels', min: 0, max: 25 }).optional(),
  intensity: number('Part of the light that the shadow takes; default 1', { min: 0, max: 1 }).optional(),
  bias: number('Added to the depth 0..1 that is compared; default one texel', { min: -1, max: 1 }).optional(),
  normalBias: number('Metres along the normal to the point that is compared; default as wide as the filter', { min: 0 }).optional(),
  near: metres('Distance in metres at which the map begins; fitted to the model by default'),
  far: metres('Distance in metres at which the map ends; fitted to model and ground by default'),
  ...shape,
}).optional();
const SHADOW = 'Settings of the shadow, as three.js has them; needs castShadow';
const castShadow = boolean('Whether the model casts a shadow in this light').default(false);
const shadows = {
  directional: { castShadow, shadow: shadow(SHADOW, {
    left: metres('Left border of the map, metres from `position`; fitted to the model by default'),
    right: metres('Right border'), bottom: metres('Lower border'), top: metres('Upper border'),
  }) },
  spot: { castShadow, shadow: shadow(SHADOW, {
    focus: number('Part of the cone\'s angle that the map holds; as much as the model needs by default', { min: FOCUS_MIN, max: 1 }).optional(),
  }) },
  point: { castShadow, shadow: shadow(SHADOW, {}) },
};

const LIGHT_TYPES = '"ambient", "hemisphere", "directional", "point", "spot", "rect" or "disk"';
const lights = z.array(z.discriminatedUnion('type', [
  lightOf('ambient', 'Light from everywhere', { intensity: light.intensity('irradiance') }),
  lightOf('hemisphere', 'Light from above in `color`, from below in `groundColor`', {
    intensity: light.intensity('irradiance'),
    groundColor: colour('Colour from below').prefault('white'),
  }),
  lightOf('directional', 'Parallel light from `position` towards `target`', {
    intensity: light.intensity('lux'), position: light.position([0, 1, 0]), target: light.target,
    ...shadows.directional,
  }),
  lightOf('point', 'Light from a point', {
    intensity: light.intensity('candela'), position: light.position([0, 0, 0]), range: light.range,
    ...shadows.point,
  }),
  lightOf('spot', 'Cone of light from `position` towards `target`', {
    intensity: light.intensity('candela'), position: light.position([0, 1, 0]), target: light.target, range: light.range,
    angle: number('Outer half-angle of the cone in radians', { what: 'a number of radians', above: 0, max: Math.PI / 2 })
      .default(Math.PI / 3),
    penumbra: number('Part of the cone that fades out', { min: 0, max: 1 }).default(0),
    ...shadows.spot,
  }),
  lightOf('rect', 'Rectangle at `position` that shines to one side, towards `target`; its width lies level', {
    intensity: light.intensity('nit'), position: light.position([0, 1, 0]), target: light.target,
    width: edge('Metres'), height: edge('Metres'),
  }),
  lightOf('disk', 'Disk at `position` that shines to one side, towards `target`; stock three.js has no such light', {
    intensity: light.intensity('nit'), position: light.position([0, 1, 0]), target: light.target,
    radius: number('Metres', { what: 'a length in metres', above: 0, max: EDGE_MAX_M }).default(1),
  }),
], { error: ({ code }) => (code === 'invalid_union' ? LIGHT_TYPES : 'an object') }), { error: 'a list of lights' }).describe('Lights beside the environment and the model\'s own').prefault([]);

const GROUND = '"none" or {shadow, opacity}';
const LENGTHS = 'two lengths [x, z] in metres';
const extent = z.number({ error: LENGTHS }).min(TINY, { error: LENGTHS }).max(HUGE, { error: LENGTHS });
const ground = z.union([
  z.literal('none', { error: GROUND }),
  object('Ground beneath the model that shows nothing but shadows', {
    shadow: z.literal(true, { error: 'true' }).describe('Show shadows').default(true),
    opacity: number('Opacity of a full shadow', { min: 0, max: 1 }).default(0.5),
    position: vector('Its centre, metres; default the model\'s lowest point').optional(),
    size: z.tuple([extent, extent], { error: LENGTHS }).describe('Metres along x and z; default as wide as the shadows fall').optional(),
  }),
], { error: GROUND }).describe('Shadow catcher beneath the model; where no light of the shot casts a shadow, soft light from above does')
  .default('none');

/** What the raster renderer does for each quality. */
export const PRESETS = Object.freeze({
  standard: { samples: 4, resolve: 'encoded', noise: 0, environmentSamples: 0 },
  draft: { samples: 1, resolve: 'encoded', noise: 0, environmentSamples: 0 },
  high: { samples: 1024, resolve: 'linear', noise: 1.25, environmentSamples: 2048 },
});

/** What quality.samples may be. */
export const SAMPLE_COUNTS = [1, 4, 16, 64, 256, 1024];

/** Samples of a pixel that one pass over the model takes: more take several passes. */
export const SAMPLES_OF_A_PASS = 4;

const PRESET = '"standard", "draft", "high" or "reference"';
const QUALITY = '"standard", "draft", "high", "reference", {samples, resolve, noise, environmentSamples} or {preset: "reference", ...}';
const SAMPLES = '1, 4, 16, 64, 256 or 1024 samples a pixel';
const quality = z.union([
  z.enum([...Object.keys(PRESETS), 'reference'], { error: QUALITY }),
  object('Explicit settings', {
    preset: z.enum(Object.keys(PRESETS), { error: PRESET }).describe('Settings to start from').optional(),
    samples: z.literal(SAMPLE_COUNTS, { error: SAMPLES })
      .describe('Antialiasing samples a pixel; more than 4 shade as often, and read textures unfiltered').optional(),
    resolve: choice('What the samples of a pixel are averaged in: "encoded" values, as a browser does, or "linear" light before tone '
      + 'mapping; default "encoded", "linear" for more than 4 samples', ['encoded', 'linear']).optional(),
    noise: number('Standard error of a pixel, in 1/255 of its encoded value, at which it takes no more samples; 0 = every pixel takes all. '
      + 'For more than 4 samples', { min: 0, max: 64 }).optional(),
    environmentSamples: number('Directions in which all samples of a pixel look up the environment for the material itself; 0 = prefiltered '
      + 'maps, as three.js has them', { what: 'a whole number of directions', min: 0, max: 4096, integer: true }).optional(),
  }),
  referenceQuality,
], { error: QUALITY }).describe('"draft": 1 sample a pixel; "standard": 4, as a browser shows it; "high": up to 1024, averaged in linear light, '
  + 'and the environment integrated with the material; "reference": traced paths of light, slow and without GL').default('standard');

const LAYERS = '["beauty"]';
const layers = z.array(z.literal('beauty', { error: LAYERS }), { error: LAYERS }).length(1, { error: LAYERS })
  .describe('Images to draw').default(['beauty']);

const BIT_DEPTHS = '8, 16 or 32 bits a channel';
const output = object('The encoded file', {
  format: choice('File format', ['png', 'jpeg', 'webp', 'tiff', 'exr', 'raw']).default('png'),
  quality: number('Quality of JPEG and WebP', { what: 'a whole number', min: 1, max: 100, integer: true }).default(90),
  bitDepth: z.literal([8, 16, 32], { error: BIT_DEPTHS })
    .describe('Bits a channel: png and tiff 8 or 16, jpeg and webp 8, exr 16 or 32 (float), raw 8 or 32 (float); default the first')
    .optional(),
  ppi: number('Pixels per inch written to the file; 0 = none', { min: 0, max: 65535 }).default(0),
  icc: boolean('Embed an sRGB profile: png, tiff, jpeg').default(false),
}).prefault({});

const environmentBackground = object('The environment, blurred', {
  type: z.literal('environment', { error: '"environment"' }).describe('The environment').default('environment'),
  blur: number('0 shows it sharp, 1 as a matt surface sees it: scene.backgroundBlurriness of three.js', { min: 0, max: 1 }).default(0),
});
const BACKGROUND = expectedColour(['transparent', 'environment'], ['{type: "environment", blur}']);
const background = z.union([colour('Keyword or colour', ['transparent', 'environment'], BACKGROUND), environmentBackground], { error: BACKGROUND })
  .describe('"transparent", "environment", a colour, or the environment blurred; default "transparent", white for jpeg');
const ANIMATION = 'the index or the name of an animation in the model';
export const poseSchema = object('A moment of an animation', {
  animation: indexOrName('Index or name of an animation in the model', ANIMATION),
  time: number('Seconds from its start; before the start and after the end it stands as at the start or the end',
    { what: 'a number of seconds', min: -HUGE }).default(0),
}).nullable().default(null).describe('A moment of one of the model\'s animations; null = as the file stands');

const SHADING = '"three", "fabric", "three-r115", "disney-2012" or {base, <slot>: <term>}';
const shading = z.union([
  z.enum([...WITHOUT_TERMS, ...BASES], { error: SHADING }),
  object('A principled shading with terms swapped', {
    base: choice('Shading that the other slots are taken from', BASES),
    ...Object.fromEntries(Object.entries(SLOTS).map(([slot, terms]) => [slot, choice(`Term of the slot: js/docs/shading.md`, terms).optional()])),
  }),
], { error: SHADING }).describe('"three": what stock three.js shows; "fabric": telar\'s model of cloth; "three-r115": what three.js showed in 2020; "disney-2012": Burley\'s principled model; or terms of these by name')
  .default('three');

export const shotSchema = object('What to draw', {
  size,
  camera,
  lens: lensSchema,
  environment,
  lights,
  modelLights: boolean('Use the lights in the model').default(true),
  background: background.optional(),
  ground,
  shading,
  toneMapping: choice('As in three.js', ['neutral', 'none', 'linear', 'reinhard', 'cineon', 'aces', 'agx']).default('neutral'),
  exposure: number('Factor on radiance before tone mapping', { min: 0 }).default(1),
  quality,
  variant: text('Name of a material variant of the model (KHR_materials_variants); "" = none', 'the name of a variant').default(''),
  pose: poseSchema,
  layers,
  output,
});
