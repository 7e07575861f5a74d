import assert from 'node:assert/strict';
import { after, before, beforeEach, test } from 'node:test';
import { TelarError } from '../../../js/error/index.mjs';
import { readSpec } from '../../../js/sheet/index.mjs';
import { openView } from '../../../js/view/index.mjs';
import { strip } from '../api/support/strip.mjs';
import './support.mjs';
import '../built.mjs';

// The spec behind a page, with a stand-in for the renderer: what is read, measured, refused and written.

const FACTS = { bounds: { min: [0, 0, 0], max: [1, 1, 1] }, variants: ['indigo'], materials: [], cameras: [], warnings: [] };

const asked = [];
const model = {
  facts: FACTS,
  async measure({ signal, ...options }) {
    asked.push(options);
    if (options.join === 1) throw new TelarError('E_MEASURE', 'no way joins them', { pointer: '/points/1' });
    return { length: 0.25, points: [{ moved: 0 }, { moved: options.points[1][0] }], polyline: options.points };
  },
};
const renderer = {
  backend: 'osmesa',
  gl: { renderer: 'stand-in', version: '1' },
  load: async () => model,
  factsOf: async () => FACTS,
  release: async () => {},
};

/** Four spaces, a list that the page knows nothing of, and no line feed at the end. */
const SPEC = {
  notes: 'Wash \u00e9cru first.',
  header: { style: 'TL-01', sizes: ['S', 'M'], baseSize: 'M' },
  views: [
    { name: 'f', view: 'front' },
    { name: 'b', view: 'back', variant: 'indigo' },
  ],
  anchors: { hem: [0, 0, 0.5] },
  measures: [{ code: 'A', description: 'Length', points: ['hem', [0, 1, 0]], how: 'along', along: 'surface', view: 'b', values: { M: 3 }, grade: 1 }],
  bill: [{ item: 'Cloth' }],
};
const TEXT = JSON.stringify(SPEC, null, 4);

const file = { bytes: undefined, writes: 0 };
const spec = {
  name: 'shirt.json',
  read: async () => file.bytes,
  write: async (bytes) => {
    file.writes++;
    file.bytes = Buffer.from(bytes);
  },
};
const opened = (options) => openView({ renderer, source: strip(), shot: {}, ...options });

let view;
before(async () => {
  view = await opened({ spec });
});
after(() => view?.close());
beforeEach(() => {
  file.bytes = Buffer.from(TEXT);
  file.writes = 0;
});

const post = async (target, body, { type = 'application/json', headers = {}, url = view.url } = {}) => {
  const response = await fetch(url + target, {
    method: 'POST',
    headers: { 'content-type': type, ...headers },
    body: typeof body === 'string' ? body : JSON.stringify(body),
  });
  const text = await response.text();
  return { status: response.status, ...(text.startsWith('{') ? JSON.parse(text) : { text }) };
};
const described = async () => (await fetch(`${view.url}spec`)).json();

test('the page gets the lists as they stand in the file, and what it needs of the rest', async () => {
  const { views, version, ...rest } = await described();
  assert.deepEqual(rest, {
    name: 'shirt.json',
    isNew: false,
    callouts: [],
    measures: SPEC.measures,
    anchors: SPEC.anchors,
    units: 'cm',
    printedUnits: 'cm',
    baseSize: 'M',
  });
  assert.match(version, /^[0-9a-f]{64}$/);
  assert.deepEqual(
    views.map(({ name, back }) => [name, ...back.map(Math.round)]),
    [
      ['f', 0, 0, 1],
      ['b', 0, 0, -1],
    ],
  );
  assert.equal((await (await fetch(`${view.url}session`)).json()).spec, 'shirt.json');
});

test('a measure is asked for as the sheet asks for it: anchors, variant of its view, times', async () => {
  asked.length = 0;
  const { measures } = await described();
  const answer = await post('measure', { measure: { ...measures[0], times: 2 }, index: 0 });
  assert.deepEqual(asked, [
    {
      points: [
        [0, 0, 0.5],
        [0, 1, 0],
      ],
      along: 'surface',
      closed: false,
      join: 0,
      variant: 'indigo',
    },
  ]);
  assert.deepEqual(answer, { status: 200, millimetres: 500, text: '50.0 cm', path: asked[0].points, isLoop: false, warnings: [] });
});

