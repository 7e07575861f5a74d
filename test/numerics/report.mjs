// node test/numerics/report.mjs [--only NAME] [--quick]: measures every figure at its full count and writes js/docs/numerics.md.
// With --only it measures the checks whose name holds NAME, and prints the tables in place of writing them.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import readline from 'node:readline';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { createRenderer } from '../../js/index.mjs';
import { IMAGE_CHECKS } from './image_checks.mjs';
import { numericsPage } from './report_page.mjs';

const PAGE = new URL('../../js/docs/numerics.md', import.meta.url);
const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const BUILD = process.env.TELAR_BUILD_DIR ?? path.join(ROOT, 'out/dev');

const said = ({ name, seconds, figures }) => {
  const off = figures.filter(({ holds }) => !holds).length;
  process.stderr.write(`${name}: ${figures.length} figures in ${seconds.toFixed(0)} s${off ? `, ${off} outside of their bars` : ''}\n`);
};

/** The checks of telar_numerics, one JSON object a line. */
async function programChecks({ only, quick }) {
  const args = [...(quick ? [] : ['--full']), ...(only ? ['--only', only] : [])];
  const child = spawn(path.join(BUILD, 'bin/telar_numerics'), args, { stdio: ['ignore', 'pipe', 'inherit'] });
  const closed = once(child, 'close');
  const checks = [];
  for await (const line of readline.createInterface({ input: child.stdout })) {
    checks.push(JSON.parse(line));
    said(checks.at(-1));
  }
  const [code, signal] = await closed;
  // 1: a figure is outside of its bar, which the tables show.
  if (signal || code > 1) throw new Error(`telar_numerics ended with ${signal ?? code}`);
  return checks;
}

async function imageChecks({ only }) {
  const checks = [];
  const renderer = await createRenderer({ backend: 'egl-surfaceless' });
  try {
    for (const { topic, name, run } of IMAGE_CHECKS.filter((check) => !only || check.name.includes(only))) {
      const started = performance.now();
      const figures = await run(renderer);
      checks.push({ topic, name, figures, seconds: (performance.now() - started) / 1000 });
      said(checks.at(-1));
    }
    return checks;
  } finally {
    await renderer.close();
  }
}

const { values: options } = parseArgs({ options: { only: { type: 'string' }, quick: { type: 'boolean', default: false } } });
const checks = [...(await programChecks(options)), ...(await imageChecks(options))];
const page = numericsPage(checks);
if (options.only || options.quick) process.stdout.write(page);
else writeFileSync(PAGE, page);
process.exitCode = checks.some(({ figures }) => figures.some(({ holds }) => !holds)) ? 1 : 0;
