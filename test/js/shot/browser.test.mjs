import assert from 'node:assert/strict';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';
import vm from 'node:vm';
import { build } from 'esbuild';
import { resolveShot } from '../../../js/shot/index.mjs';

test('the browser bundle needs nothing of Node and resolves to the same bits', async () => {
  const {
    outputFiles: [{ text }],
    metafile: { outputs },
  } = await build({
    entryPoints: [fileURLToPath(new URL('../../../js/shot/index.mjs', import.meta.url))],
    bundle: true,
    minify: true,
    write: false,
    metafile: true,
    format: 'iife',
    globalName: 'telarShot',
    platform: 'browser',
  });
  // The schema and its parser; a library that slips in is more. Rows of knobs took it from 107 to 110.3 kB, and what holds views over a ground and in true scale to 112.2. The one table of errors is left out: it grows with the pool and the service.
  const [{ inputs }] = Object.values(outputs);
  const table = Object.entries(inputs).find(([name]) => name.endsWith('js/error/table.mjs'))[1].bytesInOutput;
  const bytes = text.length - table;
  assert.ok(bytes < 113_000, `${bytes} bytes without the table of errors`);
  // A realm with the language alone: no process, no require, no Buffer.
  const realm = vm.createContext({});
  vm.runInContext(text, realm);
  const shot = { camera: { azimuth: 33, elevation: 12 }, lights: [{ type: 'spot', color: 'hsl(210, 60%, 40%)' }] };
  const box = { min: [-0.4, 0.1, -0.15], max: [0.42, 0.82, 0.17] };
  const there = vm.runInContext(`JSON.stringify(telarShot.resolveShot(${JSON.stringify(shot)}, ${JSON.stringify(box)}))`, realm);
  assert.equal(there, JSON.stringify(resolveShot(shot, box)));
});
