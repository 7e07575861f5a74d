// What a view frames: a part by its name, a shadow, several turns at one scale, more than the frame holds.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { factsOf } from '../../js/three/index.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { LIGHTS, shot } from './shot.mjs';

const MODEL = 'parts';
const bytes = await MODELS[MODEL]();
const model = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');

/** @returns {import('./cases.mjs').Case} */
function make(name, camera, overrides = {}) {
  const settings = { lights: [LIGHTS.ambient, LIGHTS.directional], camera: { view: 'three-quarter', ...camera }, ...overrides };
  const facts = factsOf(model, { THREE, frame: camera.frame, variant: overrides.variant });
  return { name, model: MODEL, shot: shot(settings, facts), fast: name === 'frame-node' };
}

/** @type {import('./cases.mjs').Case[]} */
export const CASES = [
  make('frame-node', { frame: { node: 'Sleeve' } }),
  make('frame-material', { frame: { material: 'Brass' }, projection: 'orthographic', fit: 0.3 }),
  make('frame-fit-above-1', { fit: 1.6 }),
  make('frame-turntable', { azimuth: 100, elevation: 20, view: undefined, fitTo: 'turntable' }, { ground: {} }),
  make('frame-all', { view: 'top', fitTo: 'all' }),
  make('frame-shadow', {}, { ground: { opacity: 0.8 }, lights: [LIGHTS.ambient, { ...LIGHTS.directional, position: [-1.5, 2, -2], castShadow: true }] }),
  make('frame-metered', {}, { ground: { opacity: 0.8 }, background: '#e0e0e0', metering: { level: 0.5 } }),
];
