import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { createSheet } from '../../../js/sheet/index.mjs';
import { eachOnce } from '../../../js/sheet/warnings.mjs';
import { editedGlb } from '../../fixtures/edited_glb.mjs';
import { CHEAP, squareModel } from './square.mjs';

let renderer;
before(async () => {
  renderer = await createRenderer({ failOn: 'none' });
});
after(() => renderer.close());

/** The square with a texture that is not there. */
const untextured = async () =>
  editedGlb(await squareModel(), (json) => {
    json.images = [{ uri: 'missing.png' }];
    json.textures = [{ source: 0 }];
    json.materials[0].pbrMetallicRoughness.baseColorTexture = { index: 0 };
  });

test('a sheet tells what the file of its model and its pictures are warned of, each once, beside its own', async () => {
  const spec = {
    header: { style: 'TL-01' },
    units: 'mm',
    printedUnits: 'cm',
    artwork: [{ name: 'print', width: 10.00001 }],
    views: ['front', 'back'].map((view) => ({ name: view, view })),
  };
  const { info } = await createSheet(await untextured(), spec, { renderer, shot: CHEAP, format: 'svg' });
  assert.deepEqual(
    info.warnings.map(({ code, pointer }) => [code, pointer]),
    [
      ['W_TEXTURE', '/images/0/uri'],
      ['W_SHEET_ROUND', '/artwork/0/width'],
      ['W_EXPOSURE', undefined],
    ],
  );
});

test('what is said again in other numbers is told once, and several of one kind in one list are several', () => {
  const told = (code, pointer, message) => ({ code, pointer, message });
  const file = [told('W_A', '/a', '1'), told('W_A', '/a', '2')];
  const pictures = [[told('W_A', '/a', '1'), told('W_B', undefined, '50 %')], [told('W_B', undefined, '60 %'), told('W_A', '/b', '1')], []];
  assert.deepEqual(eachOnce([file, ...pictures]), [...file, pictures[0][1], pictures[1][1]]);
});