test('a row without a place has no length; a point off the garment is told', async () => {
  assert.deepEqual(await post('measure', { measure: { code: 'B', description: 'x' }, index: 3 }), { status: 200, warnings: [] });
  const points = [
    [0, 0, 0],
    [0.5, 0, 0],
  ];
  const { warnings } = await post('measure', { measure: { code: 'B', description: 'x', points }, index: 3 });
  assert.deepEqual(warnings, ['spec.measures: a point of "B" is 500 mm off the garment']);
});

test('errors of one row name its place in the list', async () => {
  const wrong = await post('measure', { measure: { code: 'B', description: 'x', points: ['collar', [0, 0, 0]] }, index: 7 });
  assert.deepEqual([wrong.status, wrong.code, wrong.pointer], [400, 'E_SPEC', '/measures/7/points/0']);
  assert.match(wrong.message, /^spec\.measures\[7\]\.points\[0\]: there is no anchor "collar"/);
  const apart = await post('measure', {
    measure: {
      code: 'B',
      description: 'x',
      join: 1,
      points: [
        [0, 0, 0],
        [1, 0, 0],
      ],
    },
    index: 7,
  });
  assert.deepEqual([apart.code, apart.pointer], ['E_MEASURE', '/measures/7']);
});

const ADDED = [{ view: 'f', point: [0.1, 0.2, 0], text: 'Rib' }];

/** What of a spec file a save may not touch, and how it is written. */
function assertKept(text, { callouts, measures }) {
  const saved = JSON.parse(text);
  assert.deepEqual(saved, { ...SPEC, callouts, measures });
  assert.deepEqual(Object.keys(saved), [...Object.keys(SPEC), 'callouts']);
  assert.equal(text, JSON.stringify(saved, null, 4));
}

test('a save changes the edited lists and nothing else of the file', async () => {
  const { version, measures } = await described();
  const answer = await post('spec', { version, callouts: ADDED, measures });
  assert.deepEqual([answer.status, file.writes], [200, 1]);
  assertKept(file.bytes.toString(), { callouts: ADDED, measures });
  assert.equal(answer.version, (await described()).version);
});

test('planted faults: a save that writes out defaults, one that drops a list, one that loses the indentation', () => {
  const lists = { callouts: ADDED, measures: SPEC.measures };
  const faults = [
    JSON.stringify(readSpec({ ...SPEC, ...lists }, FACTS), null, 4),
    JSON.stringify({ ...SPEC, ...lists, bill: undefined }, null, 4),
    JSON.stringify({ ...SPEC, ...lists }, null, 2),
    JSON.stringify({ ...lists, ...SPEC }, null, 4),
  ];
  assertKept(JSON.stringify({ ...SPEC, ...lists }, null, 4), lists);
  for (const text of faults) assert.throws(() => assertKept(text, lists), assert.AssertionError);
});

test('a spec on one line stays on one line; one with a line feed at its end keeps it', async () => {
  for (const text of [JSON.stringify(SPEC), `${JSON.stringify(SPEC, null, '\t')}\n`]) {
    file.bytes = Buffer.from(text);
    const { version, callouts, measures } = await described();
    assert.equal((await post('spec', { version, callouts, measures })).status, 200);
    assert.equal(file.bytes.toString().trimEnd().split('\n').length, text.trimEnd().split('\n').length);
    assert.equal(file.bytes.toString().endsWith('\n'), text.endsWith('\n'));
    assert.deepEqual(JSON.parse(file.bytes), SPEC);
  }
});

test('nothing is written of a wrong spec, and the error names the place', async () => {
  const { version, measures } = await described();
  for (const [lists, pointer, message] of [
    [{ callouts: [{ text: 'x', view: 'f' }], measures }, '/callouts/0', /expected one of point, node, material, picture/],
    [{ callouts: [{ text: 'x', view: 'top', point: [0, 0, 0] }], measures }, '/callouts/0/view', /there is no view "top"/],
    [{ callouts: ADDED, measures: [...measures, measures[0]] }, '/measures/1/code', /a name that no other has/],
    [{ callouts: ADDED, measures: [{ ...measures[0], tolerance: 'much' }] }, '/measures/0/tolerance', /expected/],
    [{ callouts: ADDED, measures: [{ ...measures[0], colour: 1 }] }, '/measures/0/colour', /unknown/],
  ]) {
    const answer = await post('spec', { version, ...lists });
    assert.deepEqual([answer.status, answer.code, answer.pointer], [400, 'E_SPEC', pointer], answer.message);
    assert.match(answer.message, message);
  }
  assert.equal(file.writes, 0);
});

