import { heading, row } from '../../js/build/docs/tables.mjs';
import { HELD } from '../../js/predict/fit.mjs';
import { PRESET_NAMES, SETTINGS } from '../../js/predict/settings.mjs';
import { presetsByClass, tablesOf } from '../../js/trade/index.mjs';
import { EXACT_LOOK } from './judge.mjs';

/** js/docs/trade.md: how to use goals and the bench, and what was measured; every figure is from the run. */

const table = ({ head, lines }) => [...heading(head), ...lines.map(row)].join('\n');
const seconds = (ms) => `${ms / 1000} s`;
const percent = (share) => (share === undefined ? '-' : `${(100 * share).toFixed(0)} %`);

/** How many pictures of a setting have a time that was not measured whole. */
const scaledOf = (rows, name) => rows.filter(({ setting, timed }) => setting === name && timed === 'window').length;

/** Presets that are not where they should be, by class of scenes. */
function aboveSection(rows) {
  const above = presetsByClass(rows).filter(({ within, scenes }) => within < scenes / 2);
  if (above.length === 0) return 'In no class of scenes does a preset lie above it in more than half of them.';
  const lines = above.map(({ preset, group, times, within, scenes, better }) => [preset, group, times.toFixed(2), `${within} of ${scenes}`, better]);
  const head = ['preset', 'class', 'time over the front, median', 'scenes within 10 %', 'what most often is better'];
  return `Where a preset lies above it in more than half of the scenes of a class:\n\n${table({ head, lines })}`;
}

/**
 * @param {object} result
 * @param {import('../../js/trade/measure.mjs').Row[]} result.rows
 * @param {import('../../js/predict/choose.mjs').TradeTable} result.table
 * @param {ReturnType<typeof import('./judge.mjs').judge>} result.verdict
 * @param {ReturnType<typeof import('./judge.mjs').judge>} result.byClass without a look at a window
 * @param {ReturnType<typeof import('./judge.mjs').judge>} result.knowing with answers of knowingAnswers()
 * @param {string} result.knobs of knobs.mjs
 * @param {string} result.command, result.machine
 * @param {number} result.window pixels
 * @param {object} result.truth quality
 * @param {(by: 'raster' | 'tracer', size: {width: number}) => number} result.capOf CPU milliseconds above which a window is drawn alone
 * @param {{fit: number, heldOut: number}} result.counts scenes
 */
