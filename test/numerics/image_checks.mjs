// Invariants of whole pictures, from the file to the pixels: measured figures like those of telar_numerics.
import { hdr, lamps } from '../fixtures/environment.mjs';
import { closePlanes, pictureShot, ringIn, ringOnSheet, SHADINGS, SUN, square } from './scenes.mjs';

/**
 * @typedef {{what: string, shading: string, measured: number, low: number | null, high: number | null, points: number,
 *   where: string, holds: boolean}} Figure
 * @typedef {{topic: string, name: string, run: (renderer: object, options?: {shadings?: string[]}) => Promise<Figure[]>}} Check
 */

/** @returns {Figure} */
function figure(what, shading, measured, { low = null, high = null, points = 1, where = '' } = {}) {
  const holds = Number.isFinite(measured) && (low === null || measured >= low) && (high === null || measured <= high);
  return { what, shading, measured, low, high, points, where, holds };
}

/** Largest difference of two pictures' bytes, and how many pixels differ by more than `allowed`. */
function compared(a, b, allowed = 0) {
  let [largest, above] = [0, 0];
  for (let i = 0; i < a.length; i += 4) {
    let most = 0;
    for (let c = 0; c < 4; c++) most = Math.max(most, Math.abs(a[i + c] - b[i + c]));
    largest = Math.max(largest, most);
    above += most > allowed;
  }
  return { largest, above, pixels: a.length / 4 };
}

/** Pixels whose neighbours, two steps around, are of nearly their colour in the first picture: no edges. */
function interior(data, width) {
  const inside = [];
  const at = (x, y, c) => data[(y * width + x) * 4 + c];
  for (let y = 2; y < data.length / 4 / width - 2; y++) {
    for (let x = 2; x < width - 2; x++) {
      let spread = 0;
      for (let dy = -2; dy <= 2; dy++)
        for (let dx = -2; dx <= 2; dx++) for (let c = 0; c < 3; c++) spread = Math.max(spread, Math.abs(at(x + dx, y + dy, c) - at(x, y, c)));
      if (spread <= 12) inside.push((y * width + x) * 4);
    }
  }
  return inside;
}

const of = (data, offsets) => Uint8Array.from(offsets.flatMap((i) => [data[i], data[i + 1], data[i + 2], data[i + 3]]));

// A busy machine may take its time: the figures do not depend on it.
const render = async (renderer, model, shot) => (await renderer.render(model, pictureShot(shot), { timeoutMs: null })).data;

/** One model in other places and sizes, lit by the environment and a sun whose shadows it casts. */
const PLACES = [
  ['scale 1e-6', { scale: 1e-6 }],
  ['scale 1e6', { scale: 1e6 }],
  ['offset (1e6, -2e6, 5e5) m', { offset: [1e6, -2e6, 5e5] }],
];

async function scaleAndOffset(renderer, { shadings = SHADINGS } = {}) {
  const figures = [];
  for (const shading of shadings) {
    const shot = { shading, camera: { view: 'three-quarter' }, lights: [SUN], ground: {} };
    const expected = await render(renderer, await ringOnSheet(), shot);
    const inside = interior(expected, 128);
    for (const [name, place] of PLACES) {
      const actual = await render(renderer, await ringOnSheet(place), shot);
      const { largest } = compared(of(expected, inside), of(actual, inside));
      const all = compared(expected, actual, 1);
      figures.push(
        figure(`${name}: largest difference away from edges, of 255`, shading, largest, { high: 1, points: inside.length }),
        figure(`${name}: part of all pixels that differ by more than 1`, shading, all.above / all.pixels, { high: 0.01, points: all.pixels }),
      );
    }
  }
  return figures;
}

async function rotation(renderer, { shadings = SHADINGS } = {}) {
  const figures = [];
  for (const shading of shadings) {
    for (const turn of [37, 90]) {
      const [sin, cos] = [Math.sin((turn * Math.PI) / 180), Math.cos((turn * Math.PI) / 180)];
      const turned = ([x, y, z]) => [x * cos + z * sin, y, z * cos - x * sin];
      const shot = (around, degrees) => ({
        shading,
        camera: { position: around([1, 0.8, 3]), target: [0, 0, 0], fovY: 30, near: 1, far: 6 },
        environment: { map: lamps(256), rotation: degrees },
        lights: [{ ...SUN, position: around(SUN.position), castShadow: false }],
      });
      const expected = await render(
        renderer,
        await ringOnSheet(),
        shot((v) => v, 0),
      );
      const actual = await render(renderer, await ringOnSheet({ turn }), shot(turned, turn));
      const inside = interior(expected, 128);
      const { largest } = compared(of(expected, inside), of(actual, inside));
      figures.push(
        figure(`scene, lights, environment and camera turned by ${turn} degrees: largest difference away from edges, of 255`, shading, largest, {
          high: 1,
          points: inside.length,
        }),
      );
    }
  }
  return figures;
}

