import { HUGE, boolean, choice, colour, list, literal, number, object, variants, vector } from './rows.mjs';

/** Rows of `lights`. */

const color = (doc = 'CSS colour (sRGB) or linear [r, g, b]') => colour(doc, { default: 'white' });
const intensity = (unit) => number(`Intensity in ${unit}`, { unit, min: 0, default: 1 });
const position = (xyz) => vector('Metres', { default: xyz });
const target = vector('Point that the light shines at, metres', { default: [0, 0, 0] });
const range = number('Distance in metres at which the light ends; 0 = never', { what: 'a distance in metres', unit: 'metres', min: 0, default: 0 });

/** Largest edge or radius of an area light: its area and its squared distances stay inside the range of 32-bit floats. */
const EDGE_MAX_M = 1e6;
const edge = (value) => number('Metres', { what: 'a length in metres', unit: 'metres', above: 0, max: EDGE_MAX_M, default: value });

/** Least part of a spot's cone: the tangent of half of it divides. */
const FOCUS_MIN = 1e-9;

const part = (doc, rest) => number(doc, { unit: 'part', min: 0, max: 1, ...rest });
const metres = (doc, rest = {}) => number(doc, { what: 'a number of metres', unit: 'metres', min: -HUGE, optional: true, ...rest });

const shadowOf = (shape) =>
  object(
    'Settings of the shadow, as three.js has them; needs castShadow',
    {
      mapSize: number('Texels on a side of the map', { what: 'a whole number of texels', unit: 'texels', min: 16, max: 4096, integer: true, otherwise: 1024 }),
      radius: number('Softness: radius of the filter in texels', { what: 'a number of texels', unit: 'texels', min: 0, max: 25, otherwise: 2 }),
      intensity: part('Part of the light that the shadow takes', { otherwise: 1 }),
      bias: number('Added to the depth 0..1 that is compared; default one texel', { unit: 'part of the depth range', min: -1, max: 1, optional: true }),
      normalBias: number('Metres along the normal to the point that is compared; default as wide as the filter', { unit: 'metres', min: 0, optional: true }),
      near: metres('Distance in metres at which the map begins; fitted to the model by default'),
      far: metres('Distance in metres at which the map ends; fitted to model and ground by default'),
      ...shape,
    },
    { name: 'Shadow', optional: true, when: 'castShadow' },
  );

const castShadow = boolean('Whether the model casts a shadow in this light', { default: false });

/** What a light's shadow needs beside the rest, by the light's type. */
const SHADOWS = {
  directional: shadowOf({
    left: metres('Left border of the map, metres from `position`; fitted to the model by default'),
    right: metres('Right border'),
    bottom: metres('Lower border'),
    top: metres('Upper border'),
  }),
  point: shadowOf({}),
  spot: shadowOf({ focus: part("Part of the cone's angle that the map holds; as much as the model needs by default", { min: FOCUS_MIN, optional: true }) }),
};

const SHAPES = {
  ambient: ['Light from everywhere', { color: color(), intensity: intensity('irradiance') }],
  hemisphere: [
    'Light from above in `color`, from below in `groundColor`',
    {
      color: color(),
      intensity: intensity('irradiance'),
      groundColor: color('Colour from below'),
    },
  ],
  directional: [
    'Parallel light from `position` towards `target`',
    {
      color: color(),
      intensity: intensity('lux'),
      position: position([0, 1, 0]),
      target,
      castShadow,
      shadow: SHADOWS.directional,
    },
  ],
  point: [
    'Light from a point',
    {
      color: color(),
      intensity: intensity('candela'),
      position: position([0, 0, 0]),
      range,
      castShadow,
      shadow: SHADOWS.point,
    },
  ],
  spot: [
    'Cone of light from `position` towards `target`',
    {
      color: color(),
      intensity: intensity('candela'),
      position: position([0, 1, 0]),
      target,
      range,
      angle: number('Outer half-angle of the cone in radians', {
        what: 'a number of radians',
        unit: 'radians',
        above: 0,
        max: Math.PI / 2,
        default: Math.PI / 3,
      }),
      penumbra: part('Part of the cone that fades out', { default: 0 }),
      castShadow,
      shadow: SHADOWS.spot,
    },
  ],
  rect: [
    'Rectangle at `position` that shines to one side, towards `target`; its width lies level',
    {
      color: color(),
      intensity: intensity('nit'),
      position: position([0, 1, 0]),
      target,
      width: edge(10),
      height: edge(10),
    },
  ],
  disk: [
    'Disk at `position` that shines to one side, towards `target`; stock three.js has no such light',
    {
      color: color(),
      intensity: intensity('nit'),
      position: position([0, 1, 0]),
      target,
      radius: edge(1),
    },
  ],
};

const TYPES = Object.keys(SHAPES);
const named = TYPES.map((type) => JSON.stringify(type));

/** Lights by type. */
export const LIGHTS = Object.freeze(
  Object.fromEntries(
    Object.entries(SHAPES).map(([type, [doc, shape]]) => [
      type,
      object(doc, { type: literal(doc, type, JSON.stringify(type)), ...shape }, { expected: 'a light' }),
    ]),
  ),
);

export const lights = list(
  "Lights beside the environment and the model's own",
  variants('A light', 'type', LIGHTS, `${named.slice(0, -1).join(', ')} or ${named.at(-1)}`, {
    name: 'Light',
    choice: choice('Kind of light', TYPES, { name: 'Type' }),
  }),
  'a list of lights',
  { default: [] },
);
