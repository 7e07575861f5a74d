import { mkdir, writeFile } from 'node:fs/promises';
import { makeStudio } from './studio.mjs';
import { makeTshirt } from './tshirt.mjs';

/** Writes the bundled assets beside this folder, or into the folder given as the first argument. */
const target = process.argv[2] ?? new URL('..', import.meta.url).pathname;
await mkdir(target, { recursive: true });
for (const [name, make] of [['studio.hdr', makeStudio], ['tshirt.glb', makeTshirt]]) {
  const bytes = await make();
  await writeFile(`${target}/${name}`, bytes);
  console.log(`${name}  ${bytes.length} bytes`);
}
