import { FITS, VIEWS } from '../frame.mjs';
import { material, node } from './parts.mjs';
import { HUGE, TINY, but, choice, indexOrName, literal, number, object, union, variants, vector } from './rows.mjs';

/** Rows of `camera`. */

/** An angle as the shot writes it. */
export const degrees = (doc, min, max, rest) => number(doc, { what: 'a number of degrees', unit: 'degrees', min, max, ...rest });

const projection = choice('Perspective with `fovY`, or orthographic', ['perspective', 'orthographic'], { name: 'Projection' });
export const DEFAULT_FOV_Y = 30;
const fovY = degrees('Vertical field of view in degrees, perspective only', 0.001, 179.999, { otherwise: DEFAULT_FOV_Y });
const fit = number('Part of the frame that the model takes in its tighter dimension; more than 1 cuts it', {
  unit: 'part of the frame',
  min: 1e-6,
  max: 100,
  default: 0.9,
});

const FRAME = '"scene", "model", {node} or {material}';
/** What a view frames: parseable on its own, as what a part measures must be known before the rest of the shot. */
export const FRAME_ROW = union(
  'What is framed: "scene", the model with the shadow that it throws on the ground, where that is at most three times as ' +
    'long as the model; "model", without the shadow; or a part of the model by name',
  [
    choice('', ['scene', 'model'], { expected: FRAME }),
    object('The nodes of this name, with all beneath them', { node }),
    object('All that is drawn with the materials of this name', { material }),
  ],
  FRAME,
  { default: 'scene' },
);

const view = object('A view that frames the model', {
  view: choice('Named view; the front faces +Z, "right" is seen from +X', Object.keys(VIEWS), { optional: true }),
  azimuth: degrees('Instead of `view`: degrees about +Y, 0 = from +Z, 90 = from +X', -360, 360, { optional: true }),
  elevation: degrees('Instead of `view`: degrees above the horizon, 90 = from +Y', -90, 90, { optional: true }),
  projection: but(projection, { default: 'perspective' }),
  fovY,
  fit,
  frame: FRAME_ROW,
  fitTo: choice(
    'What must fit: this "view"; every turn about the vertical axis at this elevation, "turntable"; or "all" directions. Views of one ' +
      'model that share it share one scale',
    FITS,
    { default: 'view' },
  ),
});

const planeOf = (doc) =>
  number(`Distance of the ${doc} plane in metres; fitted to the model by default`, {
    what: 'a distance in metres',
    unit: 'metres',
    min: -HUGE,
    optional: true,
  });
const placed = {
  position: vector('Where the camera stands, metres'),
  target: vector('The point at the centre of the frame, metres'),
  up: vector('Direction that is up in the image', { expected: 'three numbers [x, y, z]', default: [0, 1, 0] }),
};
const height = number('Height of the frame in metres, orthographic only', { what: 'a height in metres', unit: 'metres', min: TINY, optional: true });
const planes = { near: planeOf('near'), far: planeOf('far') };

const explicit = object('A camera placed by the caller', { projection: but(projection, { optional: true }), ...placed, fovY, height, ...planes });

const gltf = object('A camera of the model', {
  gltf: indexOrName('Index or name of a camera in the model', 'the index or the name of a camera in the model'),
});

const OBJECT = 'an object';
const lensOf = (name, lens) =>
  object(`A camera with ${name} projection`, { projection: literal(projection.doc, name, JSON.stringify(name)), ...placed, ...lens, ...planes });

export const camera = union("A named view or angles that frame the model, an explicit camera, or one of the model's", [explicit, gltf, view], OBJECT, {
  default: {},
  resolved: variants('The camera', 'projection', { perspective: lensOf('perspective', { fovY }), orthographic: lensOf('orthographic', { height }) }, OBJECT, {
    name: 'Camera',
    choice: projection,
  }),
});
