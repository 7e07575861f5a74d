import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { readLimits, readTimeout } from './limits.mjs';
import { checkModel, readModel } from './models.mjs';
import { readShotOptions } from './shot_options.mjs';

/**
 * telar inspect MODEL
 * What is in the file, what a render would compile and run, warnings, sizes in metres.
 * @param {string} given path or file: URL of a model, or - for stdin
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {api: object, console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} exit code
 */
export async function inspect(given, options, context) {
  if (given === '-' && options.shot === '-') throw new TelarError('E_USAGE', '- (stdin) can stand for one file only');
  const { model } = await checkModel(given);
  const shot = await readShotOptions(options, context);
  const limits = readLimits(options.limit);
  const source = await readModel(model, limits, context);
  const measure = readMeasures(options.measure);
  const facts = await context.api.inspect(source, {
    shot,
    ...measure,
    limits,
    failOn: options.failOn,
    timeoutMs: readTimeout(options.timeoutMs),
    signal: context.signal,
  });
  for (const warning of facts.warnings ?? []) context.console.warning(warning, model);
  await context.console.result({ ok: true, model, ...facts }, factLines(model, facts));
  return 0;
}

/** @throws {TelarError} E_USAGE */
function readMeasures(texts) {
  if (!texts) return {};
  const parsed = texts.map((text) => {
    try {
      return JSON.parse(text);
    } catch {
      throw new TelarError('E_USAGE', `--measure: expected JSON, as in {"points": [[0, 0, 0], [0, 1, 0]], "along": "surface"}, got ${shown(text)}`);
    }
  });
  return { measure: parsed };
}

/** Tenths of a millimetre, which is what a length on a model is good for. */
const lengthText = (metre) => `${metre.toFixed(4)} m`;

function measureText({ length, lengths, loops, closed }) {
  if (loops) return `border of ${count(loops.length, 'loop')}, ${loops.map((loop) => lengthText(loop.length)).join(' + ')}`;
  if (lengths) return `${lengthText(length)}${lengths.length > 1 ? ` (${lengths.map(lengthText).join(' + ')})` : ''}`;
  return `girth ${lengthText(length)}${closed ? '' : ', open'}`;
}

const count = (n, noun, nouns = `${noun}s`) => `${n.toLocaleString('en-US')} ${n === 1 ? noun : nouns}`;
const metres = (x) => `${Number(x.toPrecision(4))} m`;
const named = (list) => list.map((item) => (typeof item === 'string' ? item : item.name) || '(no name)').join(', ');

/** What of a material the shading "fabric" alone reads. */
function fabricText({ diffuseTransmission, flatness, weave, back }) {
  const parts = [
    diffuseTransmission && `lets ${percent(diffuseTransmission)} through`,
    flatness && `flatness ${percent(flatness)}`,
    weave && `weave ${percent(weave.warp)} warp ${percent(weave.weft)} weft`,
    back && 'its own back',
  ];
  return `fabric (${parts.filter(Boolean).join(', ')})`;
}

const percent = (share) => `${Math.round(100 * share)} %`;

function materialLines(materials) {
  return materials.map(({ name, alphaMode, doubleSided, unlit, metallic, roughness, textures = [], preset, fabric, metresPerUv, proposedPreset }, i) => {
    const facts = [
      `metallic ${metallic}`,
      `roughness ${Number(roughness?.toPrecision(3))}`,
      alphaMode !== 'OPAQUE' && `alpha ${alphaMode}`,
      doubleSided && 'double-sided',
      unlit && 'unlit',
      textures.length > 0 && `textures ${textures.join(' ')}`,
      preset && `preset ${preset}`,
      fabric && fabricText(fabric),
      metresPerUv && `${metresPerUv.map((x) => Number(x.toPrecision(3))).join(' x ')} m a unit of UV`,
      proposedPreset && `perhaps ${proposedPreset}`,
    ].filter(Boolean);
    return `  ${i} ${name || '(no name)'}: ${facts.join(', ')}`;
  });
}

function animationLines(animations) {
  if (animations.length === 0) return ['animations  none'];
  return [`animations  ${animations.length}`, ...animations.map(({ name, duration }, i) => `  ${i} ${name}: ${Number(duration.toPrecision(4))} s`)];
}

/** An image of width 0 was not decoded: no drawn material uses it. */
const imageText = ({ width, height, format, levels }) => {
  if (width === 0) return 'unused';
  return [`${width}x${height}`, format, levels && count(levels, 'level')].filter(Boolean).join(' ');
};

function factLines(model, facts) {
  const { bounds, size, materials = [], images = [], lights = [], cameras = [], animations = [], variants = [], extensionsUsed = [], plan } = facts;
  const lines = [
    model === '-' ? 'stdin' : model,
    `size        ${bounds ? `${size.map(metres).join(' x ')} (width x height x depth)` : 'nothing to draw'}`,
    `geometry    ${[
      count(facts.triangles ?? 0, 'triangle'),
      count(facts.vertices ?? 0, 'vertex', 'vertices'),
      count(facts.meshes ?? 0, 'mesh', 'meshes'),
      count(facts.drawCalls ?? 0, 'draw call'),
    ].join(', ')}`,
    `file        ${count(facts.fileBytes ?? 0, 'byte')}${facts.generator ? `, by ${facts.generator}` : ''}`,
    ...(facts.copyright ? [`copyright   ${facts.copyright}`] : []),
    `materials   ${materials.length}`,
    ...materialLines(materials),
    `images      ${images.length === 0 ? 'none' : images.map(imageText).join(', ')}`,
    `variants    ${variants.length === 0 ? 'none' : named(variants)}`,
    ...animationLines(animations),
    `cameras     ${cameras.length === 0 ? 'none' : named(cameras)}`,
    `lights      ${lights.length === 0 ? 'none' : named(lights)}`,
    `extensions  ${extensionsUsed.length === 0 ? 'none' : extensionsUsed.join(', ')}`,
  ];
  const measures = (facts.measures ?? []).map((measure) => `measured    ${measureText(measure)}`);
  return [...lines, ...measures, ...planLines(plan)];
}

const textOf = (item) => (typeof item === 'string' ? item : (item.name ?? JSON.stringify(item)));

function planLines(plan) {
  if (!plan) return [];
  const { features = [], programs = [], passes = [], fragments = 0 } = plan;
  return [
    `features    ${features.map(textOf).join(', ') || 'none'}`,
    `programs    ${programs.length}`,
    `passes      ${passes.map(textOf).join(', ') || 'none'}`,
    ...(fragments > 0 ? [`fragments   at most ${count(fragments, 'fragment')} a pass`] : []),
  ];
}
