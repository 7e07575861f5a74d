// Ambient visibility: CPU time of finding it and of reading what was kept, and sizes.
// node test/bench/visibility.mjs [MODEL...]      needs the dev build (npm test makes it)
import { mkdtempSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { bake, createRenderer } from '../../js/index.mjs';

const ASSETS = fileURLToPath(new URL('../../js/assets/', import.meta.url));
const models = process.argv.length > 2 ? process.argv.slice(2) : ['tshirt.glb', 'fabrics.glb'].map((name) => path.join(ASSETS, name));

const kilobytes = (bytes) => `${(bytes / 1000).toFixed(0)} kB`;

console.log('| model | vertices | load, ms | with rays: 256 | 1024 | with what is kept | kept | file | baked |\n|---|---|---|---|---|---|---|---|---|');
for (const model of models) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-bench-'));
  const renderer = await createRenderer({ cacheDirectory: folder, timeoutMs: null });
  let vertices;
  /** CPU milliseconds of all threads. */
  const load = async (ambientVisibility) => {
    const before = process.cpuUsage();
    const loaded = await renderer.load(model, { ambientVisibility });
    const { user, system } = process.cpuUsage(before);
    vertices = loaded.facts.vertices;
    await renderer.release(loaded);
    return ((user + system) / 1000).toFixed(0);
  };
  await load(false);
  const plain = await load(false);
  const many = await load({ rays: 1024 });
  rmSync(folder, { recursive: true });
  const times = [await load(true), many, await load(true)];
  const kept = readdirSync(folder).map((name) => statSync(path.join(folder, name)).size);
  const { data } = await bake(model, { cacheDirectory: folder });
  const sizes = [kept[0], statSync(model).size, data.length].map(kilobytes);
  console.log(`| ${path.basename(model)} | ${[vertices, plain, ...times, ...sizes].join(' | ')} |`);
  await renderer.close();
  rmSync(folder, { recursive: true });
}
