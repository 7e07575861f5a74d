import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { shotHeaders, visitRows } from '../../../js/build/docs/shot_cpp.mjs';
import { debugQuantitiesGlsl, toneMappingsGlsl } from '../../../js/build/docs/shot_glsl.mjs';
import { DEBUG_QUANTITIES } from '../../../js/shot/table/debug_quantities.mjs';
import { SHOT } from '../../../js/shot/table/index.mjs';
import { but, choice, number } from '../../../js/shot/table/rows.mjs';
import { TONE_MAPPINGS } from '../../../js/shot/table/tone_mappings.mjs';

const THREE = await import('three');
const read = (path) => readFileSync(new URL(`../../../${path}`, import.meta.url), 'utf8');
const HEADER = (name) => `renderer/include/telar/shot/${name}.inc`;

/** The shot with another row in `output`. */
const planted = (key, row) => but(SHOT, { shape: { ...SHOT.shape, output: but(SHOT.shape.output, { shape: { ...SHOT.shape.output.shape, [key]: row } }) } });
const factor = (rest) => number('How much more', { unit: 'factor', min: 0, max: 9, default: 1, ...rest });

test('a number of the table is a member with its meaning and its default, and is read', () => {
  const shot = planted('gain', factor());
  const header = shotHeaders(shot)[HEADER('output')];
  assert.match(header, /\/\/\/ How much more \[factor, 0 to 9\]\n {2}double gain = 1;\n/);
  assert.match(visitRows(shot), /\n {2}\}\);\n {2}on\("gain", row\.gain\);\n/);
  assert.doesNotMatch(visitRows(), /gain/, 'and no other is');
});

test('whole numbers are read with their range, as they size what is allocated', () => {
  assert.match(visitRows(planted('parts', factor({ integer: true }))), /on\("parts", row\.parts, 0, 9\);/);
  assert.match(visitRows(), /on\("width", row\.width, 1, 8192\);/);
  assert.match(visitRows(), /on\("samples", row\.samples, \{1, 4, 16, 64, 256, 1024\}\);/);
});

test('what the renderer does not draw is not read', () => {
  const shot = planted('note', factor({ drawn: false }));
  assert.doesNotMatch(`${visitRows(shot)}${shotHeaders(shot)[HEADER('output')]}`, /note/);
});

