/** telar analyse: which term of one shading against another changes pictures of cloth most. */
export { analyse, analysisSteps } from './analyse.mjs';
export { strongestIn } from './ranking.mjs';
export { analysisPage, plotsOf } from './report.mjs';
export { figuresOf } from './figures.mjs';
export { percent, rankLines, ranksText, shortFigure, termLines } from './lines.mjs';
export { LIGHTS, lightsOf } from './lights.mjs';
export { FABRICS, fabricTargets, modelTargets, numbered, toldApart } from './targets.mjs';
export { inWords } from './words.mjs';
export { swapsBetween } from './swaps.mjs';
export { bestSwaps, closestRelease, rankedSwaps } from './releases.mjs';
export { dataUrls, picturesOf } from './pictures.mjs';