test('a file that another program has changed is left as it is', async () => {
  const { version, measures } = await described();
  file.bytes = Buffer.from(TEXT.replace('TL-01', 'TL-02'));
  const answer = await post('spec', { version, callouts: ADDED, measures });
  assert.deepEqual([answer.status, file.writes], [409, 0]);
  assert.match(answer.message, /"shirt\.json" was changed by another program since it was read/);
});

test('of two saves at once of one version the second is refused', async () => {
  const { version, measures } = await described();
  const answers = await Promise.all([post('spec', { version, callouts: ADDED, measures }), post('spec', { version, callouts: [], measures })]);
  assert.deepEqual(answers.map(({ status }) => status).sort(), [200, 409]);
  assert.equal(file.writes, 1);
});

test('where there is no file yet the model makes a first spec, which is written on the first save', async () => {
  file.bytes = undefined;
  const { version, isNew, measures, callouts } = await described();
  assert.deepEqual([version, isNew, callouts, measures.length, file.writes], ['new', true, [], 2, 0]);
  const { status } = await post('spec', { version, callouts: [{ ...ADDED[0], view: 'front' }], measures });
  assert.deepEqual([status, file.writes], [200, 1]);
  const saved = JSON.parse(file.bytes);
  assert.deepEqual([saved.callouts.length, saved.header.baseSize, saved.colourways[0].variant], [1, 'M', 'indigo']);
  assert.match(file.bytes.toString(), /^\{\n {2}"language": "en",[\s\S]*\n\}\n$/);
});

test('bodies are bounded and must be what a page sends', async () => {
  const { version } = await described();
  const cases = [
    ['measure', `{"measure":{"how":"${'x'.repeat(1 << 16)}"},"index":0}`, 413],
    ['spec', ' '.repeat((1 << 23) + 1), 413],
    ['spec', '{', 400],
    ['spec', 'null', 400],
    ['spec', '[]', 400],
    ['spec', { version, callouts: [] }, 400],
    ['spec', { version, callouts: [], measures: [], header: {} }, 400],
    ['measure', { measure: [], index: 0 }, 400],
    ['measure', { measure: {}, index: -1 }, 400],
    ['measure', { measure: {} }, 400],
  ];
  for (const [target, body, status] of cases) assert.equal((await post(target, body)).status, status, `${target} ${String(body).slice(0, 60)}`);
  // A form of another page needs no leave of CORS for these types.
  for (const type of ['text/plain', 'application/x-www-form-urlencoded', 'multipart/form-data'])
    assert.equal((await post('spec', { version, callouts: [], measures: [] }, { type })).status, 415);
  assert.equal((await fetch(`${view.url}spec`, { method: 'PUT', body: '{}' })).status, 404);
  assert.equal(file.writes, 0);
});

test('another page, another host and a wrong secret reach no spec', async () => {
  const { version, measures } = await described();
  const body = { version, callouts: ADDED, measures };
  assert.equal((await post('spec', body, { headers: { origin: 'http://evil.example' } })).status, 403);
  assert.equal((await post('measure', { measure: measures[0], index: 0 }, { headers: { origin: 'null' } })).status, 403);
  const { origin } = new URL(view.url);
  for (const target of ['spec', 'measure']) assert.equal((await post(target, body, { url: `${origin}/${'A'.repeat(32)}/` })).status, 404);
  assert.equal(file.writes, 0);
});

test('a view without a spec has none of this', async (t) => {
  const plain = await opened({});
  t.after(() => plain.close());
  assert.equal((await fetch(`${plain.url}spec`)).status, 404);
  for (const target of ['spec', 'measure']) assert.equal((await post(target, {}, { url: plain.url })).status, 404);
  assert.equal((await (await fetch(`${plain.url}session`)).json()).spec, null);
});

test('a wrong spec ends it before there is a page', async () => {
  for (const [text, pointer, message] of [
    ['{', '', /"shirt\.json" is not JSON/],
    ['{"paper":{"size":"A9"}}', '/paper/size', /spec\.paper\.size: expected/],
  ]) {
    file.bytes = Buffer.from(text);
    await assert.rejects(opened({ spec }), { code: 'E_SPEC', pointer, message });
  }
});
