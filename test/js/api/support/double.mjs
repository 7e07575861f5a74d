import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { endWithProcess } from '../../../../js/api/native.mjs';
import { createRendererOn } from '../../../../js/api/renderer.mjs';

// The addon over stages that only wait (double.cpp): `plan` says how long each takes, and whether it fails.

const ROOT = fileURLToPath(new URL('../../../..', import.meta.url));
const file = path.join(process.env.TELAR_BUILD_DIR ?? path.join(ROOT, 'out/dev'), 'addon/telar_double.node');
if (!existsSync(file)) throw new Error(`${file} is missing: run \`npm run build:dev\``);

export const native = endWithProcess(createRequire(import.meta.url)(file));

/** Milliseconds of a stage that no test waits for: what ends it, an abort or the end of the process, must not wait either. */
export const ENDLESS_MS = 3_600_000;

/** Small, so that only the plan takes time. */
export const SHOT = Object.freeze({ size: { width: 4, height: 2 } });

/** @param {{loadMs?: number, drawMs?: number, encodeMs?: number, stubborn?: boolean, fail?: {stage: string, as: string}}} plan */
export const model = (plan = {}) => Buffer.from(JSON.stringify(plan));

/** A renderer whose first frame was drawn: what is loaded once is loaded. */
export async function openRenderer(options = {}) {
  const renderer = await createRendererOn(native, { cacheDirectory: null, ...options });
  await renderer.render(model(), SHOT);
  return renderer;
}
