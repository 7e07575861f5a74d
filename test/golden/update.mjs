// node test/golden/update.mjs [NAME...]: accepts what telar draws now. Look at each picture before it is committed.
import { mkdirSync, writeFileSync } from 'node:fs';
import { createRenderer } from '../../js/index.mjs';
import { GOLDENS, goldenFile, goldenShot } from './cases.mjs';

const names = process.argv.slice(2);
const renderer = await createRenderer({ backend: 'egl-surfaceless' });
mkdirSync(new URL('images/', import.meta.url), { recursive: true });
for (const [name, golden] of Object.entries(GOLDENS)) {
  if (names.length > 0 && !names.includes(name)) continue;
  const { data } = await renderer.render(await golden.model(), goldenShot(golden));
  writeFileSync(goldenFile(name), data);
  console.log(`${name}  ${data.length} bytes`);
}
await renderer.close();
