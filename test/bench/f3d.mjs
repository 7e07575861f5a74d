// The T-shirt at 512 x 512 from the start of a process, by telar and by F3D, a viewer of files that draws them plainly: CPU and wall time, medians in turns.
// F3D 1.3 lights the model by one lamp, without an environment, shadows or more than one sample. It needs a display.
// node test/bench/f3d.mjs [RUNS]      once before: apt-get install f3d xvfb
import { once } from 'node:events';
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { median } from '../median.mjs';
import { cpuBelow, measured } from '../processes.mjs';
import { PLAIN_ENVIRONMENT, TELAR } from '../installed_command.mjs';

const RUNS = Number(process.argv[2] ?? 9);
const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const TSHIRT = path.join(ROOT, 'js/assets/tshirt.glb');

const folder = mkdtempSync(path.join(tmpdir(), 'telar-f3d-'));
const display = spawn('Xvfb', ['-displayfd', '1', '-screen', '0', '1280x1024x24'], { stdio: ['ignore', 'pipe', 'ignore'] });
const number = String((await once(display.stdout, 'data'))[0]).trim();

const telar = (...more) => [process.execPath, TELAR, 'thumbnail', TSHIRT, '-o', path.join(folder, 'telar.png'), '--size', '512', '--quiet', ...more];
const COMMANDS = {
  telar: telar(),
  'telar, quality draft': telar('--quality', 'draft'),
  F3D: ['f3d', TSHIRT, '--output', path.join(folder, 'f3d.png'), '--resolution', '512,512'],
};
const samples = Object.fromEntries(Object.keys(COMMANDS).map((name) => [name, []]));
// The first round fills caches.
for (let i = 0; i <= RUNS; ++i) {
  for (const [name, [command, ...args]] of Object.entries(COMMANDS)) {
    const run = () => spawnSync(command, args, { env: { ...PLAIN_ENVIRONMENT, DISPLAY: `:${number}` } });
    const sample = await measured(cpuBelow, async () => run());
    if (i > 0) samples[name].push(sample);
  }
}
display.kill();
if (!existsSync(path.join(folder, 'f3d.png'))) throw new Error('F3D wrote no picture');
rmSync(folder, { recursive: true });
for (const [name, list] of Object.entries(samples)) {
  const of = (key) => `${median(list.map((sample) => sample[key])).toFixed(0)} ms`;
  console.log(`${name}: CPU ${of('cpu')}, wall ${of('wall')}`);
}
