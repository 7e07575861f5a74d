import { resolveShot } from '../../shot/index.mjs';
import { LIGHTS } from '../../shot/table/lights.mjs';

/** Resolved shots for the tests of the C++ that reads them: what resolveShot writes, every key among them. */

const BOX = { min: [-0.4, 0.1, -0.15], max: [0.42, 0.82, 0.17] };
const camera = { position: [0, 1, 5], target: [0, 1, 0], near: 0.5, far: 9 };

/** Where a light has a shadow, with it. */
const lightOf = ([type, { shape }]) => ({ type, ...(shape.position && { position: [1, 3, 2] }), ...(shape.castShadow && { castShadow: true }) });

/** By name: a shot without keys but for its camera, and others that have what it has not. */
const SHOTS = {
  standard: { camera, size: { width: 512, height: 256 } },
  full: {
    camera: { ...camera, projection: 'orthographic', height: 2.5 },
    lens: { aperture: 16, shutter: 0.01, iso: 100 },
    lights: Object.entries(LIGHTS).map(lightOf),
    ground: {},
    background: { blur: 0.25 },
    shading: 'disney-2012',
    pose: { animation: 2, time: 0.25 },
    quality: 'reference',
  },
};

/** @returns {string} test/cpp/shot/resolved_shots.json */
export const resolvedShots = () =>
  `${JSON.stringify(Object.fromEntries(Object.entries(SHOTS).map(([name, shot]) => [name, resolveShot(shot, BOX)])), null, 2)}\n`;
