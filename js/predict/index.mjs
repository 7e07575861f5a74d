/** Which settings a goal of time or error needs, from what was measured of other scenes. */
import { readFileSync } from 'node:fs';

export { calibrate } from './calibrate.mjs';
export { choose, predictAll } from './choose.mjs';
export { featuresOf } from './features.mjs';
export { endedQuality } from './ended.mjs';
export { chooseByWindow, openWindow } from './probe.mjs';

/** @type {import('./choose.mjs').TradeTable} written by `npm run trade` */
export const TABLE = JSON.parse(readFileSync(new URL('table.json', import.meta.url), 'utf8'));
