// Call-outs and details that name a part stand where the view shows it: in the midst of what is seen of it, off its edges.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { middlePixel } from '../../../js/sheet/seen_part.mjs';
import { layOut } from '../../../js/sheet/sheet.mjs';
import { CHEAP } from './square.mjs';

const pixelsOf = (rows) => ({ seen: rows.flatMap((row) => [...row].map((c) => c === '#')), size: { width: rows[0].length, height: rows.length } });
const middleOf = (rows, most) => {
  const { seen, size } = pixelsOf(rows);
  return middlePixel(seen, size, most);
};

test('the pixel is the middle, or the nearest one that is as far off the edge', () => {
  assert.deepEqual(middleOf(['.....', '.###.', '.###.', '.###.', '.....'], 9), [2, 2]);
  // A hole in the middle: off it too.
  const row = (isHole) => '#'.repeat(6) + (isHole ? '...' : '###') + '#'.repeat(6);
  const ring = Array.from({ length: 15 }, (_, y) => row(y >= 7 && y < 10));
  assert.deepEqual(
    [1, 2, 9].map((most) => middleOf(ring, most)),
    [
      [7, 6],
      [7, 5],
      [7, 4],
    ],
  );
  // A line has no pixel off its edge.
  assert.deepEqual(middleOf(['.......', '#######', '.......'], 9), [3, 1]);
  // The edge of the picture is one.
  assert.deepEqual(middleOf(['######', '######', '######'], 9).slice(1), [1]);
  assert.equal(middleOf(['...', '...'], 9), undefined);
});

let renderer;
let model;
before(async () => {
  renderer = await createRenderer();
  const builder = new GlbBuilder();
  const quarter = Math.SQRT1_2;
  const add = (name, size, how) => builder.add(plane(...size), builder.material({ name, doubleSided: true }), { name, ...how });
  add('front', [0.3, 0.4], {});
  add('pocket', [0.1, 0.1], { translation: [0, 0, 0.01] });
  add('side', [0.2, 0.4], { translation: [0.15, 0, -0.1], rotation: [0, quarter, 0, quarter] });
  add('lining', [0.1, 0.1], { translation: [0.05, 0.1, -0.01] });
  model = await renderer.load(await builder.bytes());
});
after(() => renderer.close());

const VIEWS = [
  { name: 'front' },
  { name: 'turned', azimuth: 40, elevation: 15, scale: '1:3' },
  { name: 'apart', azimuth: 40, elevation: 0, explode: 0.1, style: 'flat' },
];

/** The pages of a spec, without pictures. */
async function laidOut(spec) {
  const laid = await layOut(model, { views: VIEWS, ...spec }, { renderer, shot: CHEAP, fonts: [], templates: {} });
  laid.engine.close();
  return laid;
}

/** Where call-outs of each part end in a view: metres in the picture from its middle. */
async function sitesIn(view, parts) {
  const { sections, layout } = await laidOut({ callouts: parts.map((part) => ({ view, text: Object.values(part)[0], ...part })) });
  const { figure } = sections.find(({ title }) => title === layout.words('callouts'));
  const [picture] = figure.pictures;
  const index = VIEWS.findIndex(({ name }) => name === view);
  const box = { width: picture.width, height: picture.height };
  const ratio = Number(/1:([\d.]+)/.exec(figure.captions[0].note)[1]);
  const site = (i) => {
    const { y } = figure.labels.find(({ number }) => number === String(i + 1));
    const line = figure.lines.find(({ points }) => Math.abs(points[0][1] - y) < 3);
    const [px, py] = line.points.at(-1);
    return [((px - picture.x - box.width / 2) * ratio) / 1000, ((picture.y + box.height / 2 - py) * ratio) / 1000];
  };
  return { sites: parts.map((_, i) => site(i)), ratio, extent: layout.shown[index].extent };
}

const near = (actual, expected, what, most = 0.0025) =>
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < most, `${what}: ${actual} is not ${expected}`));

test('what a pocket covers is not pointed at: the line ends beside it', async () => {
  const { sites, ratio } = await sitesIn('front', [{ material: 'front' }, { node: 'pocket' }]);
  const [[x, y], pocket] = sites;
  near(pocket, [0, 0], 'pocket');
  const off = Math.max(Math.abs(x), Math.abs(y)) - 0.05;
  // Three millimetres of paper.
  assert.ok(Math.abs(off - (3 * ratio) / 1000) < 0.0025, `${[x, y]}: ${off} off the pocket`);
});

test('a part that is seen at a slant is pointed at in its middle', async () => {
  for (const view of ['turned', 'apart']) {
    const { sites, extent } = await sitesIn(view, [{ node: 'side' }]);
    const { basis, centre } = extent;
    const middle = view === 'turned' ? [0.15, 0, -0.1] : [0.25, 0, -0.1];
    const along = (axis) => axis.reduce((sum, value, i) => sum + value * (middle[i] - centre[i]), 0);
    near(sites[0], [along(basis.right), along(basis.up)], view);
  }
});

test('all that a view shows is a part too', async () => {
  const ghost = ['pocket', 'side', 'lining'].map((node) => ({ node, opacity: 0 }));
  const { sections } = await laidOut({ views: [{ name: 'alone', ghost }], callouts: [{ node: 'front', text: 'a' }] });
  const { pictures, lines } = sections[1].figure;
  near(lines[0].points.at(-1), [pictures[0].x + pictures[0].width / 2, pictures[0].y + pictures[0].height / 2], 'front', 0.5);
});

test('what is hidden is pointed at where it is', async () => {
  const { sites, extent } = await sitesIn('front', [{ node: 'lining' }]);
  near(sites[0], [0.05 - extent.centre[0], 0.1 - extent.centre[1]], 'lining');
});
