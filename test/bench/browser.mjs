// A picture by telar against the same by three.js in headless Chromium on the same Mesa: CPU time, wall time and memory, and what the
// first picture takes from the start of the process. The two draw in turns; medians. CPU time says what a server pays, whatever else runs.
// npm run bench -- browser      node test/bench/browser.mjs [RUNS]
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { createRenderer } from '../../js/index.mjs';
import { median } from '../median.mjs';
import { Browser } from '../parity/browser/chromium.mjs';

const RUNS = Number(process.argv[2] ?? 9);
const ASSETS = fileURLToPath(new URL('../../js/assets/', import.meta.url));
const CLI = fileURLToPath(new URL('../../js/cli/telar.mjs', import.meta.url));
const CASES = [
  { name: 'T-shirt, 512 x 512', file: 'tshirt.glb', side: 512 },
  { name: 'T-shirt, 256 x 256', file: 'tshirt.glb', side: 256 },
  { name: 'drape, 512 x 512', file: 'fabrics.glb', side: 512 },
];
const TICKS_A_SECOND = 100;

/** Fields of /proc/PID/stat from the state on, or undefined where it has ended. */
function statOf(pid) {
  try {
    return readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ').at(-1).split(' ');
  } catch {
    return undefined;
  }
}

/** Processes below this one. */
function descendants() {
  const parents = new Map(
    readdirSync('/proc')
      .filter((name) => /^\d+$/.test(name))
      .map((pid) => [pid, statOf(pid)?.[1]]),
  );
  const isBelow = (pid) => pid !== undefined && (parents.get(pid) === String(process.pid) || (pid !== '1' && isBelow(parents.get(pid))));
  return [...parents.keys()].filter(isBelow);
}

/** Milliseconds of CPU of the processes below this one that live, and of those that have ended. */
function cpuBelow() {
  const ticks = (fields, from) => Number(fields?.[from] ?? 0) + Number(fields?.[from + 1] ?? 0);
  return (
    ((descendants().reduce((sum, pid) => sum + ticks(statOf(pid), 11) + ticks(statOf(pid), 13), 0) + ticks(statOf(process.pid), 13)) * 1000) / TICKS_A_SECOND
  );
}

/** Mebibytes that processes have for themselves, with their shares of what is shared. */
const pssOf = (pids) => pids.reduce((sum, pid) => sum + Number(/^Pss:\s+(\d+)/m.exec(readFileSync(`/proc/${pid}/smaps_rollup`, 'utf8'))[1]), 0) / 1024;

/** {cpu, wall} in milliseconds. `cpuNow`: of whom. */
async function measured(cpuNow, job) {
  const [cpu, wall] = [cpuNow(), performance.now()];
  await job();
  return { cpu: cpuNow() - cpu, wall: performance.now() - wall };
}
const ownCpu = () => Object.values(process.cpuUsage()).reduce((sum, us) => sum + us, 0) / 1000;

function tell(name, telar, browser) {
  const of = (samples, key) => median(samples.map((sample) => sample[key]));
  const parts = ['cpu', 'wall'].map(
    (key) => `${key} ${of(telar, key).toFixed(0)} ms and ${of(browser, key).toFixed(0)} ms, ratio ${(of(browser, key) / of(telar, key)).toFixed(1)}`,
  );
  console.log(`${name.padEnd(26)} telar and Chromium: ${parts.join('; ')}`);
}

const environment = readFileSync(path.join(ASSETS, 'studio.hdr'));
const renderer = await createRenderer();
const browser = await Browser.start();
for (const { name, file, side } of CASES) {
  const model = path.join(ASSETS, file);
  const shot = { size: { width: side, height: side } };
  const { info } = await renderer.render(model, shot);
  // To the browser's favour: its pixels are not encoded, and it keeps its programs.
  const byBrowser = () => browser.draw({ shot: info.shot, model, environment, keepPrograms: true });
  await byBrowser();
  const [telar, theirs] = [[], []];
  for (let i = 0; i < RUNS; ++i) {
    telar.push(await measured(ownCpu, () => renderer.render(model, shot)));
    theirs.push(await measured(cpuBelow, byBrowser));
  }
  tell(name, telar, theirs);
}
console.log(
  `${'memory'.padEnd(26)} telar and Chromium: ${pssOf([process.pid]).toFixed(0)} MiB (this process, the benchmark included) and ${pssOf(descendants()).toFixed(0)} MiB (PSS)`,
);
await Promise.all([renderer.close(), browser.close()]);

const folder = mkdtempSync(path.join(tmpdir(), 'telar-bench-'));
const [telar, theirs] = [[], []];
for (let i = 0; i < Math.ceil(RUNS / 3); ++i) {
  const model = path.join(ASSETS, 'tshirt.glb');
  telar.push(
    await measured(cpuBelow, () => spawnSync(process.execPath, [CLI, 'thumbnail', model, '-o', path.join(folder, 'a.png'), '--size', '512', '--quiet'])),
  );
  const { shot } = JSON.parse(
    spawnSync(process.execPath, [CLI, 'thumbnail', model, '-o', path.join(folder, 'a.png'), '--size', '512', '--json'], { encoding: 'utf8' }).stdout,
  ).images[0].info;
  let fresh;
  theirs.push(
    await measured(cpuBelow, async () => {
      fresh = await Browser.start();
      await fresh.draw({ shot, model, environment });
    }),
  );
  await fresh.close();
}
tell('from the start of a process', telar, theirs);
rmSync(folder, { recursive: true });
