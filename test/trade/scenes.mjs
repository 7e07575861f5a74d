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

/** The garments of test/fixtures as files. @param {string} folder */
async function garmentsIn(folder) {
  mkdirSync(folder, { recursive: true });
  const files = await Promise.all(
    Object.entries({ jacket, skirt }).map(async ([name, make]) => {
      const file = path.join(folder, `${name}.glb`);
      writeFileSync(file, await make());
      return file;
    }),
  );
  return fileModels(files);
}

/** The skies of test/fixtures as files. @param {string} folder @returns {{name: string, shot: object}[]} */
function skiesIn(folder) {
  mkdirSync(folder, { recursive: true });
  const files = SKIES.map((name) => {
    const file = path.join(folder, `${name}.hdr`);
    writeFileSync(file, ENVIRONMENTS[name]());
    return file;
  });
  return benchLights(files);
}

/** Part of the hash of a name in [0, 1), for an order that mixes everything: what is measured of a part of them stands for all. */
const place = (name) => [...name].reduce((hash, letter) => (Math.imul(hash, 31) + letter.charCodeAt(0)) >>> 0, 7) / 2 ** 32;
const mixed = (scenes) =>
  scenes.toSorted(
    (a, b) => place(JSON.stringify([a.model, a.light, a.shot.size, a.shot.shading])) - place(JSON.stringify([b.model, b.light, b.shot.size, b.shot.shading])),
  );

/** @param {string} folder for skies and garments @returns {Promise<{fit: object[], heldOut: object[]}>} scenes of js/trade */
export async function tradeScenes(folder) {
  const [jackets, skirts] = (await garmentsIn(folder)).map((garment) => [garment]);
  const lights = [...benchLights(['studio', 'sun']), ...skiesIn(folder)];
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
      ...[jackets, skirts].flatMap((garment, i) => [...cross(garment, [studio], [256 << i], ['three']), ...cross(garment, [sun], [512 >> i], ['three'])]),
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
