import { degrees } from './camera.mjs';
import { ENVIRONMENTS } from './environments.mjs';
import { HUGE, TINY, bytes, colour, expectedColour, extents, indexOrName, literal, number, object, text, union, vector } from './rows.mjs';

/** Rows of `lens`, `environment`, `background`, `ground` and `pose`: what stands around the model, and how it stands. */

const FOCUS = 'a distance in metres in [1e-30, 1e30] or "target"';
const distance = number('Metres', { what: 'a distance in metres', unit: 'metres', min: TINY, expected: FOCUS });

export const lens = object(
  'A photographic lens: exposure by EV100, and depth of field in quality "reference"; null = a pinhole',
  {
    aperture: number('f-number: focal length over the width of the opening', { what: 'an f-number', unit: 'f-number', min: 0.1, max: 1000 }),
    shutter: number(
      'Seconds that the shutter is open; with `iso` it exposes by EV100, a factor beside `exposure`; none = the lens does not change the exposure',
      { what: 'a number of seconds', unit: 'seconds', above: 0, max: 86400, nullable: true, optional: true },
    ),
    iso: number('Sensitivity, ISO', { what: 'a sensitivity', unit: 'ISO', above: 0, max: 1e7, nullable: true, optional: true }),
    focusDistance: union(
      'Distance in metres, along the view, of what is sharp, or "target": the camera\'s target; quality "reference" blurs the rest, ' +
        'the raster does not. None = all is sharp',
      [distance, literal('', 'target', FOCUS)],
      FOCUS,
      { nullable: true, optional: true, resolved: distance },
    ),
  },
  { name: 'Lens', nullable: true, default: null },
);

const part = (doc, byDefault) => number(doc, { unit: 'part', min: 0, max: 1, default: byDefault });

export const metering = object(
  'Exposure by what the picture shows: a factor beside `exposure` that brings the luminance of its brighter parts to a level; null = none',
  {
    percentile: part('Part of the pixels of the model that are darker: the 5 % below are brought to the level', 0.98),
    level: number('Luminance before tone mapping that it is brought to', { unit: 'factor', min: 1e-3, max: 1e3, default: 0.8 }),
    least: number('Least factor', { unit: 'factor', min: 1e-3, max: 1, default: 0.5 }),
    most: number('Largest factor, so that black cloth stays black', { unit: 'factor', min: 1, max: 1e3, default: 1.25 }),
  },
  { name: 'Metering', nullable: true, default: null, drawn: false },
);

const NAMES = Object.keys(ENVIRONMENTS);
const MAP = `${NAMES.map((name) => `"${name}"`).join(', ')}, a path that ends in .hdr or .exr, or bytes`;
const map = union(
  '"studio" (bundled), "none", or an equirectangular .hdr or .exr map: path, or bytes in JavaScript. ' +
    'What texels have above 65504 lights every shading but "three"',
  [text('', MAP, { pattern: new RegExp(`^(?:${NAMES.join('|')}|[^\\u0000-\\u001f\\u007f\\ud800-\\udfff]*\\.(?:hdr|exr|HDR|EXR))$`, 'u') }), bytes('', MAP)],
  MAP,
);

/** The environment with its settings. */
export const ENVIRONMENT = object(
  'Environment with settings',
  {
    map: Object.freeze({ ...map, default: 'studio' }),
    intensity: number('Factor on its radiance', { unit: 'factor', min: 0, default: 1 }),
    rotation: degrees('Degrees about +Y', -360, 360, { default: 0 }),
  },
  { name: 'Environment' },
);
export const environment = union('Light from all around', [map, ENVIRONMENT], MAP, { default: 'studio', resolved: ENVIRONMENT });

const KEYWORDS = ['transparent', 'environment'];
const BACKGROUND = expectedColour(KEYWORDS, ['{type: "environment", blur}']);
const blurred = object(
  'The environment, blurred',
  {
    type: literal('The environment', 'environment', '"environment"', { default: 'environment' }),
    blur: number('0 shows it sharp, 1 as a matt surface sees it: scene.backgroundBlurriness of three.js', { unit: 'roughness', min: 0, max: 1, default: 0 }),
  },
  { name: 'EnvironmentBackground' },
);
export const background = union(
  '"transparent", "environment", a colour, or the environment blurred; default "transparent", white for jpeg',
  [colour('Keyword or colour', { keywords: KEYWORDS, expected: BACKGROUND }), blurred],
  BACKGROUND,
  { optional: true },
);

const GROUND_WORDS = '"none" or {shadow, opacity, gap}';
/** The ground where there is one. */
export const GROUND = object(
  'Ground beneath the model that shows nothing but shadows',
  {
    shadow: literal('Show shadows', true, 'true', { default: true }),
    opacity: number('Opacity of a full shadow', { unit: 'part', min: 0, max: 1, default: 0.5 }),
    gap: number('How far below the model it lies, of one that hangs, in heights of the model', {
      unit: "part of the model's height",
      min: 0,
      max: 1,
      default: 0,
      drawn: false,
    }),
    position: vector("Its centre, metres; default the model's lowest point less the gap", { optional: true }),
    size: extents('Metres along x and z; default as wide as the shadows fall', { optional: true }),
  },
  { name: 'Ground' },
);
export const ground = union(
  'Shadow catcher beneath the model; where no light of the shot casts a shadow, soft light from above does',
  [literal('', 'none', GROUND_WORDS), GROUND],
  GROUND_WORDS,
  { default: 'none' },
);

export const POSE = object(
  "A moment of one of the model's animations; null = as the file stands",
  {
    animation: indexOrName('Index or name of an animation in the model', 'the index or the name of an animation in the model'),
    time: number('Seconds from its start; before the start and after the end it stands as at the start or the end', {
      what: 'a number of seconds',
      unit: 'seconds',
      min: -HUGE,
      default: 0,
    }),
  },
  { name: 'Pose', nullable: true, default: null },
);
