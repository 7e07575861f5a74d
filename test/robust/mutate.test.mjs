// Thousands of files with a few wrong bytes in their compressed parts: each is drawn or refused with an error of telar,
// soon, and none ends the process. TELAR_BUILD_DIR (default out/dev) holds bin/telar_mutate.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { TABLE } from '../../js/error/table.mjs';
import { etc1sKtx2 } from '../fixtures/etc1s.mjs';
import { blockKtx2 } from '../fixtures/gpu_blocks.mjs';
import { SUPERCOMPRESSION, ktx2File, mipChain, rawKtx2 } from '../fixtures/ktx2.mjs';
import { rawFormatKtx2 } from '../fixtures/raw_formats.mjs';
import { meshoptTorus } from '../fixtures/scenes_decoders.mjs';
import { uastcBlocks, uastcKtx2 } from '../fixtures/uastc.mjs';
import { zstdStored } from '../fixtures/zstd_frame.mjs';
import { ktx2Quad, meshoptQuad, picture } from './decoder_cases.mjs';
import { glb } from './glb.mjs';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const TOOL = join(resolve(ROOT, process.env.TELAR_BUILD_DIR ?? 'out/dev'), 'bin/telar_mutate');
const SHARED = join(ROOT, '../shared/models');
const REFUSE_MS = Number(process.env.TELAR_REFUSE_MS ?? 250);
const RUNS = Number(process.env.TELAR_MUTATIONS ?? 1500);

const zstd = () => {
  const levels = mipChain(picture()).map(uastcBlocks);
  return ktx2File({
    width: 32,
    height: 16,
    levels: levels.map(zstdStored),
    sizes: levels.map(({ length }) => length),
    supercompression: SUPERCOMPRESSION.zstd,
  });
};

/** Models by name; those of ../shared where they are. */
const FILES = {
  uastc: () => ktx2Quad(uastcKtx2(picture())),
  'uastc-zstd': () => ktx2Quad(zstd()),
  etc1s: () => ktx2Quad(etc1sKtx2(picture())),
  'etc1s-alpha': () => ktx2Quad(etc1sKtx2(picture(64, 64), { alpha: true, historySize: 4 })),
  raw: () => ktx2Quad(rawKtx2(picture())),
  floats: () => ktx2Quad(rawFormatKtx2('rgba16f', picture(), { zstd: true })),
  blocks: () => ktx2Quad(blockKtx2('bc7-srgb', picture())),
  meshopt: () => glb(meshoptQuad()),
  'meshopt-torus': () => Buffer.from(meshoptTorus()),
  'meshopt-pirate': () => readFileSync(join(SHARED, 'meshopt_pirate/pirate.glb')),
  'draco-heart': () => readFileSync(join(SHARED, 'heart_draco/heart_draco.glb')),
};
const NEED_SHARED = ['meshopt-pirate', 'draco-heart'];

let folder;
before(() => {
  assert.ok(existsSync(TOOL), 'telar_mutate is not built: cmake --preset dev && cmake --build --preset dev');
  folder = mkdtempSync(join(tmpdir(), 'telar-mutate-'));
});
after(() => folder && rmSync(folder, { recursive: true }));

for (const [name, make] of Object.entries(FILES)) {
  test(`${RUNS} mutations of ${name}`, { skip: NEED_SHARED.includes(name) && !existsSync(SHARED) && 'no ../shared/models' }, async () => {
    const bytes = make();
    const file = join(folder, `${name}.glb`);
    writeFileSync(file, bytes);
    const binary = 20 + bytes.readUInt32LE(12) + 8; // behind the JSON chunk
    const { stdout } = await promisify(execFile)(TOOL, [file, String(RUNS), String(binary)], { timeout: 600_000 });
    const { runs, ok, codes, worstCpuMs, worstRun } = JSON.parse(stdout);
    assert.equal(runs, RUNS);
    assert.ok(ok < runs, 'some must be refused');
    for (const code of Object.keys(codes)) assert.ok(['input', 'unsupported', 'limit'].includes(TABLE[code]?.kind), code);
    assert.ok(worstCpuMs < REFUSE_MS, `run ${worstRun} took ${worstCpuMs} ms`);
  });
}
