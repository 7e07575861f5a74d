// That the scripts make the committed assets. All of them take over a minute: made.json says of which text of the scripts they are, and the
// quick ones are made again. `npm run assets` makes all.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cp, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { assetHashes, MADE_FILE, sourcesHash } from '../../../js/assets/make/made.mjs';

const ASSETS = fileURLToPath(new URL('../../../js/assets/', import.meta.url));
const MAKE = path.join(ASSETS, 'make');
const QUICK = ['studio.hdr', 'cloths/leather.glb', 'cloths/tulle.glb', 'cloths/cotton-jersey.glb'];

const made = JSON.parse(await readFile(path.join(ASSETS, MADE_FILE), 'utf8'));

async function folderFor(context) {
  const folder = await mkdtemp(path.join(tmpdir(), 'telar-assets-'));
  context.after(() => rm(folder, { recursive: true, force: true }));
  return folder;
}

test('the assets are those that the scripts as they are have made', async () => {
  assert.equal(await sourcesHash(), made.sources, 'the scripts changed: npm run assets');
  const names = Object.keys(made.files);
  assert.deepEqual(await assetHashes(ASSETS, names), made.files, 'an asset changed: npm run assets');
  const cloths = (await readdir(path.join(ASSETS, 'cloths'))).map((name) => `cloths/${name}`);
  assert.deepEqual(names.sort(), [...cloths, 'fabrics.glb', 'studio.hdr', 'tshirt.glb'].sort());
});

test('the quick assets come out again, byte for byte', { timeout: 600e3 }, async (context) => {
  const folder = await folderFor(context);
  const run = spawnSync(process.execPath, [path.join(MAKE, 'index.mjs'), folder, ...QUICK], { encoding: 'utf8' });
  assert.equal(run.status, 0, run.stderr);
  for (const [name, hash] of Object.entries(await assetHashes(folder, QUICK)))
    assert.equal(hash, made.files[name], `js/assets/${name} is stale: npm run assets`);
});

test('a number that changes in a script, and a script more, are seen', async (context) => {
  const folder = await folderFor(context);
  const copyOf = async (name) => {
    const copy = path.join(folder, name);
    await cp(MAKE, copy, { recursive: true });
    return copy;
  };
  assert.equal(await sourcesHash(await copyOf('same')), made.sources);
  const edited = await copyOf('edited');
  const script = path.join(edited, 'cloths/noise.mjs');
  const text = await readFile(script, 'utf8');
  await writeFile(
    script,
    text.replace(/\d/, (digit) => (Number(digit) + 1) % 10),
  );
  assert.notEqual(await sourcesHash(edited), made.sources);
  const grown = await copyOf('grown');
  await cp(path.join(grown, 'studio.mjs'), path.join(grown, 'studio_2.mjs'));
  assert.notEqual(await sourcesHash(grown), made.sources);
});
