// A sheet of the T-shirt with 8 views against its pictures alone, which are drawn in the same run from the same load: wall time, medians of 3.
// node test/bench/sheet.mjs      needs the dev build (npm test makes it)
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import '../js/api/support/real.mjs';
import { createRenderer } from '../../js/index.mjs';
import { createSheet } from '../../js/sheet/index.mjs';
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

const renderer = await createRenderer();
try {
  const model = await renderer.load(path.join(root, 'js/assets/tshirt.glb'));
  await createSheet(model, SPEC, { renderer, timeoutMs: null });
  const runs = [];
  for (let i = 0; i < RUNS; ++i) runs.push((await createSheet(model, SPEC, { renderer, timeoutMs: null })).info);
  const of = (stage) => median(runs.map(({ milliseconds }) => milliseconds[stage]));
  const [total, pictures] = [of('total'), of('pictures')];
  console.log(`${runs[0].pictures} pictures ${pictures.toFixed(0)} ms, layout ${of('layout').toFixed(0)} ms, typesetting ${of('typeset').toFixed(0)} ms`);
  console.log(`sheet ${total.toFixed(0)} ms, ${(total / pictures).toFixed(2)} times its pictures`);
  if (total > 2 * pictures) process.exitCode = 1;
} finally {
  await renderer.close();
}
