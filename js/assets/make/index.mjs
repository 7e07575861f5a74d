import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { makeCloth, PRESETS } from './cloths/index.mjs';
import { makeFabrics } from './fabrics/index.mjs';
import { makeStudio } from './studio.mjs';
import { makeTshirt } from './tshirt.mjs';

/** Writes the bundled assets beside this folder, or into the folder given as the first argument. */
const target = process.argv[2] ?? fileURLToPath(new URL('..', import.meta.url));
await mkdir(path.join(target, 'cloths'), { recursive: true });
for (const [name, make] of [
  ['studio.hdr', makeStudio],
  ['tshirt.glb', makeTshirt],
  ['fabrics.glb', makeFabrics],
  ...Object.keys(PRESETS).map((preset) => [`cloths/${preset}.glb`, () => makeCloth(preset)]),
]) {
  const bytes = await make();
  await writeFile(path.join(target, name), bytes);
  console.log(`${name}  ${bytes.length} bytes`);
}
prefilterStudio();

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
