/** telar bench trade: time of every quality against its error. */
export { bench, benchSteps } from './bench.mjs';
export { csvOf, presetsAboveFront, presetsByClass } from './figures.mjs';
export { KNOB_SETTINGS, knobsTable, together } from './knobs.mjs';
export { TRUTH } from './measure.mjs';
export { overallPoints, tablesOf, tradePage } from './page.mjs';
export { tradePlot } from './plots.mjs';
export { BENCH_LIGHTS, benchLights, CLOTHS, clothModels, fileModels, scenesOf } from './scenes.mjs';
