import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer, inspect } from '../../../js/index.mjs';
import { BROKEN_MODELS } from '../../fixtures/index.mjs';
import { editedGlb } from '../../fixtures/edited_glb.mjs';
import { glb, quad } from '../../robust/glb.mjs';
import './support/real.mjs';

// The option `failOn` on real files. That its pictures are the browser's is for the gate: test/parity/cases_broken.mjs.

const SHOT = { size: { width: 32, height: 32 }, environment: 'none', lights: [{ type: 'ambient' }], output: { format: 'raw' } };

let renderer;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
});
after(() => renderer.close());

const glbOf = (doc, bin) => glb({ doc, bin });
/** Of the file; what the picture shows has warnings of its own. */
const codes = (warnings) => warnings.filter(({ pointer }) => pointer !== undefined).map(({ code, pointer }) => [code, pointer]);
const EXPECTED = {
  // All headers are read before an image is decoded, and the third image has none.
  'broken-maps': [
    'E_IMAGE_FORMAT',
    [
      ['W_TEXTURE', '/images/2'],
      ['W_TEXTURE', '/images/0'],
      ['W_TEXTURE', '/images/1'],
      ['W_TEXTURE', '/images/3'],
    ],
  ],
  'broken-sources': [
    'E_IMAGE_FORMAT',
    [
      ['W_TEXTURE', '/images/0'],
      ['W_TEXTURE', '/images/1'],
    ],
  ],
  'broken-missing-files': [
    'E_URI_DENIED',
    [
      ['W_TEXTURE', '/images/0/uri'],
      ['W_TEXTURE', '/images/1/uri'],
    ],
  ],
  'broken-required-extensions': [
    'E_EXT_REQUIRED',
    [
      ['W_EXT_REQUIRED', '/extensionsRequired/0'],
      ['W_EXT_REQUIRED', '/extensionsRequired/1'],
    ],
  ],
};

for (const [name, [code, warnings]] of Object.entries(EXPECTED)) {
  test(`${name}: an error by default, drawn with warnings by "none"`, async () => {
    const bytes = await BROKEN_MODELS[name]();
    await assert.rejects(renderer.render(bytes, SHOT), { code });
    await assert.rejects(renderer.render(bytes, SHOT, { failOn: 'warning' }), { code });
    const { info } = await renderer.render(bytes, SHOT, { failOn: 'none' });
    assert.deepEqual(codes(info.warnings), warnings);
    assert.deepEqual(codes((await inspect(bytes, { failOn: 'none' })).warnings), warnings);
    const loaded = await renderer.load(bytes, { failOn: 'none' });
    await renderer.render(loaded, SHOT);
    await assert.rejects(renderer.render(loaded, SHOT, { failOn: 'warning' }), { code: 'E_WARNING', pointer: warnings[0][1] });
  });
}

test('a texture that is not there leaves no trace in the picture', async () => {
  const red = quad();
  red.doc.materials[0].pbrMetallicRoughness.baseColorFactor = [1, 0, 0, 1];
  const bare = structuredClone(red.doc);
  delete bare.materials[0].pbrMetallicRoughness.baseColorTexture;
  const broken = quad({ image: Buffer.from('no image') });
  broken.doc.materials = structuredClone(red.doc.materials);
  const expected = (await renderer.render(glbOf(bare, red.bin), SHOT)).data;
  const { data, info } = await renderer.render(glbOf(broken.doc, broken.bin), SHOT, { failOn: 'none' });
  assert.deepEqual(data, expected);
  assert.match(info.warnings[0].message, /^a texture is not drawn: .* \[E_IMAGE_FORMAT\]$/);
});

test("limits, damaged geometry and the resolver's own failures stay errors", async () => {
  const strict = await createRenderer({ cacheDirectory: null, failOn: 'none', limits: { L_IMAGE_DIMENSION: 2 } });
  const { doc, bin } = quad();
  await assert.rejects(strict.render(glbOf(doc, bin), SHOT), { code: 'L_IMAGE_DIMENSION' });
  await strict.close();
  const outside = { ...doc, images: [{ uri: 'a.png' }] };
  await assert.rejects(
    renderer.render(glbOf(outside, bin), SHOT, {
      failOn: 'none',
      resolve: () => {
        throw new Error('down');
      },
    }),
    { code: 'X_RESOLVE' },
  );
  const { info } = await renderer.render(glbOf(outside, bin), SHOT, { failOn: 'none', resolve: () => null });
  assert.deepEqual(codes(info.warnings), [['W_TEXTURE', '/images/0/uri']]);
  const noBuffer = editedGlb(glbOf(doc, bin), (json) => {
    json.buffers[0].uri = 'a.bin';
  });
  await assert.rejects(renderer.render(noBuffer, SHOT, { failOn: 'none' }), { code: 'E_URI_DENIED' });
});
