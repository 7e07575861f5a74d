import assert from 'node:assert/strict';
import { existsSync, mkdirSync, mkdtempSync, realpathSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { drewNothing, runFake } from './fake.mjs';

// Models by GLB, by links and by file: URLs: their parts and variants are found alike.

const root = realpathSync(mkdtempSync(path.join(tmpdir(), 'telar-names-')));
after(() => rmSync(root, { recursive: true }));
let folders = 0;

/** A fresh folder with files by name; a function that makes paths in it. */
function tree(files) {
  const folder = path.join(root, String(++folders));
  for (const [name, data] of Object.entries(files)) {
    mkdirSync(path.dirname(path.join(folder, name)), { recursive: true });
    writeFileSync(path.join(folder, name), data);
  }
  return (...names) => path.join(folder, ...names);
}

const withImages = (...uris) => JSON.stringify({ asset: { version: '2.0' }, images: uris.map((uri) => ({ uri })) });
const withVariants = (...names) =>
  JSON.stringify({ asset: { version: '2.0' }, extensions: { KHR_materials_variants: { variants: names.map((name) => ({ name })) } } });

/** A GLB of a JSON chunk alone. */
function glb(json) {
  const text = Buffer.from(json.padEnd(4 * Math.ceil(json.length / 4)));
  const header = Buffer.alloc(20);
  for (const [i, word] of [0x46546c67, 2, 20 + text.length, text.length, 0x4e4f534a].entries()) header.writeUInt32LE(word, 4 * i);
  return Buffer.concat([header, text]);
}

const urlOf = (file) => pathToFileURL(file).href;

test('a picture is not written over a part of a model, whatever the model and the folder are called', async () => {
  const at = tree({
    'in/shirt.glb': glb(withImages('base.png')),
    'in/coat.gltf': withImages('base.png'),
    'in/base.png': 'a texture',
    'in/no ending': withImages('base.png'),
    'other/other.png': '',
  });
  symlinkSync(at('in'), at('link'));
  symlinkSync(at('in/base.png'), at('other/leads.png'));
  for (const [model, output] of [
    [at('in/shirt.glb'), at('in/base.png')],
    [at('in/no ending'), at('in/base.png')],
    [at('link/coat.gltf'), at('link/base.png')],
    [at('link/coat.gltf'), at('in/base.png')],
    [at('in/coat.gltf'), at('link/base.png')],
    [at('in/coat.gltf'), at('other/leads.png')],
    [urlOf(at('in/coat.gltf')), at('in/base.png')],
    [urlOf(at('in/shirt.glb')), at('link/base.png')],
  ]) {
    const { exit, stderr, calls } = await runFake(['thumbnail', model, '-o', output]);
    assert.deepEqual([exit, drewNothing(calls)], [2, true], `${model} ${output} ${stderr}`);
    assert.match(stderr, /"base\.png" would be overwritten, a part of the model/);
  }
  const { exit } = await runFake(['thumbnail', at('in/shirt.glb'), '-o', at('other/other.png')]);
  assert.equal(exit, 0);
});

test('a picture is not written over a model that a link or a URL names', async () => {
  const at = tree({ 'shirt.glb': glb(withImages()), 'shot.json': '{"output":{"format":"png"}}' });
  symlinkSync(at('shirt.glb'), at('link.glb'));
  for (const [model, output] of [
    [at('link.glb'), at('shirt.glb')],
    [at('shirt.glb'), at('link.glb')],
    [urlOf(at('shirt.glb')), at('shirt.glb')],
  ]) {
    const { exit, stderr, calls } = await runFake(['thumbnail', model, '-o', output, '--shot', at('shot.json')]);
    assert.deepEqual([exit, drewNothing(calls)], [2, true], stderr);
    assert.match(stderr, /-o would overwrite the model ".*\.glb"/);
  }
});

test('a file: URL stands for its path: names, variants, manifests', async () => {
  const at = tree({ 'a b/coat.glb': glb(withVariants('navy')) });
  const url = urlOf(at('a b/coat.glb'));
  const all = await runFake(['thumbnail', url, '-o', at('out/{name}-{variant}.png'), '--variants', 'all', '--json']);
  assert.deepEqual(
    JSON.parse(all.stdout).images.map(({ model, output }) => [model, output]),
    [[at('a b/coat.glb'), at('out/coat-navy.png')]],
  );
  const folder = await runFake(['thumbnail', '-r', urlOf(at('a b')), '-o', `${at('many')}/`]);
  assert.deepEqual([folder.exit, existsSync(at('many/coat.png'))], [0, true]);
  const listed = await runFake(['thumbnail', '--manifest', '-'], { stdin: JSON.stringify({ model: url, output: at('m.png') }) });
  assert.deepEqual([listed.exit, listed.calls.rendered.map(({ source }) => source)], [0, [at('a b/coat.glb')]]);
  const { calls } = await runFake(['inspect', url]);
  assert.deepEqual(
    calls.inspected.map(({ source }) => source),
    [at('a b/coat.glb')],
  );
  const { exit, stderr } = await runFake(['thumbnail', 'file://elsewhere/coat.glb', '-o', at('b.png')]);
  assert.deepEqual([exit, /"file:\/\/elsewhere\/coat\.glb" means no file of this machine: give its path/.test(stderr)], [2, true], stderr);
});

test('telar bake by a file: URL writes into the folder of the model, and no other', async () => {
  const at = tree({ 'm.gltf': withImages(), 'out/x': '' });
  assert.equal((await runFake(['bake', urlOf(at('m.gltf')), '-o', at('baked.gltf')])).exit, 0);
  const { exit, stderr } = await runFake(['bake', urlOf(at('m.gltf')), '-o', at('out/baked.gltf')]);
  assert.deepEqual([exit, /the model names "m\.bin" beside it; write into the folder of the model/.test(stderr)], [2, true], stderr);
});
