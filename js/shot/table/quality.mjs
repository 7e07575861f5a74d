import { boolean, choice, literal, number, object, union } from './rows.mjs';

/** Rows of `quality`. */

/** What the raster renderer does for each quality; what no preset changes is written out by the rows below. */
export const PRESETS = Object.freeze({
  standard: { samples: 4, resolve: 'encoded', noise: 0, environmentSamples: 0, mergeQuads: false, denoise: false, shadowScale: 1 },
  draft: { samples: 1, resolve: 'encoded', noise: 0, environmentSamples: 0, mergeQuads: true, denoise: false, shadowScale: 1 },
  medium: { samples: 16, resolve: 'linear', noise: 0, environmentSamples: 32, mergeQuads: true, denoise: true, shadowScale: 2 },
  high: { samples: 1024, resolve: 'linear', noise: 2, environmentSamples: 2048, mergeQuads: true, denoise: true, shadowScale: 4 },
});

/** Samples of a pixel that one pass over the model takes: more take several passes. */
export const SAMPLES_OF_A_PASS = 4;

const PRESET = '"standard", "draft", "medium", "high" or "reference"';
const QUALITY =
  '"standard", "draft", "medium", "high", "reference", {samples, resolve, noise, environmentSamples, mergeQuads, ...}, {preset: "reference", ...}, {maxError} or {budgetMs}';

const whole = (doc, what, rest) => number(doc, { what: `a whole number${what}`, integer: true, ...rest });

/** Settings of the raster renderer. */
export const RASTER = object(
  'Explicit settings',
  {
    preset: choice('Settings to start from', Object.keys(PRESETS), { expected: PRESET, optional: true, stays: true, drawn: false }),
    samples: literal(
      'Antialiasing samples a pixel; more than 4 shade as often, and read textures unfiltered',
      [1, 4, 16, 64, 256, 1024],
      '1, 4, 16, 64, 256 or 1024 samples a pixel',
      { unit: 'samples a pixel', otherwise: PRESETS.standard.samples },
    ),
    resolve: choice(
      'What the samples of a pixel are averaged in: "encoded" values, as a browser does, or "linear" light before tone ' +
        'mapping; default "encoded", "linear" for more than 4 samples',
      ['encoded', 'linear'],
      { name: 'Resolve', optional: true },
    ),
    noise: number(
      'Standard error of a pixel, in 1/255 of its encoded value, at which it takes no more samples; 0 = every pixel takes all. For more than 16 samples',
      { unit: '1/255', min: 0, max: 64, otherwise: PRESETS.standard.noise },
    ),
    environmentSamples: number('Directions in which all samples of a pixel look up the environment for the material itself; 0 = prefiltered maps', {
      what: 'a whole number of directions',
      unit: 'directions a pixel',
      min: 0,
      max: 4096,
      integer: true,
      otherwise: PRESETS.standard.environmentSamples,
    }),
    mergeQuads: boolean('Shade triangles that share a vertex once where they meet in two by two pixels: each pixel shows one of them', {
      otherwise: PRESETS.standard.mergeQuads,
    }),
    denoise: boolean(
      'Take light from the passes as far as it stands out of their noise, and detail also from a picture of one pass, whose light is prefiltered; `noise` is then what that leaves. ' +
        'For more than 4 samples',
      { otherwise: PRESETS.standard.denoise },
    ),
    textureSize: whole('Most texels of the longer side of a texture: of larger ones the next mip level that fits is read; 0 = whole', ' of texels', {
      unit: 'texels',
      min: 0,
      max: 16384,
      otherwise: 0,
    }),
    environmentSize: literal(
      'Size of a face of the prefiltered environment: a smaller one tells fewer roughnesses apart; 0 = as in three.js, ' +
        'a quarter of the width of the map, at least 256. Atlases of releases of three.js before 0.187 have their own',
      [0, 64, 128, 256, 512, 1024],
      '0, 64, 128, 256, 512 or 1024 texels',
      { unit: 'texels', otherwise: 0 },
    ),
    prefilterSamples: literal(
      'Directions of each texel of the smooth levels of the prefiltered environment. Not of atlases of releases of three.js before 0.187',
      [16, 32, 64, 128, 256, 512, 1024, 2048, 4096],
      '16, 32, 64, 128, 256, 512, 1024, 2048 or 4096 directions',
      { unit: 'directions', otherwise: 256 },
    ),
    shadowScale: literal('Shadow maps have so many times the texels on a side, at most 4096 x 4096 together; shading "fabric" alone', [1, 2, 4], '1, 2 or 4', {
      unit: 'factor',
      otherwise: PRESETS.standard.shadowScale,
    }),
    maxLights: whole(
      'Most lights that shade the model and cast shadows: those that shine most on its middle, ambient and hemisphere lights aside. 0 = all',
      ' of lights',
      { unit: 'lights', min: 0, max: 4096, otherwise: 0 },
    ),
    transmissionScale: number("Size of the picture of what lies behind transmissive surfaces, as a part of the shot's", {
      unit: 'factor',
      min: 0.0625,
      max: 1,
      otherwise: 1,
    }),
    geometryError: number(
      'How far off a surface may lie that fewer triangles show, in pixels where the model is nearest to the camera; 0 = all are drawn. ' +
        'Meshes that morph or have bones are drawn whole',
      { unit: 'pixels', min: 0, max: 64, otherwise: 0 },
    ),
  },
  { name: 'RasterQuality' },
);

