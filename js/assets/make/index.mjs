import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { makeCloth, PRESETS } from './cloths/index.mjs';
import { makeFabrics } from './fabrics/index.mjs';
import { assetHashes, MADE_FILE, sourcesHash } from './made.mjs';
import { makeStudio } from './studio.mjs';
import { makeTshirt } from './tshirt.mjs';

// node js/assets/make/index.mjs [FOLDER [NAME...]]: writes the bundled assets, or those of these names, beside this folder or into FOLDER.
const BUNDLED = fileURLToPath(new URL('..', import.meta.url));
const [target = BUNDLED, ...wanted] = process.argv.slice(2);
const MAKERS = {
  'studio.hdr': makeStudio,
  'tshirt.glb': makeTshirt,
  'fabrics.glb': makeFabrics,
  ...Object.fromEntries(Object.keys(PRESETS).map((preset) => [`cloths/${preset}.glb`, () => makeCloth(preset)])),
};
const unknown = wanted.filter((name) => !MAKERS[name]);
if (unknown.length > 0) throw new Error(`no such asset: ${unknown.join(', ')}; there are ${Object.keys(MAKERS).join(', ')}`);

await mkdir(path.join(target, 'cloths'), { recursive: true });
for (const name of wanted.length > 0 ? wanted : Object.keys(MAKERS)) {
  const bytes = await MAKERS[name]();
  await writeFile(path.join(target, name), bytes);
  console.log(`${name}  ${bytes.length} bytes`);
}
if (wanted.length === 0) {
  prefilterStudio();
  const made = { sources: await sourcesHash(), files: await assetHashes(target, Object.keys(MAKERS)) };
  await writeFile(path.join(target, MADE_FILE), `${JSON.stringify(made, null, 2)}\n`);
}

/** studio.pmrem: the studio as the renderer prefilters it, so that a first picture does not wait for it. */
function prefilterStudio() {
  const root = fileURLToPath(new URL('../../../', import.meta.url));
  const build = path.resolve(root, process.env.TELAR_BUILD_DIR ?? 'out/dev');
  const tool = path.join(build, 'bin/telar_make_pmrem');
  if (!existsSync(tool)) throw new Error('telar_make_pmrem is not built: run npm run build:dev first');
  const env = { ...process.env, TELAR_LIBRARY_DIR: path.join(build, 'addon') };
  const run = spawnSync(tool, [path.join(target, 'studio.hdr'), path.join(target, 'studio.pmrem')], { stdio: 'inherit', env });
  if (run.status !== 0) throw new Error('telar_make_pmrem failed');
}