async function triangleOrder(renderer, { shadings = SHADINGS } = {}) {
  const figures = [];
  for (const shading of shadings) {
    const expected = await render(renderer, await ringIn('whole'), { shading, lights: [SUN] });
    for (const form of ['permuted', 'split']) {
      const { largest, pixels } = compared(expected, await render(renderer, await ringIn(form), { shading, lights: [SUN] }));
      figures.push(figure(`triangles ${form}: largest difference, of 255`, shading, largest, { high: 0, points: pixels }));
    }
  }
  return figures;
}

async function closeSurfaces(renderer) {
  const figures = [];
  for (const [name, camera] of [
    ['from the front', {}],
    ['at 45 degrees', { azimuth: 45, elevation: 20 }],
    ['from afar', { fit: 0.2 }],
  ]) {
    const data = await render(renderer, await closePlanes(), { camera, toneMapping: 'none' });
    let green = 0;
    for (let i = 0; i < data.length; i += 4) green += data[i + 1] > data[i] + 8;
    figures.push(figure(`planes 1e-4 m apart, ${name}: pixels of the hidden one`, '', green, { high: 0, points: data.length / 4 }));
  }
  return figures;
}

const meanOf = (data) => {
  const pixels = new Float32Array(data.buffer, data.byteOffset, data.byteLength / 4);
  let [sum, count] = [0, 0];
  for (let i = 0; i < pixels.length; i += 4) if (pixels[i + 3] === 1) [sum, count] = [sum + pixels[i + 1], count + 1];
  return sum / count;
};
const LINEAR = { background: 'transparent', output: { format: 'raw', bitDepth: 32 }, quality: 'draft' };

/** A parallel view straight at a plane, lit by a rectangle: three.js's frame has no direction there. */
async function straightRect(renderer, { shadings = SHADINGS } = {}) {
  const figures = [];
  for (const shading of shadings) {
    const lit = async (azimuth) =>
      meanOf(
        await render(renderer, await square(), {
          ...LINEAR,
          shading,
          environment: 'none',
          camera: { projection: 'orthographic', azimuth, elevation: 0 },
          lights: [{ type: 'rect', position: [0.3, 0.4, 1], width: 1, height: 1, intensity: 4 }],
        }),
      );
    const [straight, tilted] = [await lit(0), await lit(0.01)];
    figures.push(
      figure('rectangle light, parallel view straight at a plane against 0.01 degrees off: relative difference', shading, Math.abs(straight / tilted - 1), {
        high: 0.01,
      }),
    );
  }
  return figures;
}

/**
 * What is left of a sun of one texel that no half float can hold, against one that it can. Up to quality "standard" the
 * environment is what three.js has of it, in a browser as here; of "fabric" the sun is a light of its own.
 */
async function hotSun(renderer, { shadings = SHADINGS } = {}) {
  const figures = [];
  const sky = (radiance) => hdr(64, (_, u, v) => (Math.floor(u * 64) === 44 && Math.floor(v * 32) === 12 ? [radiance, radiance, radiance] : [0, 0, 0]));
  const [BELOW, ABOVE] = [6e4, 1.6e9];
  for (const shading of shadings) {
    for (const quality of ['standard', 'high']) {
      const lit = async (radiance) =>
        meanOf(
          await render(renderer, await square(), {
            ...LINEAR,
            quality,
            shading,
            exposure: 1 / radiance,
            environment: { map: sky(radiance), rotation: 0 },
            camera: { azimuth: 20, elevation: 10 },
          }),
        );
      const kept = (await lit(ABOVE)) / (await lit(BELOW));
      figures.push(
        figure(
          `sun of 1.6e9 in one texel of the environment, quality ${quality}: part of its light kept`,
          shading,
          kept,
          quality === 'high' || shading === 'fabric' ? { low: 0.99, high: 1.01 } : {},
        ),
      );
    }
  }
  return figures;
}

/** @type {Check[]} */
export const IMAGE_CHECKS = [
  { topic: 'Whole pictures', name: 'scale and offset', run: scaleAndOffset },
  { topic: 'Whole pictures', name: 'rotation', run: rotation },
  { topic: 'Whole pictures', name: 'order of triangles', run: triangleOrder },
  { topic: 'Whole pictures', name: 'close surfaces', run: closeSurfaces },
  { topic: 'Whole pictures', name: 'rectangle light straight ahead', run: straightRect },
  { topic: 'Whole pictures', name: 'sun beyond half floats', run: hotSun },
];
