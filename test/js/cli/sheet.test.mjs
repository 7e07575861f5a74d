import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import '../api/support/real.mjs';
import { editedGlb } from '../../fixtures/edited_glb.mjs';
import { squareModel } from '../sheet/square.mjs';
import { runFake } from './fake.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'telar-cli-sheet-'));
after(() => rmSync(folder, { recursive: true }));
const at = (name) => path.join(folder, name);
writeFileSync(at('square.glb'), await squareModel());

/** The command on the real API: pictures cost little, as they have no light. */
const run = async (...args) =>
  runFake(['sheet', at('square.glb'), '--set', 'environment=none', '--set', 'quality=draft', ...args], { api: await import('../../../js/index.mjs') });
const put = (name, spec) => {
  writeFileSync(at(name), typeof spec === 'string' ? spec : JSON.stringify(spec));
  return at(name);
};

test('--init writes a spec, which gives a sheet', async () => {
  const init = await run('--init', '-o', at('first.json'));
  assert.deepEqual([init.exit, init.stdout], [0, `${at('first.json')}\n`], init.stderr);
  const spec = JSON.parse(readFileSync(at('first.json'), 'utf8'));
  assert.equal(spec.header.name, 'Square');
  const made = await run('--spec', at('first.json'), '-o', at('first.pdf'), '--json');
  const result = JSON.parse(made.stdout);
  assert.deepEqual([made.exit, result.ok, result.outputs], [0, true, [at('first.pdf')]], made.stderr);
  assert.equal(readFileSync(at('first.pdf')).subarray(0, 5).toString(), '%PDF-');
  assert.equal(result.info.measures[0].code, 'A');
});

test('SVG and PNG are one file a page', async () => {
  const { exit, stdout, stderr } = await run('--spec', put('small.json', { ppi: 72 }), '-o', at('page.svg'));
  assert.equal(exit, 0, stderr);
  assert.equal(stdout, `${at('page.svg')}\n`);
  const many = await run('--spec', put('two.json', { ppi: 72, bill: [{ item: 'jersey' }] }), '-o', at('two.svg'));
  assert.equal(many.stdout, `${at('two-1.svg')}\n${at('two-2.svg')}\n`, many.stderr);
});

test('a wrong spec is told with its pointer, and nothing is written', async () => {
  const before = readdirSync(folder).length;
  const wrong = await run('--spec', put('wrong.json', { callouts: [{ text: 'a' }] }), '-o', at('wrong.pdf'), '--json');
  const { error } = JSON.parse(wrong.stdout);
  assert.deepEqual([wrong.exit, error.code, error.pointer], [2, 'E_SPEC', '/callouts/0']);
  assert.equal((await run('--spec', put('broken.json', '{'), '-o', at('wrong.pdf'))).exit, 2);
  assert.equal((await run('--spec', put('large.json', `"${'x'.repeat(9 * 2 ** 20)}"`), '-o', at('wrong.pdf'))).exit, 4);
  assert.equal((await run('--spec', at('none.json'), '-o', at('wrong.pdf'))).exit, 3);
  const outside = await run('--spec', put('outside.json', { header: { logo: '../x.png' } }), '-o', at('wrong.pdf'), '--json');
  assert.equal(JSON.parse(outside.stdout).error.code, 'E_URI_DENIED');
  assert.ok(!existsSync(at('wrong.pdf')));
  assert.equal(readdirSync(folder).length, before + 4);
});

test('names of outputs are checked first', async () => {
  const usage = async (...args) => {
    const { exit, stderr } = await run(...args);
    assert.equal(exit, 2);
    return stderr;
  };
  assert.match(await usage('-o', at('x.doc')), /expected a name that ends in \.pdf, \.svg, \.png; with --init in \.json/);
  assert.match(await usage('--init', '-o', at('x.pdf')), /--init writes a spec: name a \.json file/);
  assert.match(await usage(), /required option '-o, --output <out>' not specified/);
  assert.match(await usage('-o', at('x.pdf'), '--template', 'own'), /expected NAME=FOLDER/);
  assert.match(await usage('-o', at('x.pdf'), '--spec', '-', '--previous', '-'), /- \(stdin\) can stand for one file only/);
});

test('what is not shared by the pictures is refused before anything is drawn', async () => {
  const { exit, stderr } = await run('--set', 'camera.view=back', '-o', at('camera.pdf'));
  assert.equal(exit, 2);
  assert.match(
    stderr,
    /shot\.camera: a sheet does not take it; give `view`, or `azimuth` and `elevation`, to the views of the spec\. Of a shot it takes environment, .*E_OPTION/,
  );
  assert.ok(!existsSync(at('camera.pdf')));
});

test('warnings of the model, of the spec and of pictures are told once each, and refused by --fail-on warning before a file is written', async () => {
  const bytes = editedGlb(readFileSync(at('square.glb')), (json) => (json.extensionsUsed = [...(json.extensionsUsed ?? []), 'VENDOR_unknown']));
  writeFileSync(at('unknown.glb'), bytes);
  const spec = put('rounded.json', { header: { style: 'TL-01' }, units: 'mm', printedUnits: 'cm', artwork: [{ name: 'print', width: 10.00001 }] });
  const runOn = async (model, ...args) =>
    runFake(['sheet', at(model), '--set', 'environment=none', '--set', 'quality=draft', '--spec', spec, ...args], {
      api: await import('../../../js/index.mjs'),
    });
  const { exit, stdout, stderr } = await runOn('unknown.glb', '-o', at('unknown.pdf'), '--json');
  assert.equal(exit, 0, stderr);
  const codes = ['W_EXT_IGNORED', 'W_SHEET_ROUND', 'W_EXPOSURE'];
  assert.deepEqual(
    JSON.parse(stdout).info.warnings.map(({ code }) => code),
    codes,
  );
  for (const code of codes) assert.equal(stderr.split(code).length, 2, `${code} in ${stderr}`);
  const init = await runOn('unknown.glb', '--init', '-o', at('unknown.json'));
  assert.match(init.stderr, /W_EXT_IGNORED/);
  // White paper about a grey square: of the spec alone there is something to tell.
  writeFileSync(
    at('grey.glb'),
    editedGlb(readFileSync(at('square.glb')), (json) => (json.materials[0].pbrMetallicRoughness.baseColorFactor = [0.2, 0.2, 0.2, 1])),
  );
  const strict = await runOn('grey.glb', '-o', at('strict.pdf'), '--fail-on', 'warning', '--json');
  const { error } = JSON.parse(strict.stdout);
  assert.deepEqual([strict.exit, error.code, error.pointer], [3, 'E_WARNING', '/artwork/0/width']);
  assert.match(error.message, /^W_SHEET_ROUND: /);
  assert.ok(!existsSync(at('strict.pdf')));
});
