import assert from 'node:assert/strict';
import { test } from 'node:test';
import { shotWarnings } from '../../../js/api/frame_info.mjs';

const SHOT = { lens: null, quality: { preset: 'standard' }, shading: 'three' };
const THIN = ['KHR_materials_sheen', 'KHR_materials_diffuse_transmission'];

test('the shading that does not draw light through cloth says so', () => {
  const [warning, ...others] = shotWarnings(SHOT, THIN);
  assert.equal(warning.code, 'W_EXT_IGNORED');
  assert.equal(warning.pointer, '/extensionsUsed/1');
  assert.match(warning.message, /KHR_materials_diffuse_transmission/);
  assert.deepEqual(others, []);
  assert.deepEqual(shotWarnings({ ...SHOT, shading: 'fabric' }, THIN), []);
  const disney = { base: 'disney-2012', diffuse: 'disney-2012' };
  assert.match(shotWarnings({ ...SHOT, shading: disney }, THIN)[0].message, /^shading "disney-2012"/);
  assert.deepEqual(shotWarnings({ ...SHOT, shading: { ...disney, diffuse: 'disney-2015-thin' } }, THIN), []);
  assert.deepEqual(shotWarnings(SHOT, ['TELAR_materials_fabric']), []);
});

test('the raster says that it shows everything sharp', () => {
  const lens = { focusDistance: 1 };
  assert.deepEqual(
    shotWarnings({ ...SHOT, lens }).map(({ code }) => code),
    ['W_LENS'],
  );
  assert.deepEqual(shotWarnings({ ...SHOT, lens, quality: { preset: 'reference' } }), []);
});
