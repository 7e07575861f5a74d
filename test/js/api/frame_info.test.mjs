import assert from 'node:assert/strict';
import { test } from 'node:test';
import { frameInfo, shotWarnings } from '../../../js/api/frame_info.mjs';
import { PATCHES, REVISION, REVISION_MIN } from '../../../js/shot/three_terms.mjs';

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

const remarks = (revision) => shotWarnings({ ...SHOT, shading: { base: 'three', revision } }).map(({ code, message }) => `${code} ${message}`);

test('a release that is drawn as another one says so', () => {
  assert.deepEqual(remarks(180), []);
  assert.deepEqual(remarks(REVISION), []);
  assert.deepEqual(shotWarnings(SHOT), []);
  assert.match(remarks(REVISION + 1)[0], new RegExp(`^W_THREE_REVISION shot\\.shading\\.revision: .*nearest, 0\\.${REVISION}$`));
  assert.match(remarks(REVISION_MIN - 1)[0], new RegExp(`nearest, 0\\.${REVISION_MIN}$`));
  for (const [revision, version] of Object.entries(PATCHES))
    assert.match(remarks(Number(revision))[0], new RegExp(`drawn as ${version.replaceAll('.', '\\.')} `));
});

const FRAME = { width: 1, height: 1, info: '{}', queueMs: 0, drawMs: 0, encodeMs: 0 };
const infoOf = (shading) =>
  frameInfo({ frame: FRAME, resolved: { output: {}, shading, camera: { projection: 'perspective' } }, milliseconds: {}, renderer: { backend: 'egl', gl: {} } })
    .three;

test('info tells the release and those that draw as it does', () => {
  assert.deepEqual(infoOf('three'), { revision: REVISION, family: { from: REVISION, to: REVISION } });
  assert.deepEqual(infoOf({ base: 'three', revision: 170 }), { revision: 170, family: { from: 167, to: 180 } });
  assert.equal(infoOf('fabric'), undefined);
  assert.equal(infoOf({ base: 'disney-2012' }), undefined);
});
