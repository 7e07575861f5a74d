import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { LIGHTS, toldApart } from '../analyse/index.mjs';
import { TelarError } from '../error/index.mjs';
import { nearest, shown } from '../shot/complain.mjs';

/** What is drawn unless the user names models: the bundled drape in cloths of every class. */

const DRAPE = fileURLToPath(new URL('../assets/fabrics.glb', import.meta.url));
const CAMERA = { azimuth: 25, elevation: 22 };

/** A cloth of each kind of surface: smooth, of fine and of coarse relief, napped, coated, stretched highlights, cut out, glittering. */
export const CLOTHS = ['nylon-shell', 'denim', 'cable-knit', 'velvet', 'waxed-cotton', 'satin', 'lace', 'sequin-thread'];

/** Lights of a bench: all around, one lamp with shadows, none but a sky. */
export const BENCH_LIGHTS = ['studio', 'sun', 'sky'];

/** @param {string[]} cloths presets @returns {{name: string, source: string, shot: object}[]} */
export const clothModels = (cloths) => cloths.map((name) => ({ name, source: DRAPE, shot: { camera: CAMERA, materials: { '*': { preset: name } } } }));

/** @param {string[]} files */
export const fileModels = (files) => files.map((source) => ({ name: path.basename(source).replace(/\.(glb|gltf)$/i, ''), source, shot: {} }));

/**
 * @param {string[]} names of LIGHTS of telar analyse, or paths of .hdr and .exr environments
 * @throws {TelarError} E_USAGE
 */
export function benchLights(names) {
  return names.map((name) => {
    if (Object.hasOwn(LIGHTS, name)) return { name, shot: LIGHTS[name].shot };
    if (/\.(hdr|exr)$/i.test(name)) return { name: path.basename(name).replace(/\.\w+$/, ''), shot: { environment: name } };
    const near = nearest(name, Object.keys(LIGHTS));
    const hint = near ? `; did you mean ${near}?` : '';
    throw new TelarError('E_USAGE', `--environments: expected ${Object.keys(LIGHTS).join(', ')} or an .hdr or .exr file, got ${shown(name)}${hint}`);
  });
}

/**
 * Every model in every light, size and shading.
 * @param {{models: {name: string, source: string, shot: object}[], lights: {name: string, shot: object}[], sizes: number[], shadings: (string | object)[]}} plan
 * @returns {import('./measure.mjs').Scene[]}
 */
export const scenesOf = ({ models, lights, sizes, shadings }) =>
  toldApart(models).flatMap((model) =>
    toldApart(lights).flatMap((light) =>
      sizes.flatMap((side) =>
        shadings.map((shading) => ({
          model: model.name,
          light: light.name,
          source: model.source,
          shot: { ...model.shot, ...light.shot, size: { width: side, height: side }, shading },
        })),
      ),
    ),
  );