/** Settings of the path tracer. */
export const REFERENCE = object(
  'Settings of the path tracer',
  {
    preset: literal('The path tracer', 'reference', '"reference"'),
    samples: whole('Paths a pixel; the noise falls with the root of it', ' of paths a pixel', { unit: 'paths a pixel', min: 1, max: 65536, otherwise: 256 }),
    noise: number('Standard error of a pixel, in 1/255 of its encoded value, at which it takes no more paths, from 16 on; 0 = every pixel takes all', {
      unit: '1/255',
      min: 0,
      max: 64,
      otherwise: 0,
    }),
    seed: whole('The same seed gives the same bytes, with any number of threads', '', { unit: 'seed', min: 0, max: 1e9, otherwise: 1 }),
    transport: choice(
      '"global": all light, over `bounces` reflections; "occlusion": light that arrives directly, less what surfaces hide; ' +
        '"direct": the same with nothing hidden but the shadows that the shot asks for, as in the raster',
      ['global', 'occlusion', 'direct'],
      { name: 'Transport', otherwise: 'global' },
    ),
    bounces: whole('Reflections from surface to surface, "global" alone', ' of bounces', { unit: 'bounces', min: 0, max: 64, otherwise: 8 }),
    // 0 and not the number of cores: a resolved shot is the same on each machine.
    threads: whole('Threads that trace; 0 = one for each core', ' of threads', { unit: 'threads', min: 0, max: 256, otherwise: 0 }),
  },
  { name: 'ReferenceQuality' },
);

/** What the picture is to reach, whatever the settings: they are chosen when it is drawn (js/predict). */
const MAX_ERROR = object('Error that the picture may have', {
  maxError: number('Mean FLIP of the model against the path tracer; the cheapest settings are taken that are predicted to hold it for a scene of this kind', {
    unit: 'FLIP',
    above: 0,
    max: 1,
  }),
});
const BUDGET = object('Time that the picture may take', {
  budgetMs: number(
    'CPU milliseconds of all threads for drawing a loaded model; the most accurate settings are taken that are predicted to fit into it on this machine',
    { unit: 'ms', above: 0, max: 1e9 },
  ),
});

export const quality = union(
  '"draft": 1 sample a pixel, triangles that meet in it shaded once; "standard": 4, as a browser shows it; "medium": 16, averaged in linear light, with two directions of the environment each, and denoised; "high": 256 and where it is needed up to 1024, averaged in linear light, the environment integrated with the material, ' +
    'and denoised, by the tracer where that costs less; "reference": traced paths of light, slow and without GL',
  [choice('', [...Object.keys(PRESETS), 'reference'], { expected: QUALITY }), RASTER, REFERENCE, MAX_ERROR, BUDGET],
  QUALITY,
  { default: 'standard', resolved: union('', [RASTER, REFERENCE, MAX_ERROR, BUDGET], QUALITY) },
);
