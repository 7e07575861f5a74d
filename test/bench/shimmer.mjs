// Shimmer of cloth: how much its pixels flicker over a slow turn in quality standard of shading "fabric", against the path tracer. 60 frames, half a
// degree apart, of a window of 24 x 24 out of a picture of 256.
// Flicker is the mean square of second differences from frame to frame, in luma to the power of 1 / 2.2, over 6: the variance of what is not
// smooth. Floats, since rounding to 1/255 alone would be a variance of 1.3 millionths. The tracer draws each frame with two seeds, and the product of
// their differences stands for the square: its noise, which both do not share, has no part in it. "its noise" is the variance of one seed's.
// Edges of the drape, which are meant to move, have no part in it: of sheer cloth and nets, too, whose own coverage does not tell them.
// node test/bench/shimmer.mjs [CLOTH...]      needs the dev build (npm test makes it)
import { createRenderer } from '../../js/index.mjs';
import { ENVIRONMENTS, FABRIC_MODELS } from '../fixtures/index.mjs';
import { HELD_OUT_FABRICS, TUNED_FABRICS } from '../fixtures/scenes_held_out.mjs';

/** Presets by their names, and what is or was held out. */
const MODELS = {
  ...Object.fromEntries(Object.entries(FABRIC_MODELS).map(([name, make]) => [name.replace('fabric-', ''), make])),
  ...HELD_OUT_FABRICS,
  ...TUNED_FABRICS,
};
const cloths = process.argv.length > 2 ? process.argv.slice(2) : ['tulle', 'sequin-thread', 'leather', 'denim'];
const FRAMES = 60;
const STEP = (0.5 * Math.PI) / 180;
const PICTURE = 256;
const SIDE = 24;
const PATHS = 96;
const MOST = 1.3;
const TARGET = [0.08, 0.03, 0.06];
const DISTANCE = 0.9;

const shotAt = (frame) => {
  const angle = (frame - FRAMES / 2) * STEP;
  return {
    size: { width: SIDE, height: SIDE },
    camera: {
      position: [TARGET[0] + DISTANCE * Math.sin(angle), TARGET[1], TARGET[2] + DISTANCE * Math.cos(angle)],
      target: TARGET,
      fovY: (30 * SIDE) / PICTURE,
    },
    environment: ENVIRONMENTS['soft-studio'](),
    shading: 'fabric',
    toneMapping: 'none',
    output: { format: 'raw', bitDepth: 32 },
  };
};

const renderer = await createRenderer({ cacheDirectory: null, timeoutMs: null });

/** Which pixels lie wholly on the drape: those that it covers wholly when it is of leather. */
async function onCloth(model, frame) {
  const shot = { ...shotAt(frame), materials: { '*': { preset: 'leather' } }, quality: { samples: 64 } };
  const { data } = await renderer.render(model, shot);
  const floats = new Float32Array(data.buffer.slice(data.byteOffset, data.byteOffset + data.length));
  return Array.from({ length: SIDE * SIDE }, (_, i) => floats[4 * i + 3] >= 1);
}

/** Of each pixel, before black. */
async function lumaOf(model, frame, quality) {
  const { data } = await renderer.render(model, { ...shotAt(frame), quality });
  const floats = new Float32Array(data.buffer.slice(data.byteOffset, data.byteOffset + data.length));
  return Array.from({ length: SIDE * SIDE }, (_, i) => {
    const [r, g, b] = floats.subarray(4 * i, 4 * i + 3);
    return Math.max(0.2126 * r + 0.7152 * g + 0.0722 * b, 0) ** (1 / 2.2);
  });
}

const bend = (frames, t, i) => frames[t - 1][i] - 2 * frames[t][i] + frames[t + 1][i];

/** Mean product of the second differences of two films, over pixels that are cloth in three frames, and its standard error. */
function flicker(a, b, cloth) {
  let [sum, squares, count] = [0, 0, 0];
  for (let t = 1; t + 1 < FRAMES; ++t) {
    for (let i = 0; i < SIDE * SIDE; ++i) {
      if (![t - 1, t, t + 1].every((k) => cloth[k][i])) continue;
      const product = (bend(a, t, i) * bend(b, t, i)) / 6;
      sum += product;
      squares += product ** 2;
      count += 1;
    }
  }
  // Second differences of white noise share 2/3 of it with their neighbours in time: the mean knows about half as many products.
  return { mean: sum / count, error: Math.sqrt((2 * squares) / count ** 2) };
}

let held = true;
console.log('| cloth | standard | reference | its error | its noise | ratio |\n|---|---|---|---|---|---|');
for (const name of cloths) {
  const model = await renderer.load(await MODELS[name]());
  const [cloth, standard, one, other] = [[], [], [], []];
  for (let frame = 0; frame < FRAMES; ++frame) {
    const traced = (seed) => lumaOf(model, frame, { preset: 'reference', transport: 'direct', samples: PATHS, seed });
    cloth.push(await onCloth(model, frame));
    standard.push(await lumaOf(model, frame, 'standard'));
    one.push(await traced(2 * frame + 1));
    other.push(await traced(2 * frame + 2));
  }
  const shown = flicker(standard, standard, cloth).mean;
  const truth = flicker(one, other, cloth);
  const noise = flicker(one, one, cloth).mean - truth.mean;
  held &&= shown <= MOST * (truth.mean + 2 * truth.error);
  const millionths = (value) => (1e6 * value).toFixed(1);
  const ratio = truth.mean > 2 * truth.error ? (shown / truth.mean).toFixed(2) : 'not told';
  console.log(`| ${name} | ${[shown, truth.mean, truth.error, noise].map(millionths).join(' | ')} | ${ratio} |`);
}
await renderer.close();
console.log(`\nvariances in millionths; wanted: a ratio of ${MOST} at most, within two standard errors`);
process.exitCode = held ? 0 : 1;
