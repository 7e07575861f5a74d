import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';

// Images of a model that is drawn from its file are decoded while the renderer looks for what is seen. What is wrong with them is told all the same.

const TSHIRT = new URL('../../../js/assets/tshirt.glb', import.meta.url);
const SIZE = { width: 64, height: 64 };
const DAMAGED = 3;

/** The T-shirt, one of whose JPEGs ends after half of its bytes. */
function damaged() {
  const file = readFileSync(TSHIRT);
  const length = file.readUInt32LE(12);
  const { bufferViews, images } = JSON.parse(file.subarray(20, 20 + length));
  const { byteOffset = 0, byteLength } = bufferViews[images[DAMAGED].bufferView];
  const [begin, end] = [byteOffset + byteLength / 2, byteOffset + byteLength].map((at) => 28 + length + Math.floor(at));
  for (let i = begin; i < end; ++i) file[i] = (i - begin) % 2 === 0 ? 0xff : 0xd9;
  return file;
}

const renderer = await createRenderer();
after(() => renderer.close());

const told = { code: 'E_IMAGE_CORRUPT', pointer: `/images/${DAMAGED}` };

test('a damaged image is told, whatever the picture shows of it', async () => {
  const away = { position: [0, 0, 5], target: [0, 0, 9], fovY: 30, near: 0.1, far: 10 };
  for (const shot of [
    {},
    { quality: 'draft' },
    { camera: away },
    { style: 'flat' },
    { quality: { preset: 'reference', samples: 1 } },
    { layers: ['beauty', 'ao'] },
  ])
    await assert.rejects(renderer.render(damaged(), { size: SIZE, ...shot }), told, JSON.stringify(shot));
  await assert.rejects(renderer.render(damaged(), { size: SIZE, materials: { '*': { preset: 'denim' } } }), told);
  await assert.rejects(renderer.renderQuantity(damaged(), { size: SIZE }, 'baseColor'), told);
  await assert.rejects(renderer.renderAll(damaged(), [{ size: SIZE }, { size: SIZE }]), told);
  await assert.rejects(renderer.load(damaged()), told);
});

test('failOn "none" draws without it', async () => {
  const { info } = await renderer.render(damaged(), { size: SIZE }, { failOn: 'none' });
  assert.ok(
    info.warnings.some(({ code, pointer }) => code === 'W_TEXTURE' && pointer === told.pointer),
    JSON.stringify(info.warnings),
  );
});

test('the picture of a file is that of the loaded model', async () => {
  const model = await renderer.load(readFileSync(TSHIRT));
  for (const shot of [{ size: SIZE }, { size: SIZE, shading: 'fabric' }, { size: SIZE, materials: { '*': { preset: 'denim' } } }]) {
    const [first, second] = await Promise.all([renderer.render(readFileSync(TSHIRT), shot), renderer.render(model, shot)]);
    assert.ok(first.data.equals(second.data), JSON.stringify(shot));
    assert.equal(first.info.key, second.info.key);
  }
});

test('many at once, some given up', async () => {
  const jobs = Array.from({ length: 12 }, async (_, i) => {
    const abort = new AbortController();
    const job = renderer.render(i % 3 === 0 ? damaged() : readFileSync(TSHIRT), { size: SIZE }, { signal: abort.signal });
    if (i % 4 === 1) setTimeout(() => abort.abort(), i);
    return job.then(
      () => 'drawn',
      ({ code, name }) => code ?? name,
    );
  });
  const ends = await Promise.all(jobs);
  ends.forEach((end, i) => {
    const may = i % 3 === 0 ? ['E_IMAGE_CORRUPT'] : ['drawn'];
    assert.ok([...may, ...(i % 4 === 1 ? [20, 'AbortError'] : [])].includes(end), `${i}: ${end}`);
  });
  assert.equal((await renderer.render(readFileSync(TSHIRT), { size: SIZE })).info.width, 64);
});
