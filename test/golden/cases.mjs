// Pictures whose look is accepted: small, one subject each, drawn by Mesa's llvmpipe.
import { readFileSync } from 'node:fs';
import { ENVIRONMENTS, MODELS } from '../fixtures/index.mjs';

const tshirt = () => readFileSync(new URL('../../js/assets/tshirt.glb', import.meta.url));
const fabrics = () => readFileSync(new URL('../../js/assets/fabrics.glb', import.meta.url));
const sun = [
  { type: 'directional', position: [2, 3, 4], intensity: 2 },
  { type: 'ambient', intensity: 0.4 },
];

/** @type {Record<string, {model: () => Promise<Uint8Array> | Uint8Array, shot: object}>} */
export const GOLDENS = {
  'tshirt-front': { model: tshirt, shot: {} },
  'tshirt-back-indigo': { model: tshirt, shot: { camera: { view: 'back' }, variant: 'indigo', background: '#eceae6' } },
  'tshirt-three-quarter-terracotta': { model: tshirt, shot: { camera: { view: 'three-quarter' }, variant: 'terracotta' } },
  sweep: { model: MODELS.sweep, shot: {} },
  cloth: { model: MODELS.cloth, shot: { camera: { view: 'three-quarter' } } },
  'alpha-blend': { model: MODELS['alpha-blend'], shot: { environment: 'none', lights: sun } },
  'alpha-mask': { model: MODELS['alpha-mask'], shot: { environment: 'none', lights: sun } },
  transforms: { model: MODELS.transforms, shot: { camera: { projection: 'orthographic', view: 'three-quarter' } } },
  'model-lights': { model: MODELS['model-lights'], shot: { environment: 'none', camera: { view: 'three-quarter' } } },
  'environment-background': {
    model: MODELS['ball-mirror'],
    shot: { environment: { map: ENVIRONMENTS.lamps(), rotation: 40 }, background: 'environment', toneMapping: 'agx' },
  },
  'rect-light': {
    model: MODELS['clearcoat-normal'],
    shot: {
      environment: { map: ENVIRONMENTS.lamps(), intensity: 0.3 },
      background: { blur: 0.4 },
      lights: [{ type: 'rect', position: [1.2, 1, 2], width: 1.2, height: 0.8, intensity: 6 }],
    },
  },
  transmission: { model: MODELS['transmission-order'], shot: { lights: sun } },
  'velvet-three-r115': { model: fabrics, shot: { variant: 'velvet', lights: sun, shading: 'three-r115' } },
  'velvet-disney-2012': { model: fabrics, shot: { variant: 'velvet', lights: sun, shading: 'disney-2012' } },
  'leather-three-r115': { model: fabrics, shot: { variant: 'leather', lights: sun, shading: 'three-r115' } },
  'leather-disney-2012': { model: fabrics, shot: { variant: 'leather', lights: sun, shading: 'disney-2012' } },
  'physical-everything': { model: MODELS['physical-everything'], shot: { lights: sun } },
};

/** The shot of a golden: every default, at 160 x 160. */
export const goldenShot = ({ shot }) => ({ size: { width: 160, height: 160 }, ...shot });
export const goldenFile = (name) => new URL(`images/${name}.png`, import.meta.url);
