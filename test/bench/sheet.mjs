// A sheet of the T-shirt with 8 views against its pictures alone: wall time in one run from one load, medians of 3; and peak memory, each in a process of its
// own.
// node test/bench/sheet.mjs      needs the dev build (npm test makes it)
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import '../js/api/support/real.mjs';
import { createRenderer } from '../../js/index.mjs';
import { createSheet } from '../../js/sheet/index.mjs';
import { layOut } from '../../js/sheet/sheet.mjs';
import { median } from '../median.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const RUNS = 3;

const named = ['front', 'back', 'left', 'right'];
/** 2 on the first page, 2 with call-outs, 4 of two colourways. */
const SPEC = {
  views: named.slice(0, 2).map((view) => ({ name: view, view })),
  callouts: named.slice(0, 2).map((view) => ({ view, node: 'neck_rib', text: `The neck from the ${view}` })),
  colourways: ['natural', 'indigo'].map((variant) => ({ name: variant, variant })),
};

const MODEL = path.join(root, 'js/assets/tshirt.glb');
const OPTIONS = { timeoutMs: null };

/** Peak of this process, MiB, after one sheet or its pictures alone. */
async function peak(what) {
  const renderer = await createRenderer();
  try {
    if (what === 'sheet') await createSheet(MODEL, SPEC, { renderer, ...OPTIONS });
    else {
      const { pictures, engine } = await layOut(MODEL, SPEC, { renderer, format: 'pdf', fonts: [], templates: {}, shot: {}, ...OPTIONS });
      await pictures.draw();
      engine.close();
    }
    return process.resourceUsage().maxRSS / 1024;
  } finally {
    await renderer.close();
  }
}

const peakOf = (what) => Number(execFileSync(process.execPath, [fileURLToPath(import.meta.url), what], { encoding: 'utf8' }));

async function times() {
  const renderer = await createRenderer();
  try {
    const model = await renderer.load(MODEL);
    await createSheet(model, SPEC, { renderer, ...OPTIONS });
    const runs = [];
    for (let i = 0; i < RUNS; ++i) runs.push((await createSheet(model, SPEC, { renderer, ...OPTIONS })).info);
    const of = (stage) => median(runs.map(({ milliseconds }) => milliseconds[stage]));
    console.log(
      `${runs[0].pictures} pictures ${of('pictures').toFixed(0)} ms, layout ${of('layout').toFixed(0)} ms, typesetting ${of('typeset').toFixed(0)} ms`,
    );
    return [of('total'), of('pictures')];
  } finally {
    await renderer.close();
  }
}

if (process.argv[2]) console.log(await peak(process.argv[2]));
else {
  const [total, pictures] = await times();
  console.log(`sheet ${total.toFixed(0)} ms, ${(total / pictures).toFixed(2)} times its pictures`);
  const [whole, alone] = ['sheet', 'pictures'].map(peakOf);
  console.log(`sheet ${whole.toFixed(0)} MiB at its peak, ${(whole / alone).toFixed(2)} times its pictures`);
  if (total > 2 * pictures || whole > 2 * alone) process.exitCode = 1;
}