test('what only some variants have is read of those alone', () => {
  const [, spot] = /case Light::Type::kSpot:\n(.*?)break;/s.exec(visitRows());
  assert.match(spot, /"penumbra"/);
  assert.match(
    spot,
    /if \(row\.castShadow\) \{\n\s+on\.within\("shadow", \[&\]\(const auto& shadow\) \{\n\s+shadow\("mapSize", row\.shadow\.mapSize, 16, 4096\);/,
  );
  const [, rect] = /case Light::Type::kRect:\n(.*?)break;/s.exec(visitRows());
  assert.doesNotMatch(rect, /penumbra|shadow/);
});

test('enums have the names of the table in its order: another order is another text', () => {
  const { format } = SHOT.shape.output.shape;
  const reversed = choice(format.doc, format.values.toReversed(), { name: format.name, default: format.default });
  const text = shotHeaders(planted('format', reversed))[HEADER('output')];
  assert.match(text, /enum class Format : std::uint8_t \{ kRaw, kExr, kTiff, kWebp, kJpeg, kPng \};/);
  assert.match(text, /return \{"raw", "exr", "tiff", "webp", "jpeg", "png"\};/);
  assert.notEqual(text, read(HEADER('output')));
  assert.equal(shotHeaders()[HEADER('output')], read(HEADER('output')));
});

/** Numbers of `#define PREFIX_NAME number`. */
const defines = (glsl, prefix) => [...glsl.matchAll(new RegExp(`^#define ${prefix}_(\\w+) (\\d+)`, 'gm'))].map(([, name, value]) => [name, Number(value)]);

test('shaders and C++ number tone mappings and quantities alike', () => {
  const enumOf = (file, name) =>
    new RegExp(`enum class ${name} : std::uint8_t \\{ (.*) \\};`)
      .exec(read(HEADER(file)))[1]
      .split(', ')
      .map((k) => k.slice(1).toUpperCase());
  const plain = (rows) => rows.map(([name, value]) => [name.replaceAll('_', ''), value]);
  assert.deepEqual(
    plain(defines(toneMappingsGlsl(), 'TONE_MAPPING')),
    enumOf('tone_mapping', 'ToneMapping').map((name, i) => [name, i]),
  );
  assert.deepEqual(
    plain(defines(debugQuantitiesGlsl(), 'DEBUG')),
    enumOf('debug_output', 'DebugOutput')
      .map((name, i) => [name, i])
      .slice(1),
  );
  const [first, ...rest] = Object.entries(DEBUG_QUANTITIES);
  assert.notEqual(debugQuantitiesGlsl(Object.fromEntries([...rest, first])), read('shaders/debug_quantities.glsl'), 'another order is another text');
});

test('a row alone brings a tone mapping to C++ and shaders: its enumerator, its name, its define and its call', () => {
  const table = { ...TONE_MAPPINGS, planted: { three: 'CustomToneMapping', glsl: 'toneMapPlanted' } };
  const { toneMapping } = SHOT.shape;
  const shot = but(SHOT, { shape: { ...SHOT.shape, toneMapping: but(toneMapping, { values: Object.keys(table) }) } });
  const header = shotHeaders(shot, table)[HEADER('tone_mapping')];
  assert.match(header, /enum class ToneMapping : std::uint8_t \{ .*, kPlanted \};/);
  assert.match(header, / {2}T\(kPlanted, toneMapPlanted, "CustomToneMapping"\)\n/);
  assert.match(header, /return \{.*, "planted"\};/);
  const glsl = toneMappingsGlsl(table);
  assert.ok(defines(glsl, 'TONE_MAPPING').some(([name, value]) => name === 'PLANTED' && value === Object.keys(TONE_MAPPINGS).length));
  assert.match(glsl, /#elif TONE_MAPPING == TONE_MAPPING_PLANTED\n {2}return toneMapPlanted\(color, exposure\);/);
  assert.doesNotMatch(`${shotHeaders()[HEADER('tone_mapping')]}${toneMappingsGlsl()}`, /planted/i);
});

/** Files that name a tone mapping beside the table, its function and what is generated: they choose one, as a look does. */
const CHOOSERS = ['js/cli/analyse.mjs', 'js/shot/table/looks.mjs', 'js/view/page/text.mjs'];

/** Files by hand that name one. "neutral" and "none" are words, and C++ knows both: releases of three.js draw neutral in two ways. */
const namersOf = (texts) => {
  const names = Object.entries(TONE_MAPPINGS).filter(([name]) => !['neutral', 'none', 'linear'].includes(name));
  const pattern = new RegExp(`\\b(?:${names.flatMap(([name, { glsl }]) => [name, glsl]).join('|')})\\b`);
  return [...texts].filter(([, text]) => pattern.test(text) && !/^\/\/ Generated by /.test(text)).map(([file]) => file);
};

test('no other file by hand has a list of tone mappings', () => {
  const files = ['renderer', 'addon', 'shaders', 'js'].flatMap((folder) =>
    readdirSync(new URL(`../../../${folder}`, import.meta.url), { recursive: true }).map((name) => `${folder}/${name}`),
  );
  const sources = files.filter((file) => /\.(mjs|cpp|h|inl|inc|glsl|vert|frag|html)$/.test(file) && !/^js\/(dist|docs)\//.test(file));
  const texts = new Map(sources.map((file) => [file, read(file)]));
  assert.deepEqual(namersOf(texts).toSorted(), [...CHOOSERS, 'js/shot/table/tone_mappings.mjs', 'shaders/brdf/tone_mapping.glsl'].toSorted());
  assert.deepEqual(namersOf(new Map([['renderer/pass/planted.cpp', 'case ToneMapping::kAgx: return brdf_f::toneMapAgx;']])), ['renderer/pass/planted.cpp']);
});

/** What is wrong with the rows of the tone mappings and of the quantities. */
function faults(toneMappings, quantities) {
  const curves = read('shaders/brdf/tone_mapping.glsl');
  const constants = Object.values(toneMappings).map(({ three }) => THREE[three]);
  return [
    ...Object.entries(toneMappings)
      .filter(([, { three }]) => !Number.isInteger(THREE[three]))
      .map(([name]) => `${name}: three.js has no such constant`),
    ...(new Set(constants).size < constants.length ? ['two tone mappings are one in three.js'] : []),
    ...Object.entries(toneMappings)
      .filter(([, { glsl }]) => glsl && !curves.includes(`vec3 ${glsl}(vec3 color, float exposure)`))
      .map(([name]) => `${name}: tone_mapping.glsl has no such function`),
    ...Object.entries(quantities)
      .filter(([, { doc }]) => !doc)
      .map(([name]) => `${name}: has no doc`),
    ...Object.entries(quantities)
      .filter(([name, { of }]) => !debugQuantitiesGlsl({ [name]: quantities[name] }).includes('case ') || !of)
      .map(([name]) => `${name}: nothing has it`),
  ];
}

test('the rows of tone mappings and quantities hold, and planted faults in them are found', () => {
  assert.deepEqual(faults(TONE_MAPPINGS, DEBUG_QUANTITIES), []);
  assert.deepEqual(faults({ filmic: { three: 'FilmicToneMapping', glsl: 'toneMapAces' } }, {}), ['filmic: three.js has no such constant']);
  assert.deepEqual(faults({ a: TONE_MAPPINGS.aces, b: TONE_MAPPINGS.aces }, {}), ['two tone mappings are one in three.js']);
  assert.deepEqual(faults({ aces: { ...TONE_MAPPINGS.aces, glsl: 'toneMapFilmic' } }, {}), ['aces: tone_mapping.glsl has no such function']);
  assert.deepEqual(faults({}, { n: { ...DEBUG_QUANTITIES.n, doc: '' } }), ['n: has no doc']);
  assert.deepEqual(faults({}, { n: { ...DEBUG_QUANTITIES.n, of: 'surface' } }), ['n: nothing has it']);
});
