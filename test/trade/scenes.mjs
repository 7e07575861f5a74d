import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { benchLights, clothModels, fileModels, scenesOf } from '../../js/trade/index.mjs';
import { jacket, skirt } from '../fixtures/garments/index.mjs';
import { ENVIRONMENTS } from '../fixtures/index.mjs';

/** Scenes that the predictions are made from, and others that they are judged by: no cloth and no model is in both. */

const TSHIRT = fileURLToPath(new URL('../../js/assets/tshirt.glb', import.meta.url));
const SKIES = ['soft-studio', 'sunny-sky', 'overcast-sky'];

const KNOWN = [
  ...['cotton-jersey', 'denim', 'velvet', 'satin', 'waxed-cotton', 'nylon-shell', 'lace', 'sequin-thread', 'cable-knit'],
  ...['athletic-mesh', 'wool-felt', 'tweed', 'patent-leather', 'rib-knit', 'chiffon', 'fleece', 'quilted-nylon'],
];
const HELD_OUT = ['towel', 'silk', 'leather', 'tulle', 'twill', 'linen', 'corduroy', 'seersucker', 'boucle', 'suede', 'organza'];

/** A cloth of each kind of surface, for garments: times go by triangles, and the drape always has as many. */
const WORN = { fit: ['waxed-cotton', 'wool-felt', 'satin', 'lace', 'sequin-thread'], heldOut: ['leather', 'linen', 'corduroy'] };

const wearing = (garments, cloths) =>
  garments.flatMap((garment) => cloths.map((preset) => ({ ...garment, name: `${garment.name} in ${preset}`, shot: { materials: { '*': { preset } } } })));

/** A fixture as a file. @param {string} folder @param {string} name @param {Uint8Array} bytes @returns {string} its path */
function fileIn(folder, name, bytes) {
  const file = path.join(folder, name);
  writeFileSync(file, bytes);
  return file;
}

/** Part of the hash of a name in [0, 1), for an order that mixes everything: what is measured of a part of them stands for all. */
const place = (name) => [...name].reduce((hash, letter) => (Math.imul(hash, 31) + letter.charCodeAt(0)) >>> 0, 7) / 2 ** 32;
const mixed = (scenes) =>
  scenes.toSorted(
    (a, b) => place(JSON.stringify([a.model, a.light, a.shot.size, a.shot.shading])) - place(JSON.stringify([b.model, b.light, b.shot.size, b.shot.shading])),
  );

/** @param {string} folder for skies and garments @returns {Promise<{fit: object[], heldOut: object[]}>} scenes of js/trade */
export async function tradeScenes(folder) {
  mkdirSync(folder, { recursive: true });
  const jackets = fileModels([fileIn(folder, 'jacket.glb', await jacket())]);
  const skirts = fileModels([fileIn(folder, 'skirt.glb', await skirt())]);
  const lights = benchLights(['studio', 'sun', ...SKIES.map((name) => fileIn(folder, `${name}.hdr`, ENVIRONMENTS[name]()))]);
  const [studio, sun, soft, sunny, overcast] = lights;
  const cross = (models, some, sizes, shadings = ['fabric']) => scenesOf({ models, lights: some, sizes, shadings });
  const known = clothModels(KNOWN);
  const others = clothModels(HELD_OUT);
  const shirt = fileModels([TSHIRT]);
  const turned = (list, i) => list[i % list.length];
  return {
    fit: mixed([
      ...cross(known, [studio, sun, soft, sunny], [256]),
      ...known.flatMap((model, i) => cross([model], [turned(lights, i)], [512])),
      ...known.flatMap((model, i) => (i % 3 === 0 ? cross([model], [turned(lights, i)], [1024]) : [])),
      ...cross(known.slice(0, 8), [overcast], [256]),
      ...cross(known.slice(0, 8), [studio], [256], ['three']),
      ...cross(known.slice(0, 4), [sunny], [512], ['three']),
      ...cross(wearing(jackets, WORN.fit), [studio, sun, sunny], [256]),
      ...wearing(skirts, WORN.fit).flatMap((model, i) => cross([model], [turned(lights, i)], [512])),
      ...cross(jackets, [studio], [256], ['three']),
      ...cross(jackets, [sun], [512], ['three']),
      ...cross(skirts, [studio], [512], ['three']),
      ...cross(skirts, [sun], [256], ['three']),
    ]),
    heldOut: mixed([
      ...others.flatMap((model, i) => [
        ...cross([model], [turned(lights, i), turned(lights, i + 2)], [256]),
        ...cross([model], [turned(lights, i + 1)], [turned([384, 512, 1024], i)]),
      ]),
      ...cross(shirt, [studio, sunny], [256, 512]),
      ...cross(others.slice(0, 3), [studio], [256], ['three']),
      ...cross(shirt, [studio], [256, 512], ['three']),
      ...wearing(shirt, WORN.heldOut).flatMap((model, i) => cross([model], [turned(lights, i)], [256])),
    ]),
  };
}
