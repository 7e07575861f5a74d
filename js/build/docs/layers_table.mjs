import { LAYERS } from '../../material/table.mjs';
import { row } from './tables.mjs';

const ROW = /^\| `(\w+)` \|/;

/** js/docs/formats.md with a row for every extension of js/material/table.mjs: one that it lacks is added. @param {string} page */
export function withLayerExtensions(page) {
  const lines = page.split('\n');
  const told = lines.map((line) => ROW.exec(line)?.[1]);
  const layers = new Set(LAYERS.flatMap(({ extension, rows }) => [extension, ...rows.map((property) => property.extension ?? extension)]));
  for (const name of layers) {
    if (told.includes(name)) continue;
    const at = told.findIndex((other) => other > name);
    told.splice(at, 0, name);
    lines.splice(at, 0, row([`\`${name}\``, 'yes']));
  }
  return lines.join('\n');
}
