import { mean } from '../../js/compare/statistics.mjs';
import { row } from '../../js/build/docs/tables.mjs';
import { createRenderer } from '../../js/index.mjs';
import { ENVIRONMENTS, HELD_OUT_FABRICS, TUNED_FABRICS } from '../fixtures/index.mjs';
import { errorsOf } from './measure.mjs';

const QUALITIES = ['standard', 'medium'];

/** What quality standard is wanted to have on the cloths that it was made with, as FLIP; cloths that it does not know may have as much again by this factor. */
const WANTED = 0.05;
const LEEWAY = 1.3;

/**
 * Cloths that nothing was tuned on, in the windows of the others; beside them those that were once held out, which do not count.
 * @param {{paths: number, skies: string[], size: number, camera: object, cloths: string[]}} window cloths: none = all
 * @returns {Promise<number>} exit code: 0 where the mean of all is within the bar
 */
export async function measureHeldOut({ paths, skies, size, camera, cloths }) {
  const renderer = await createRenderer({ cacheDirectory: null, timeoutMs: null });
  const lines = [];
  const flips = QUALITIES.map(() => []);
  const all = Object.entries({ ...HELD_OUT_FABRICS, ...TUNED_FABRICS });
  for (const [name, make] of all.filter(([each]) => cloths.length === 0 || cloths.includes(each))) {
    const cells = [];
    for (const sky of skies) {
      const shot = { size: { width: size, height: size }, camera, environment: ENVIRONMENTS[sky](), shading: 'fabric' };
      const errors = await errorsOf(renderer, await make(), shot, QUALITIES, paths);
      if (HELD_OUT_FABRICS[name]) errors.forEach(({ flip }, i) => flips[i].push(flip));
      cells.push(errors.map(({ flip }) => flip.toFixed(3)).join(', '));
      process.stderr.write(`${name} ${sky} ${cells.at(-1)}\n`);
    }
    lines.push(row([name, ...cells]));
  }
  await renderer.close();
  const means = flips.map((each) => mean(each).toFixed(4));
  process.stdout.write(
    `| cloth | ${skies.join(' | ')} |\n|---|${'---|'.repeat(skies.length)}\n${lines.join('\n')}\n\nmean of ${QUALITIES.join(', ')}: ${means.join(', ')}\n`,
  );
  return mean(flips[0]) <= LEEWAY * WANTED ? 0 : 1;
}
