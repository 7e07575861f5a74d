import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import { test } from 'node:test';
import validator from 'gltf-validator';
import { CONSTRUCTIONS } from '../../../js/assets/make/cloths/constructions.mjs';
import { PRESETS } from '../../../js/assets/make/cloths/index.mjs';
import { inspect } from '../../../js/index.mjs';

const FOLDER = new URL('../../../js/assets/cloths/', import.meta.url);
const NAMES = Object.keys(PRESETS);

// That the script makes these files is looked at in made.test.mjs.
test('each preset has a construction and a file, and nothing else lies there', async () => {
  assert.deepEqual(Object.keys(CONSTRUCTIONS).sort(), [...NAMES].sort());
  assert.deepEqual((await readdir(FOLDER)).sort(), NAMES.map((name) => `${name}.glb`).sort());
});

test('the page shows each preset in pictures that a reader need not wait for', async () => {
  const docs = new URL('../../../js/docs/', import.meta.url);
  const shown = [...(await readFile(new URL('cloths.md', docs), 'utf8')).matchAll(/\]\((cloths\/[^)]+)\)/g)].map(([, file]) => file);
  assert.deepEqual(
    shown,
    NAMES.map((name) => `cloths/${name}.webp`),
  );
  const sizes = await Promise.all(shown.map(async (file) => (await readFile(new URL(file, docs))).length));
  assert.ok(Math.max(...sizes) <= 300_000 && sizes.reduce((sum, size) => sum + size) <= 1_500_000, sizes.join());
});

const SOURCE = /\((usual|geometry|reasoned)\)$|\[[^\]]+\]$/;
const numbersIn = (lines, pattern) => lines.map((line) => pattern.exec(line)?.slice(1).map(Number)).filter(Boolean);

/** What the maps of a cloth are made with: depth of its relief in mm, less the outermost 2 % of both sides, and its cover. */
function measured({ field, threads, perCm }) {
  const [heights, cells] = [[], 160];
  for (let i = 0; i < cells ** 2; i++) {
    const { cover = 1, height } = field(((i % cells) / cells) * threads, (Math.floor(i / cells) / cells) * threads);
    if (cover) heights.push(height);
  }
  heights.sort((a, b) => a - b);
  const at = (part) => heights[Math.min(Math.floor(part * heights.length), heights.length - 1)];
  return { relief: ((at(0.98) - at(0.02)) * 10) / perCm[0], cover: heights.length / cells ** 2 };
}

for (const name of NAMES) {
  test(`${name}: every number of its construction says where it is from`, () => {
    const { construction, threadsPerCm, summary } = PRESETS[name];
    const { perCm, ...rest } = CONSTRUCTIONS[name];
    for (const line of construction) assert.match(line, SOURCE);
    assert.deepEqual(numbersIn(construction, /^threads per cm ([\d.]+) x ([\d.]+): /), threadsPerCm ? [threadsPerCm] : []);
    assert.deepEqual(numbersIn(construction, /^units per cm ([\d.]+) x ([\d.]+): /), perCm ? [perCm] : []);
    const own = measured({ ...rest, perCm: perCm ?? threadsPerCm });
    const [[relief], ...more] = numbersIn(construction, /^relief ([\d.]+) mm: /);
    assert.equal(more.length, 0);
    assert.ok(Math.abs(relief / own.relief - 1) < 0.15, `relief ${relief} mm, the maps have ${own.relief}`);
    const covers = numbersIn(construction, /^cover ([\d.]+): /).flat();
    assert.equal(covers.length, rest.holes || rest.sheer ? 1 : 0);
    for (const cover of covers) assert.ok(Math.abs(cover - own.cover) < 0.02, `cover ${cover}, the maps have ${own.cover}`);
    const weights = [...summary.matchAll(/([\d.]+) (?:g\/m2|oz\/yd2)/g)].map(([, weight]) => Number(weight));
    assert.deepEqual(numbersIn(construction, /^weight ([\d.]+) (?:g\/m2|oz\/yd2): /).flat(), weights);
  });
}

for (const name of NAMES) {
  test(`${name}: valid, small, a square of 10 cm`, async () => {
    const bytes = await readFile(new URL(`${name}.glb`, FOLDER));
    assert.ok(bytes.length <= 300_000, `${bytes.length} bytes`);
    const { issues } = await validator.validateBytes(new Uint8Array(bytes));
    // Of the extensions it does not know telar's; tangents follow the texture coordinates.
    const known = ['MESH_PRIMITIVE_GENERATED_TANGENT_SPACE', 'UNSUPPORTED_EXTENSION'];
    assert.deepEqual(
      issues.messages.filter(({ severity, code }) => severity < 2 && !known.includes(code)),
      [],
    );
    const facts = await inspect(bytes, { shot: { shading: 'fabric' } });
    assert.deepEqual([facts.warnings, facts.materials.length, facts.size.map((metres) => Number(metres.toFixed(6)))], [[], 1, [0.1, 0.1, 0]]);
  });
}
