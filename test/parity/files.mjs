import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { OUT } from './places.mjs';

/**
 * Keeps a browser's picture as out/parity/browser/NAME.raw (premultiplied RGBA8, top row first), NAME.mask.raw (the same
 * without background), NAME.json (shot, facts), with the model and environment beside them for the server's tool.
 */
export function saveReference(item, inputs, drawn) {
  const folder = path.join(OUT, 'browser');
  mkdirSync(folder, { recursive: true });
  const file = (extension) => path.join(folder, `${item.name}.${extension}`);
  writeFileSync(file('raw'), drawn.image);
  writeFileSync(file('mask.raw'), drawn.mask);
  const model = typeof inputs.model === 'string' ? inputs.model : `${item.name}.glb`;
  if (typeof inputs.model !== 'string') writeFileSync(file('glb'), inputs.model);
  if (inputs.environment) writeFileSync(file('hdr'), inputs.environment);
  writeFileSync(file('shot.json'), `${JSON.stringify(item.shot, null, 1)}\n`);
  const facts = { ...item, model, environment: inputs.environment ? `${item.name}.hdr` : null, facts: drawn.facts };
  writeFileSync(file('json'), `${JSON.stringify(facts, null, 1)}\n`);
}

/** @returns {{width: number, height: number, image: Uint8Array, mask: Uint8Array}} A picture that saveReference kept. */
export function loadReference(item) {
  const file = (extension) => path.join(OUT, 'browser', `${item.name}.${extension}`);
  if (!existsSync(file('raw'))) throw new Error(`no browser picture of ${item.name}: run node test/parity/run.mjs --keep ${item.name}`);
  return { ...item.shot.size, image: new Uint8Array(readFileSync(file('raw'))), mask: new Uint8Array(readFileSync(file('mask.raw'))) };
}
