import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { compareImages, judge, readImage } from '../../../js/compare/index.mjs';
import { createRenderer, inspect } from '../../../js/index.mjs';
import { createSheet, firstSpec } from '../../../js/sheet/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { errorOf, open, SHOT } from './support.mjs';

// What a pool does beside drawing gives what the functions of the same names give in this process.

let renderer, pool, glb;
before(async () => {
  [renderer, pool, glb] = await Promise.all([createRenderer({ cacheDirectory: null }), open({ limits: { L_FILE_BYTES: 1_000_000 } }), MODELS.cloth()]);
});
after(() => Promise.all([renderer.close(), pool.close()]));

const plain = (value) => JSON.parse(JSON.stringify(value));

test('inspect: facts, plan, lengths', async () => {
  const options = {
    shot: { ...SHOT, quality: 'high' },
    measure: [
      {
        points: [
          [0, 0, 0],
          [0.1, 0, 0],
        ],
      },
    ],
  };
  assert.deepEqual(plain(await pool.inspect(glb, options)), plain(await inspect(glb, options)));
  assert.equal((await errorOf(pool.inspect(Buffer.alloc(1_000_001)))).code, 'L_FILE_BYTES');
  assert.equal((await errorOf(pool.inspect(glb, { measure: 1 }))).message, 'options.measure: expected a list of what to measure, got 1');
});

test('compare: figures, verdict, heat map; which of two is expected counts', async () => {
  const [front, back, larger] = await Promise.all(
    [SHOT, { ...SHOT, camera: { view: 'back' } }, { size: { width: 96, height: 96 } }].map((shot) => renderer.render(glb, shot).then(({ data }) => data)),
  );
  const { flipMap, ...comparison } = compareImages(await readImage(front), await readImage(back));
  const told = await pool.compare(front, back, { gate: 'draft', heatMap: true });
  assert.deepEqual(plain(told.comparison), plain(comparison));
  assert.deepEqual(plain(told.verdict), plain(judge({ flipMap, ...comparison }, 'draft', {})));
  const map = await readImage(told.heatMap);
  assert.deepEqual([map.width, map.height], [48, 48]);
  assert.equal((await pool.compare(front, front, { gate: 'exact' })).verdict.pass, true);
  assert.equal((await errorOf(pool.compare(front, larger))).code, 'E_IMAGE_SIZE');
  assert.equal((await pool.compare(front, larger, { resize: true, thresholds: { 'object.flip.mean': 1 } })).comparison.width, 48);
  assert.equal((await errorOf(pool.compare(front, Buffer.from('x')))).code, 'E_IMAGE_FORMAT');
  assert.equal((await errorOf(pool.compare(front, 'x', { resize: 1 }))).message, 'options.resize: expected true or false, got 1');
});

test('sheet: the pages of createSheet, by a spec and by none', async () => {
  const model = await renderer.load(glb);
  for (const spec of [null, { header: { style: 'TL-01' }, views: [{ name: 'front', title: 'Front', view: 'front', cover: true }] }]) {
    const { files } = await createSheet(model, spec ?? firstSpec(model.facts, { name: 'Square' }), { renderer, format: 'svg' });
    const told = await pool.sheet(glb, spec, { format: 'svg', name: 'Square' });
    assert.deepEqual([told.format, told.files.map(String)], ['svg', files.map(String)]);
  }
  const wrong = await errorOf(pool.sheet(glb, { header: { style: 'TL-01', logo: 'logo.png' } }, { images: {} }));
  assert.equal(wrong.code, 'E_SPEC');
});

test('a comparison that its caller aborts ends, and the pool draws on', async () => {
  const picture = (await renderer.render(glb, { size: { width: 1024, height: 1024 } })).data;
  const controller = new AbortController();
  const comparing = errorOf(pool.compare(picture, picture, { signal: controller.signal }));
  controller.abort(new Error('enough'));
  assert.equal((await comparing).message, 'enough');
  assert.ok((await pool.render(glb, SHOT)).data.length > 100);
});
