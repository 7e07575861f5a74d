import { readFile, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { analyse, analysisSteps, fabricTargets, lightsOf, modelTargets, swapsBetween } from '../../analyse/index.mjs';
import * as api from '../../index.mjs';
import { upgradeMarkdown } from './analysis_page.mjs';

// npm run analysis, its second part: the end of js/docs/releases.md, one release of three.js against another.

const PAGE = new URL('../../docs/releases.md', import.meta.url);
/** The page from here on is written anew. */
const HEADING = '## three@187 against three@180\n';

const SHIRT = fileURLToPath(new URL('../../assets/tshirt.glb', import.meta.url));
const [from, to] = [180, 187].map((revision) => ({ base: 'three', revision }));
const plan = {
  names: { from: `three@${from.revision}`, to: `three@${to.revision}` },
  swaps: swapsBetween(from, to),
  targets: [...modelTargets([SHIRT]), ...fabricTargets(['leather', 'velvet'])],
  lights: lightsOf(['studio', 'sun']),
  shot: { size: { width: 256, height: 256 }, quality: 'standard' },
};

const renderer = await api.createRenderer();
let steps = 0;
const step = (name) => {
  steps += 1;
  if (steps % 50 === 0) console.log(`${steps} of ${analysisSteps(plan)}: ${name}`);
};
const analysis = await analyse(api, renderer, plan, { step });
await renderer.close();

const [before] = (await readFile(PAGE, 'utf8')).split(HEADING);
await writeFile(PAGE, `${before.trimEnd()}\n\n${HEADING}\n${upgradeMarkdown(analysis)}`);
console.log('js/docs/releases.md');
