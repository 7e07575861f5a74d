import assert from 'node:assert/strict';
import { existsSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { runChild } from './support/child.mjs';
import { fixturesUrl, indexUrl } from './support/real.mjs';

// Small files that would cost much, one process a file: refused within 2 s of processor time or drawn, within 2 GiB either
// way; the next picture of the same process is right.

/** Longer where a sanitizer is on: js/setup/sanitize.mjs. */
const REFUSE_CPU_SECONDS = Number(process.env.TELAR_REFUSE_MS ?? 2000) / 1000;

const FOLDER = new URL('../../../../shared/hostile/cost/', import.meta.url);
const skip = existsSync(FOLDER) ? false : 'needs ../shared';

/** What each must end with: '' = a picture, which may take longer than a renderer allows where other tests run beside. `shading` is the one that costs. */
const CASES = {
  'cutoffs-30x8192.glb': { code: 'L_MEMORY_BYTES', shading: 'fabric' },
  'draco-bool-ubsan.glb': { code: 'E_DRACO' },
  'draco-num-orientations.glb': { code: 'E_DRACO' },
  'draco-x6.glb': { code: 'E_DRACO' },
  'images-4x8192-webp-dual.glb': { code: 'L_MEMORY_BYTES' },
  'overdraw-20M.glb': { code: /^(L_FRAGMENTS|X_TIMEOUT)$/ },
  'points-5x9.9M.glb': { code: 'L_TRIANGLES' },
  'variants-45kx8k.glb': { code: '' },
  'vertices-9.99M-all.glb': { code: 'L_MEMORY_BYTES' },
};

const script = (file, shading, code) => `
  import { readFileSync } from 'node:fs';
  import { createRenderer } from '${indexUrl}';
  import { MODELS } from '${fixturesUrl}';
  const renderer = await createRenderer({ cacheDirectory: null });
  const shot = { size: { width: 256, height: 256 }, output: { format: 'raw' } };
  const ball = await MODELS.ball();
  const before = (await renderer.render(ball, shot)).data;
  const start = process.cpuUsage();
  let code = '';
  try {
    await renderer.render(new URL('${file}'), { ...shot, shading: '${shading}' }${code === '' ? ', { timeoutMs: null }' : ''});
  } catch (error) {
    code = error.code;
  }
  const { user, system } = process.cpuUsage(start);
  const same = before.equals((await renderer.render(ball, shot)).data);
  await renderer.close();
  const peakKibibytes = Number(/VmHWM:\\s+(\\d+)/.exec(readFileSync('/proc/self/status', 'utf8'))[1]);
  console.log(JSON.stringify({ code, cpuSeconds: (user + system) / 1e6, same, peakKibibytes }));`;

test('every file of the folder has its row', { skip }, () => {
  const files = readdirSync(FOLDER).filter((file) => file.endsWith('.glb'));
  assert.deepEqual(files.sort(), Object.keys(CASES).sort());
});

for (const [file, { code, shading = 'three' }] of Object.entries(CASES)) {
  test(file, { skip }, async () => {
    const child = await runChild(script(new URL(file, FOLDER).href, shading, code), { support: false });
    assert.equal(child.code, 0, child.stderr);
    const result = JSON.parse(child.stdout);
    if (code instanceof RegExp) assert.match(result.code, code);
    else assert.equal(result.code, code);
    assert.ok(result.same, 'the next picture is another one');
    assert.ok(result.peakKibibytes < 2 * 2 ** 20, `${(result.peakKibibytes / 2 ** 20).toFixed(2)} GiB`);
    if (result.code.startsWith('E_') || result.code.startsWith('L_')) assert.ok(result.cpuSeconds < REFUSE_CPU_SECONDS, `${result.cpuSeconds} s of CPU`);
  });
}
