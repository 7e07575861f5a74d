import { existsSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

// The addon that ships. Without TELAR_BUILD_DIR (npm test sets it) the tests take the development build.
const ROOT = fileURLToPath(new URL('../../../..', import.meta.url));
process.env.TELAR_BUILD_DIR ??= path.join(ROOT, 'out/dev');

export const addonFile = path.join(process.env.TELAR_BUILD_DIR, 'addon/telar.node');
if (!existsSync(addonFile)) throw new Error(`${addonFile} is missing: run \`npm run build:dev\``);

export const indexUrl = new URL('../../../../js/index.mjs', import.meta.url).href;
export const fixturesUrl = new URL('../../../fixtures/index.mjs', import.meta.url).href;
