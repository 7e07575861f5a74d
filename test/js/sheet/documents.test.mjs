import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { createSheet } from '../../../js/sheet/index.mjs';
import { layOut } from '../../../js/sheet/sheet.mjs';
import { faultsOf, fonts, layoutFaults, wordFaults, wordsOf } from './documents.mjs';
import { randomSpec } from './random_specs.mjs';
import { CHEAP, openSquare } from './square.mjs';

let renderer;
let model;
before(async () => {
  ({ renderer, model } = await openSquare());
});
after(() => renderer.close());

/** node test/js/sheet/documents.mjs 500 lays out more of them. */
const DOCUMENTS = 16;

test(`${DOCUMENTS} random documents: nothing overlaps, crosses, leaves the page or is lost`, async () => {
  for (let seed = 1; seed <= DOCUMENTS; ++seed) assert.deepEqual(await faultsOf(renderer, model, randomSpec(seed)), [], `seed ${seed}`);
});

const SETTINGS = { format: 'pdf', templates: {}, shot: CHEAP };
const callouts = Array.from({ length: 6 }, (_, i) => ({ point: [-0.12 + 0.05 * i, 0.2 + 0.04 * i, 0], text: `Text number Q${i}Z of the call-outs` }));
const measures = [
  {
    code: 'A',
    description: 'width',
    points: [
      [-0.15, 0.15, 0],
      [0.15, 0.15, 0],
    ],
  },
];

test('planted faults of a layout are seen', async () => {
  const laid = await layOut(model, { callouts, measures, ppi: 36 }, { ...SETTINGS, renderer, fonts: [] });
  laid.engine.close();
  assert.deepEqual(layoutFaults(laid), []);
  const seen = (plant) => {
    const sections = structuredClone(laid.sections);
    const layout = { spec: laid.layout.spec, warnings: laid.layout.warnings };
    plant(sections.find(({ figure }) => figure?.labels.length > 0).figure, sections.find(({ figure }) => figure?.codes.length > 0).figure);
    return layoutFaults({ sections, layout }).join('\n');
  };
  const cases = [
    [/call-out 1 lies on call-out/, ({ labels }) => Object.assign(labels[0], { x: labels[1].x, y: labels[1].y })],
    [/call-out 1 leaves its page/, ({ labels }) => Object.assign(labels[0], { x: -3 })],
    [/call-out 1 lies on a picture/, ({ labels, pictures }) => Object.assign(labels[0], { x: pictures[0].x + 5, y: pictures[0].y + 5 })],
    [/call-outs are lost/, ({ labels }) => labels.pop()],
    [/leader \d crosses another/, ({ lines }) => ([lines[0].points[0], lines[1].points[0]] = [lines[1].points[0], lines[0].points[0]])],
    [/leader 0 strikes a text/, ({ lines, labels }) => lines[0].points.unshift([labels[2].x + 1, labels[2].y + 1])],
    [/a site lies off its picture/, ({ sites }) => sites.push([1, 1])],
    [/a line leaves its page/, (_, { lines }) => (lines[0].points[0] = [-5, 3])],
    [/points of measure are lost/, (_, { codes }) => codes.pop()],
    [/a caption leaves its page/, ({ captions, height }) => (captions[0].y = height + 1)],
  ];
  for (const [message, plant] of cases) assert.match(seen(plant), message);
});

test('planted faults of a page are seen', async () => {
  const { files } = await createSheet(model, { callouts, ppi: 36 }, { renderer, shot: SETTINGS.shot });
  const told = callouts.map((_, i) => `Q${i}Z`);
  const pages = wordsOf(files[0]);
  assert.deepEqual(wordFaults(pages, told), []);
  const seen = (plant) => {
    const copy = structuredClone(pages);
    const page = copy.find(({ words }) => words.some(({ text }) => text === 'Q3Z'));
    plant(page.words, page);
    return wordFaults(copy, told).join('\n');
  };
  const at = (words, text) => words.find((word) => word.text === text);
  assert.match(
    seen((words) => words.splice(words.indexOf(at(words, 'Q3Z')), 1)),
    /Q3Z is lost/,
  );
  assert.match(
    seen((words, { width }) => (at(words, 'Q3Z').x = width - 20)),
    /"Q3Z" leaves the page/,
  );
  assert.match(
    seen((words) => Object.assign(at(words, 'Q3Z'), { x: at(words, 'Q4Z').x + 2, y: at(words, 'Q4Z').y })),
    /"Q[34]Z" lies on "Q[34]Z"/,
  );
});