export function docsPage({ rows, table: predicted, verdict, byClass, knowing, knobs, command, machine, window, truth, capOf, counts }) {
  const { overall, presets } = tablesOf(rows);
  return `# Time and error

Every quality is a trade of time for accuracy. What each takes and how far it is off can be measured, and a shot can ask for an error or a time in place of settings.

## A goal in place of settings

\`\`\`sh
telar thumbnail shirt.glb -o shirt.png --shading fabric --set 'quality={"maxError":0.02}'
telar thumbnail shirt.glb -o shirt.png --shading fabric --set 'quality={"budgetMs":500}'
\`\`\`

| key | meaning |
|---|---|
| \`maxError\` | the cheapest settings that are predicted to hold this mean FLIP over the model's pixels, against the path tracer with light that arrives directly |
| \`budgetMs\` | the most accurate settings that are predicted to draw a loaded model within so many milliseconds of CPU, all threads together, on this machine; where they take longer, they are ended |

\`info.goal\` tells the settings that were chosen, the predicted error and time and what they are based on; \`info.quality\` and \`info.shot\` have the settings themselves, so that
the same picture can be asked for again. Where nothing is predicted to hold the goal, the picture has the most accurate or the fastest settings, \`info.goal.holds\` is false and
the warning \`W_QUALITY\` says so.

Where a class is sure only of settings that take 300 ms or more, the renderer looks at the picture first: a window of 24 x 24 pixels on the model is drawn by path tracing and by the cheaper
settings, one after the other, until one holds there (some 100 ms of CPU; \`info.goal.basis\` says so). Hosts without Embree, models that the tracer shows otherwise, goals below 0.025, and \`inspect()\`,
which draws nothing, go by the class alone. Small pictures gain little by it: the look takes as long as they do. Who draws one model often finds its cheapest settings by \`telar bench trade\`.

\`maxError\` goes by the scene alone: the same shot of the same model has the same settings on each machine that has Embree and the same GL. \`budgetMs\` goes by the speed of the
machine too. Two small pictures tell it, once; they are kept in telar's cache folder, and \`telar doctor\` names them. Keys of pictures (\`info.key\`, \`pictureKey()\`) tell the
goal and not the settings: hosts that share them should have one speed, or ask by \`maxError\`. \`inspect()\` has no machine to draw on and predicts times of the one below.
The time is that of drawing. Loading a model, compiling its programs and preparing a new environment come on top, once each.

What is predicted of a scene is what was measured of others of its class: shading, kind of surface (cut out, facets, stretched highlights, napped, relief or smooth: the hardest of the\nscene), where its light comes from, and whether a lamp casts shadows, which the raster has wrong by far more than the rest. Errors are
upper bounds: of a class of n scenes the k-th smallest value, k = ${HELD} (n + 1) rounded up (conformal prediction: Vovk, Gammerman & Shafer 2005), and where there are too few the largest
with a margin; what a window shows is multiplied by such a bound of its own. A class of fewer than 5 scenes gives way to the wider one (without or with holes or glitter, the shading, all), for times
also one whose scenes are all of one size. Times are linear in triangles and covered pixels, with the factor that 9 of 10 pictures stay below.

## Where a goal ends a picture

A prediction is of a class of scenes, and most scenes are easier than the bound of their class. So a picture that is drawn in passes (more than 4 samples) or by paths stops before its
last sample once its goal is reached: \`info.ended\` tells the samples.

- \`budgetMs\` ends it when this process has spent so much CPU time on it, all threads together (of the raster, from the shadows on: programs, environments and the
  model's own uploads of a first picture come on top, as above). So settings are taken that are likely to fit, where those of one pass have to fit by the time that 9 of 10 do not
  pass. What else the process does meanwhile counts too: a pool has a process for each picture. The key of a picture that was ended is not \`pictureKey()\`'s.
- \`maxError\` ends it at a doubling of samples, 16 and on (32 where it may take 64, 256 where it may take 1024 and is denoised), where its own noise is small enough: no clock has a say, and the same shot ends at the same sample on
  each machine. The noise is the standard error of a pixel as the two halves of its samples tell it (that by which pixels of \`high\` settle), mean over the pixels that vary. It may make FLIP
  no more than the goal leaves: all of it for the tracer, which errs by noise alone; for the raster what is left beside the error of its most accurate settings in that class. Its key is that of the goal, which is
  not that of its settings. Where the environment is the background its noise would hide the model's, and the picture is drawn to its end.

FLIP maps a difference of colour to its power 0.7, so FLIP = k (standard error)^0.7 was looked at: five models and cloths of 40 x 40 at 16, 32, 64 and 128 paths, standard errors of 1.1 to 6.5, against
2048 paths. k lies between 0.013 and 0.0183, the truth's own noise included; 0.019 is gone by.

| picture, \`fabric\` in the studio | goal | settings | ended with | FLIP | FLIP of all samples |
| --- | --- | --- | --- | --- | --- |
| leather drape, 40 x 40 | 0.019 | tracer noise 1 | 256 of 1024 paths | 0.0147 | 0.0141 |
| | 0.02 | tracer noise 1.4 | 256 of 512 | 0.0169 | 0.0168 |
| cloth, 24 x 24 | 0.024 | tracer noise 2 | 128 of 256 | 0.0238 | 0.0241 |
| | 0.032 | tracer noise 2.8 | 64 of 128 | 0.0298 | 0.0274 |
| sequins, 24 x 24 | 0.06 | tracer noise 2 | 64 of 2048 | 0.0430 | 0.0231 |

The last paths are few, as most pixels have settled by then: CPU time is a tenth to a half less where the picture ends at 16 or 32 paths, and about the same beyond.

\`info.goal.reached\` tells what it came to: \`{cpuMs}\` of every \`budgetMs\`; of \`maxError\` where it is asked for (\`render(model, shot, {reached: true})\`, \`telar thumbnail --reached --json\`) \`{flip, pixels}\`: the
window of the look above, drawn by the same settings with no more samples than the picture has, against path tracing with a standard error of 2/255 at most.

## The picture so far

A picture of more than 4 samples, or by the path tracer, can be looked at while it is drawn, and ended when it is good enough:

\`\`\`js
const enough = new AbortController();
const onPreview = ({ data, width, height, bitDepth, samples }) => {
  if (samples >= 64) enough.abort();
};
const { data, info } = await renderer.render('shirt.glb', { quality: 'reference' }, { onPreview, enough: enough.signal });
console.log(info.ended);
\`\`\`

It is handed over at each doubling of the samples; one that the next overtakes is left out. Nobody who does not ask pays for it, and the finished bytes are the same. A pool
has previews too.

Where the signal \`enough\` fires, the picture is returned as it is, encoded as any other: the raster ends the pass that it draws, the tracer drops the round that it is in.
\`info.ended\` tells the samples, and \`info.key\` is not that of the finished picture. \`enough: AbortSignal.timeout(2000)\` is the best picture of 2 seconds. An abort of \`signal\`
rejects, as everywhere. A pool has no \`enough\`. \`telar view\` shows pictures of many samples as they grow.

## Measuring

\`\`\`sh
telar bench trade -o report                                          # the bundled drape in eight cloths, three lights, three sizes
telar bench trade shirt.glb --environments studio,church.hdr --sizes 256 -o report
telar bench trade shirt.glb --knobs -o report                         # each number alone, from "standard"
telar bench trade shirt.glb --setting 'fine={"samples":64,"environmentSamples":1024}' -o report
\`\`\`

It writes \`index.html\` (plots, the cheapest setting for FLIP 0.005, 0.01, 0.02 and 0.04, how far the presets lie above the front), \`trade.csv\` and \`trade.svg\` into the folder. What is
measured stays there: a run that was stopped goes on, and one with more settings measures these alone. The error is that of a window of the picture, at the scale of the
whole, since the tracer needs thousands of paths a pixel there. The time is CPU time of the whole picture; from \`--cap\` seconds on it is told by that of the window: by the pixels
that the model covers, and by how far that was off in the dearest picture of the same family that was drawn whole.

## What was measured

\`${command}\` on ${machine}, other work beside: ${counts.fit} scenes to predict from and ${counts.heldOut} to judge by, ${Object.keys(SETTINGS).length} settings, ${rows.length} measurements, windows of ${window} x ${window} pixels. The truth has
${truth.samples} paths a pixel or a standard error of ${truth.noise} of 255, and its own noise is part of every error. Pictures by the raster are drawn whole for their time up to ${seconds(capOf('raster', { width: 1024 }))}, those by the tracer up to ${seconds(capOf('tracer', { width: 256 }))} at 256 pixels and ${seconds(capOf('tracer', { width: 1024 }))} at 1024.
The time of dearer ones is told by the window: ${scaledOf(rows, PRESET_NAMES.high)} of those in \`high\` by the raster, ${scaledOf(rows, 'tracer noise 1')} of those with a noise of 1.

${table(overall)}

![CPU time against FLIP, medians of all scenes](trade/trade.svg)

three.js in headless Chromium on the same Mesa among them, the T-shirt in the shading \`three\` (\`npm run trade -- --peers --write\`; times of a loaded model):

![CPU time against FLIP of the T-shirt, with three.js in Chromium](trade/peers.svg)

Presets, against the settings that no other one beats in time and error ("the front") of each scene:

${table(presets)}

${aboveSection(rows)}

## Numbers that take work away

They are in no preset, and what they take away is not looked for: the table below has what that costs in error.

| number of \`quality\` | what it does |
| --- | --- |
| \`textureSize\` | larger textures are read from the mip level that fits; where sides are powers of two, larger levels are not uploaded either (\`info.unreadTexels\`). Images are decoded whole all the same |
| \`environmentSize\`, \`prefilterSamples\` | of the prefiltered environment: made once an environment and pair of numbers, and kept on disk |
| \`maxLights\` | lights that shade and cast shadows are those that give the model's middle most; \`L_LIGHTS\` counts what is left |
| \`transmissionScale\` | what lies behind transmissive surfaces is drawn so much smaller |
| \`geometryError\` | fewer triangles, by meshoptimizer: made once for all errors of a mesh between two powers of two, and two forms of a mesh stay. Layers, flats and what morphs or has bones are drawn whole. The T-shirt at 512 x 512 is at FLIP 0.021, 0.041 and 0.065 to itself with 0.25, 0.5 and 1; from 0.5 on its side seams open, as parts that touch are simplified one by one |

three.js in the browser has none of them, and draws the same shot whole.

## Each number alone

\`npm run trade -- --knobs --write\`, as \`telar bench trade --knobs\` does it for other models: six cloths, studio and sun, 256 x 256. What each number of a quality changes against
\`standard\`, and each of a lamp's shadow; the steepest three that take error away are tried together. "FLIP less for a second": of error for CPU time, or of time for error where both are
less. Times have other work beside: a difference of 12 ms or less is none. Directions of the environment bring nothing alone, for few samples leave their noise; with 16 samples and more they
are the denoised settings above. Prefiltering the environment is done once, and is in no time here; so are the rays of ambient visibility, which is set against \`standard\` with a truth of transport
\`occlusion\`. Two knobs of other renderers telar lacks: diffuse light from spherical harmonics, which ring under small lights, and points in place of area lights, which three.js
does not draw either. The target's precision is no knob: it has 8 bits where a browser's has, and floats where samples are averaged. What \`output.effort\` takes and saves is in
[figures.md](figures.md#effort-of-the-encoders).

${knobs}
${heldSection(verdict, byClass, knowing, predicted)}`;
}

