// How long the technical flats of the examples of sheets take, from a model that is loaded to SVG: medians of 5.
// node test/bench/flat.mjs      needs the dev build (npm test makes it)
import { readFile } from 'node:fs/promises';
import '../js/api/support/real.mjs';
import { createRenderer } from '../../js/index.mjs';
import { jacket, skirt } from '../fixtures/garments/index.mjs';
import { median } from '../median.mjs';

const RUNS = 5;
const MODELS = { tshirt: () => readFile(new URL('../../js/assets/tshirt.glb', import.meta.url)), skirt, jacket };
const shotOf = (view) => ({ size: { width: 1200, height: 1200 }, camera: { view, projection: 'orthographic' } });

const renderer = await createRenderer();
try {
  for (const [name, make] of Object.entries(MODELS)) {
    const model = await renderer.load(await make());
    for (const view of ['front', 'back', 'right', 'left']) {
      const times = [];
      let flat;
      for (let i = 0; i < RUNS; ++i) {
        const start = performance.now();
        flat = await model.flat(shotOf(view));
        times.push(performance.now() - start);
      }
      console.log(`${name} ${view}: ${median(times).toFixed(0)} ms, ${flat.triangles} triangles, ${flat.strokes.length} lines`);
    }
  }
} finally {
  await renderer.close();
}
