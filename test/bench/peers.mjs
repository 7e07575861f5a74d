// A picture by telar against the same by three.js in headless Chromium on the same Mesa: CPU time, wall time and memory, and what the
// first picture takes from the start of the process. The two draw in turns; medians. CPU time says what a server pays, whatever else runs.
// That they draw the same is checked first, by the bars of the parity gate.
// npm run bench -- peers      node test/bench/peers.mjs [--runs N] [--more] [--swiftshader] [--write] [--json FILE]
// --more: draft, views and models in turn alone; --swiftshader: the pictures alone, against Chromium on its own rasteriser;
// --write: the table of the README; --json: what was measured, for npm run scale
import { fork, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { compareImages, judge } from '../../js/compare/index.mjs';
import { createRenderer } from '../../js/index.mjs';
import { createPool } from '../../js/pool/index.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { median } from '../median.mjs';
import { cpuBelow, descendants, measured, pssOf } from '../processes.mjs';
import { Browser } from '../parity/browser/chromium.mjs';
import { difference } from '../parity/metrics.mjs';
import { PLAIN_ENVIRONMENT, TELAR } from '../installed_command.mjs';
import { cases } from './peer_models.mjs';

const { values } = parseArgs({
  options: {
    runs: { type: 'string', default: '9' },
    more: { type: 'boolean' },
    swiftshader: { type: 'boolean' },
    write: { type: 'boolean' },
    json: { type: 'string' },
  },
});
const RUNS = Number(values.runs);
const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const ASSETS = path.join(ROOT, 'js/assets');
const TSHIRT = path.join(ASSETS, 'tshirt.glb');
const CASES = await cases();

/** Resolves when nothing below works any more: a browser goes on for a while after a picture, and would slow down the other's. */
async function settled() {
  for (let before = -1, now = cpuBelow(), i = 0; now > before && i < 20; ++i) {
    before = now;
    await sleep(100);
    now = cpuBelow();
  }
}

const rows = [];
/** For --json: medians, in milliseconds. @type {{name: string, telar: {cpu: number, wall: number}, browser: {cpu: number, wall: number}}[]} */
const told = [];

/** A row of the table. @param {{cpu: number, wall: number}[]} telar @param {{cpu: number, wall: number}[]} browser milliseconds */
function tell(name, telar, browser) {
  const of = (samples, key) => median(samples.map((sample) => sample[key]));
  const ratio = (key) => (of(browser, key) / of(telar, key)).toFixed(1);
  const cpu = (samples) => `${of(samples, 'cpu').toFixed(0)} ms`;
  rows.push([name, cpu(telar), cpu(browser), ratio('cpu'), ratio('wall')]);
  const medians = (samples) => ({ cpu: of(samples, 'cpu'), wall: of(samples, 'wall') });
  told.push({ name, telar: medians(telar), browser: medians(browser) });
  console.log(rows.at(-1).join(' | '));
}

const straight = (rgba) => rgba.map((value, i) => (i % 4 === 3 ? value : Math.min(255, Math.round((value * 255) / Math.max(rgba[i - (i % 4) + 3], 1)))));
const premultiplied = (rgba) => rgba.map((value, i) => (i % 4 === 3 ? value : Math.round((value * rgba[i - (i % 4) + 3]) / 255)));

/** @throws {Error} where the pictures are not the same by the bars of the parity gate, or by those for another GL */
async function checkSame(name, { model, shot }, expected) {
  const { data, info } = await renderer.render(model, { ...shot, output: { format: 'raw' } });
  const { image, mask } = expected;
  const size = { width: info.width, height: info.height };
  const verdict = values.swiftshader
    ? judge(compareImages({ ...size, data: straight(image) }, { ...size, data }), 'other-gl')
    : difference({ expected: image, actual: premultiplied(data), mask, ...size, background: false }).verdict;
  if (!verdict.pass) throw new Error(`${name}: the two do not draw the same: ${JSON.stringify(verdict.checks.filter(({ pass }) => !pass))}`);
}

const folder = mkdtempSync(path.join(tmpdir(), 'telar-bench-'));
const environment = readFileSync(path.join(ASSETS, 'studio.hdr'));
const renderer = await createRenderer();
const drawer = fork(new URL('peers_telar.mjs', import.meta.url));
await once(drawer, 'message');
/** Work of the process that only draws: peers_telar.mjs. */
async function telarDoes(asked) {
  drawer.send(asked);
  return (await once(drawer, 'message'))[0];
}
const byTelar = (model, shot) => telarDoes({ model, shot });

/** Both in turns. @returns {Promise<{cpu: number, wall: number}[][]>} */
async function inTurns(byUs, byThem, runs = RUNS) {
  const [telar, theirs] = [[], []];
  for (let i = 0; i < runs; ++i) {
    await settled();
    telar.push(await byUs());
    await settled();
    theirs.push(await measured(cpuBelow, byThem));
  }
  return [telar, theirs];
}

const fileOf = (name, model) => {
  const file = path.join(folder, `${name}.glb`);
  writeFileSync(file, typeof model === 'string' ? readFileSync(model) : model);
  return file;
};

const browser = await Browser.start({ isMeasured: true, rasterizer: values.swiftshader ? 'swiftshader' : 'mesa' });
for (const { name, model, side = 512 } of values.more ? [] : CASES) {
  const shot = { size: { width: side, height: side } };
  const file = fileOf('model', model);
  await byTelar(file, shot);
  const { info } = await renderer.render(model, shot);
  // To the browser's favour: its pixels are not encoded, and it keeps its programs.
  const byBrowser = () => browser.draw({ shot: info.shot, model, environment, keepPrograms: true });
  await checkSame(name, { model, shot }, await byBrowser());
  tell(name, ...(await inTurns(() => byTelar(file, shot), byBrowser)));
}
const memory = [pssOf([drawer.pid]), pssOf(descendants().filter((pid) => pid !== String(drawer.pid)))];

// What a trade and many pictures make of it: quality draft against the browser's picture, four views of one model, six models in turn by two pages.
if (!values.swiftshader) {
  const shot = { size: { width: 512, height: 512 }, quality: 'draft' };
  const pixels = async (quality) => (await renderer.render(TSHIRT, { ...shot, quality, output: { format: 'raw' } })).data;
  const [standard, draft] = [await pixels('standard'), await pixels('draft')];
  const { flip } = compareImages({ ...shot.size, data: standard }, { ...shot.size, data: draft }).object;
  const { info } = await renderer.render(TSHIRT, { size: shot.size });
  const byBrowser = () => browser.draw({ shot: info.shot, model: TSHIRT, environment, keepPrograms: true });
  tell(`the T-shirt in quality draft, FLIP ${flip.mean.toFixed(3)} against standard`, ...(await inTurns(() => byTelar(TSHIRT, shot), byBrowser)));

  const views = ['front', 'back', 'left', 'right'].map((view) => ({ size: shot.size, camera: { view } }));
  const resolved = (await renderer.renderAll(TSHIRT, views)).map((image) => image.info.shot);
  const four = await inTurns(
    () => telarDoes({ work: 'views', model: TSHIRT, shots: views }),
    () => browser.sequence({ shots: resolved, model: TSHIRT, environment, keepPrograms: true }),
  );
  tell('four views of it', ...four);
  const [one] = await inTurns(
    () => byTelar(TSHIRT, views[0]),
    async () => {},
  );
  const cpuOf = (samples) => median(samples.map(({ cpu }) => cpu));
  console.log(`four views of it cost ${(cpuOf(four[0]) / cpuOf(one)).toFixed(2)} of one`);

  const models = [...CASES.filter(({ side = 512 }) => side === 512).map(({ model }) => model), await MODELS.cloth(), await MODELS['physical-everything']()];
  const files = models.map((model, i) => fileOf(`turn-${i}`, model));
  const plain = { size: shot.size };
  const turn = [];
  for (const model of files) turn.push({ model, shot: (await renderer.render(model, plain)).info.shot, environment, keepPrograms: true });
  const pages = [browser, await browser.another()];
  const pool = await createPool({ size: pages.length });
  const takenBy = async (drawers, jobs, draw) => {
    const left = [...jobs];
    const take = async (drawer) => {
      for (let job = left.shift(); job; job = left.shift()) await draw(drawer, job);
    };
    await Promise.all(drawers.map(take));
  };
  const byPages = () => takenBy(pages, turn, (page, job) => page.draw(job));
  // One more than there are workers: while a picture goes back, its worker has the next one.
  const byPool = () => takenBy([...pages, undefined], files, (_, file) => pool.render(file, plain));
  // Each worker is to have the programs of each model.
  for (let i = 0; i < 3; ++i) await byPool();
  await byPages();
  tell(
    `${files.length} models in turn, all cores; a pool of two workers, Chromium with two pages`,
    ...(await inTurns(() => measured(cpuBelow, byPool), byPages)),
  );
  await Promise.all([pool.close(), pages[1].close()]);
}
drawer.disconnect();
await Promise.all([renderer.close(), browser.close()]);
if (values.more || values.swiftshader) {
  rmSync(folder, { recursive: true });
  process.exit();
}

const thumbnail = (...args) => {
  const command = [TELAR, 'thumbnail', TSHIRT, '-o', path.join(folder, 'a.png'), '--size', '512', ...args];
  return spawnSync(process.execPath, command, { env: PLAIN_ENVIRONMENT, encoding: 'utf8' });
};
const [telar, theirs] = [[], []];
for (let i = 0; i < RUNS; ++i) {
  await settled();
  telar.push(await measured(cpuBelow, () => thumbnail('--quiet')));
  const { shot } = JSON.parse(thumbnail('--json').stdout).images[0].info;
  let fresh;
  theirs.push(
    await measured(cpuBelow, async () => {
      fresh = await Browser.start({ isMeasured: true });
      await fresh.draw({ shot, model: TSHIRT, environment });
    }),
  );
  await fresh.close();
}
tell('the T-shirt, from the start of the process', telar, theirs);
rmSync(folder, { recursive: true });
rows.push(['memory of all processes, the five pictures drawn', ...memory.map((mib) => `${mib.toFixed(0)} MiB`), (memory[1] / memory[0]).toFixed(1), '']);
console.log(rows.at(-1).join(' | '));

if (values.json) writeFileSync(values.json, JSON.stringify({ pictures: told, mebibytes: { telar: memory[0], browser: memory[1] } }));
if (values.write) {
  const head = ['a picture of 512 x 512, no GPU: CPU time from file to pixels', 'telar', 'headless Chromium', 'ratio', 'ratio of wall time'];
  const table = [head, head.map(() => '---'), ...rows].map((row) => `| ${row.join(' | ')} |`).join('\n');
  const file = path.join(ROOT, 'README.md');
  const text = readFileSync(file, 'utf8');
  const between = /(<!-- peers -->\n)[\s\S]*?(\n<!-- end -->)/;
  if (!between.test(text)) throw new Error('README.md has no place for the table: <!-- peers --> and <!-- end -->');
  writeFileSync(
    file,
    text.replace(between, (_, before, after) => `${before}${table}${after}`),
  );
}
