// telar's text is its own: it follows three.js in numbers and not in words.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { forEachToken, sharedRuns } from '../own_text/runs.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const RUN = 60;
const SOURCE = /\.(h|cpp|in|inl|inc|glsl|frag|vert|mjs|js|cjs)$/;

const read = (file) => readFileSync(path.join(ROOT, file), 'utf8');

function texts(folders, skipped) {
  const files = folders.flatMap((folder) => readdirSync(path.join(ROOT, folder), { recursive: true }).map((name) => `${folder}/${name}`));
  return new Map(files.filter((file) => SOURCE.test(file) && !skipped.some((folder) => file.startsWith(folder))).map((file) => [file, read(file)]));
}

const OWN = texts(['shaders', 'renderer', 'addon', 'js'], ['js/dist/']);
const THREE = texts(['node_modules/three/src', 'node_modules/three/examples/jsm'], ['node_modules/three/examples/jsm/libs/']);

// The tables that others made: a part of NOTICE begins with the file.
const TABLES = [...read('NOTICE').matchAll(/^\S+\.inc$/gm)].map(([file]) => file);

test(`no run of ${RUN} tokens stands in three.js too`, () => {
  assert.ok(OWN.size > 400 && THREE.size > 1000, `the texts were found: ${OWN.size}, ${THREE.size}`);
  const found = sharedRuns(new Map([...OWN].filter(([file]) => !TABLES.includes(file))), THREE, RUN);
  assert.deepEqual(
    found.map((run) => `${run.ours} has ${run.tokens} tokens of ${run.theirs}`),
    [],
  );
});

test('a planted run is found where it stands, under any layout and comments', () => {
  const file = 'node_modules/three/src/extras/PMREMGenerator.js';
  const line = THREE.get(file)
    .split('\n')
    .findIndex((text) => text.includes('void main()'));
  const taken = THREE.get(file).split('\n').slice(line).join('\n');
  const words = [];
  forEachToken(taken, (word) => words.push(word));
  const planted = (count) => new Map([['shaders/planted.frag', `own words\n// before\n${words.slice(0, count).join(' /* between */\n')}\nand own again`]]);
  const theirs = new Map([[file, THREE.get(file)]]);
  const [found, ...others] = sharedRuns(planted(RUN), theirs, RUN);
  assert.deepEqual(others, []);
  assert.deepEqual(found, { ours: 'shaders/planted.frag:3', theirs: `${file}:${line + 1}`, tokens: RUN });
  assert.deepEqual(sharedRuns(planted(RUN - 1), theirs, RUN), []);
  const renamed = new Map([...planted(3 * RUN)].map(([name, text]) => [name, text.replaceAll(/\b[a-z]\w*/g, (word) => `${word}_`)]));
  assert.deepEqual(sharedRuns(renamed, theirs, RUN), [], 'own names are own text');
});

test('NOTICE names what carries a licence', () => {
  const carrying = [...OWN]
    .filter(([file, text]) => !file.startsWith('js/assets/make/') && /Copyright \(c\)|\bcopyright \d{4}/i.test(text))
    .map(([file]) => file);
  assert.deepEqual(carrying.sort(), TABLES.sort());
  assert.ok(JSON.parse(read('package.json')).files.includes('NOTICE'), 'it is packed');
  const words = (text) => text.match(/\w+/g).join(' ');
  const licence = read(TABLES.find((file) => file.includes('ltc'))).match(/Copyright \(c\) 2017[\s\S]*?POSSIBILITY OF SUCH DAMAGE/)[0];
  for (const text of [licence, read('node_modules/three/LICENSE')]) assert.ok(words(read('NOTICE')).includes(words(text)), text.slice(0, 80));
});