/**
 * How often predictions hold.
 * @param {ReturnType<typeof import('./judge.mjs').judge>} verdict
 * @param {ReturnType<typeof import('./judge.mjs').judge>} byClass
 * @param {ReturnType<typeof import('./judge.mjs').judge>} knowing with answers of knowingAnswers()
 * @param {import('../../js/predict/choose.mjs').TradeTable} predicted
 */
export function heldSection(verdict, byClass, knowing, predicted) {
  const { maxError, budgetMs, byError, byBudget } = verdict;
  return `## How often predictions hold

${verdict.scenes} scenes of cloths and models that no prediction was made from, with the times that were measured in the same run. The time of an error has that of the look at the window in it.
Each was asked for ${byError.length} errors and ${byBudget.length} times.

| | goals | said to hold | did hold | within twice the time of the cheapest that held |
|---|---|---|---|---|
| \`maxError\` | ${maxError.asked} | ${maxError.promised} | ${percent(maxError.held)} | ${percent(maxError.near)} |
| \`maxError\` by the class alone, as \`inspect()\` and hosts without Embree have it | ${byClass.maxError.asked} | ${byClass.maxError.promised} | ${percent(byClass.maxError.held)} | ${percent(byClass.maxError.near)} |
| \`maxError\` after a look that knows every error and takes ${EXACT_LOOK} of the time of \`standard\`, which no renderer has | ${knowing.maxError.asked} | ${knowing.maxError.promised} | ${percent(knowing.maxError.held)} | ${percent(knowing.maxError.near)} |
| \`budgetMs\` | ${budgetMs.asked} | ${budgetMs.promised} | ${percent(budgetMs.held)} | |

${percent(maxError.possible)} of the errors that some setting did hold were said to hold.

${table({
  head: ['maxError', 'said to hold', 'did hold', 'within twice the time', 'time over the cheapest, median'],
  lines: byError.map(({ maxError: wanted, promised, held, near, median }) => [
    String(wanted),
    String(promised),
    percent(held),
    percent(near),
    median === undefined ? '-' : median.toFixed(2),
  ]),
})}

${table({
  head: ['budgetMs', 'said to fit', 'did fit'],
  lines: byBudget.map(({ budgetMs: wanted, promised, held }) => [String(wanted), String(promised), percent(held)]),
})}

The target is 95 % of errors held, all within twice the time of the cheapest, and 90 % of times held. The second is missed: a picture in \`standard\` takes less time than it takes to know
that it is good enough, and the next settings take eight times as long. Settings between them were tried, denoised from 2, 4 and 8 passes of 8 to 32 directions, which no option has: they took two to five
times the time of \`standard\`, and erred by 0.051, 0.039 and 0.037 where \`standard\` erred by 0.046 and \`medium\`, in seven times the time, by 0.026 (18 windows of six cloths). A look that compares with denoised passes of the raster (64 or 256 samples) in place of paths was tried: 52 and 48 % within twice
the time, and 93 and 94 % of errors held. Of 40 scenes of an earlier run looks that took no time would have brought 65 %, of 32 x 32 pixels 67 %: most that they cannot tell apart lie about \`standard\`. One that knew every error would bring
all, if it took no more than 0.3 of the time of \`standard\`. Predictions are from ${predicted.scenes} scenes.
`;
}