/** What becomes of a spec that means harm: a typed error with its pointer, or a page. */
async function hostile(spec, options = {}) {
  return createSheet(model, spec, { renderer, shot: SETTINGS.shot, fonts: fonts(), ...options }).then(
    ({ files }) => ({ pages: wordsOf(files[0]) }),
    ({ code, pointer, message }) => ({ code, pointer, message }),
  );
}

test('a hostile spec ends in a typed error that names its place, or in a page', async () => {
  const huge = 'x'.repeat(10 * 2 ** 20);
  const refused = [
    [{ notes: huge }, ''],
    [{ callouts: Array.from({ length: 10_000 }, () => ({ point: [0, 0.3, 0], text: 'a' })) }, '/callouts'],
    [{ bill: Array.from({ length: 100_000 }, () => ({ item: 'a' })) }, '/bill'],
    [{ words: Object.fromEntries(Array.from({ length: 1000 }, (_, i) => [`w${i}`, 'a'])) }, '/words'],
    [JSON.parse('{"__proto__": {"ppi": 1}, "header": {"__proto__": {"name": 1}}}'), undefined],
    [{ notes: 'a\u0000b' }, '/notes'],
    [{ header: { logo: '../../../etc/passwd' } }, '/header/logo'],
    [{ template: '../../other' }, '/template'],
  ];
  for (const [spec, pointer] of refused) {
    const { code, pointer: at, message } = await hostile(spec);
    assert.equal(code, 'E_SPEC', `${JSON.stringify(spec).slice(0, 80)}: ${message}`);
    if (pointer !== undefined) assert.equal(at, pointer, message);
    assert.ok(message.length < 500, message.slice(0, 600));
  }
});

test('code of Typst in any text is printed and never run', async () => {
  const code = '#read("/etc/passwd") #panic("x") $x^2$ *b* _i_ `r` <l> @c \\ ]] }) // c /* d';
  const spec = {
    header: { name: code, style: code, description: code },
    views: [{ name: code, title: code }],
    callouts: [{ view: code, point: [0, 0.3, 0], text: code }],
    bill: [{ item: code, supplier: code }],
    notes: code,
    revisions: [{ revision: code, text: code }],
    words: { bill: code },
  };
  const { pages, message } = await hostile(spec);
  assert.ok(pages, message);
  const text = pages.flatMap(({ words }) => words.map((word) => word.text)).join(' ');
  assert.ok(text.split('#panic(&quot;x&quot;)').length > 8, text.slice(0, 500));
  assert.ok(!text.includes('root:'));
});

test('the longest lists and texts that a spec may have end in pages', async () => {
  const spec = {
    ppi: 36,
    callouts: Array.from({ length: 500 }, (_, i) => ({
      point: [((i * 37) % 290) / 1000 - 0.145, 0.16 + ((i * 17) % 280) / 1000, 0],
      text: `Q${i}Z ${'word '.repeat(i % 9)}`,
    })),
    bill: Array.from({ length: 500 }, (_, i) => ({ item: `R${i}Z` })),
    notes: 'word '.repeat(799),
  };
  const { pages, message } = await hostile(spec);
  assert.ok(pages, message);
  assert.deepEqual(wordFaults(pages, [...spec.callouts.map((_, i) => `Q${i}Z`), ...spec.bill.map((_, i) => `R${i}Z`)]), []);
});
