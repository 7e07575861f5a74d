import { TelarError } from '../error/index.mjs';
import { complaint, nearest, shown, wrongValue } from './complain.mjs';
import { contactLights } from './contact.mjs';
import { readFacts } from './facts.mjs';
import { fallenShadow } from './fallen_shadow.mjs';
import { cornersOfGround, resolveGround } from './ground.mjs';
import { resolveLens } from './lens.mjs';
import { withLook } from './looks.mjs';
import { posed } from './pose.mjs';
import { resolveQuality } from './quality.mjs';
import { shotSchema } from './schema.mjs';
import { resolveTerms, WITHOUT_TERMS } from './shading_terms.mjs';
import { resolveShadow } from './shadow.mjs';
import { SHOT } from './table/index.mjs';
import { LAYERS, LAYER_FORMATS } from './table/layers.mjs';
import { FORMATS, output as OUTPUT } from './table/output.mjs';
import { copied, inOrder } from './table/resolved.mjs';
import { HUGE } from './table/rows.mjs';
import { ENVIRONMENT } from './table/stage.mjs';
import { TONE_MAPPINGS } from './table/tone_mappings.mjs';
import { resolveThree } from './three_terms.mjs';
import { resolveScale } from './true_scale.mjs';

const WHITE = [1, 1, 1];

/**
 * Writes out every default of a shot. Pure and synchronous, the same bits in the browser and on the server; a resolved
 * shot resolves to itself.
 *
 * Lengths are metres, camera and environment angles degrees, spot cones radians; colours come out as linear Rec.709.
 * @param {import('../index.d.ts').Shot} [shot]
 * @param {import('../index.d.ts').ShotFacts} [facts] of the model, or its box {min, max}; needed unless the camera is
 *   explicit with near and far; of the model in the shot's pose (`resolvePose`) where it has one
 * @returns {import('../index.d.ts').ResolvedShot} new objects throughout; the arguments stay as they were
 * @throws {TelarError} E_SHOT with the path, the expected thing and the value given; E_CAMERA,
 *   E_FRAME, E_VARIANT, E_POSE, E_NO_GEOMETRY, E_EXTENT where the model lacks what the shot asks for; E_OPTION for wrong facts
 */
export function resolveShot(shot = {}, facts = undefined) {
  const parsed = parseShot(shot);
  const known = readFacts(facts);
  const { output, environment, background, shading, quality, layers } = resolveWithoutModel(parsed);
  const { lights, ground } = resolveStage(parsed, known);
  const standing = { corners: cornersOfGround(ground), shadow: fallenShadow(ground, lights, known) };
  const { size, camera } = resolveScale(parsed, { hasSize: shot.size !== undefined, facts: known, standing });
  const lens = resolveLens(parsed.lens, camera);
  checkFitted({ camera, lens, lights, ground });
  const variant = resolveVariant(parsed.variant, known.variants);
  const pose = posed(parsed.pose, known.animations);
  return inOrder(SHOT, { ...copied(parsed), size, camera, lens, environment, lights, background, ground, shading, quality, variant, pose, layers, output });
}

/** What is fitted to a camera or a light that stands beyond measure may leave the range that a shot can say. */
function checkFitted(value, path = []) {
  if (typeof value === 'number' && !(Math.abs(value) <= HUGE)) throw wrongValue(path, 'a number in [-1e30, 1e30], as fitted to what the shot places', value);
  if (typeof value !== 'object' || value === null) return;
  for (const [key, inner] of Object.entries(value)) checkFitted(inner, [...path, Array.isArray(value) ? Number(key) : key]);
}

/**
 * A shot with the defaults of the schema.
 * @internal
 * @throws {TelarError} E_SHOT
 */
export function parseShot(shot) {
  const whole = withLook(shot);
  const result = shotSchema.safeParse(whole);
  if (!result.success) throw complaint(result.error.issues, whole, shotSchema);
  return result.data;
}

/**
 * The keys of a resolved shot that depend on other keys, and not on the model.
 * @internal
 * @param {object} parsed of parseShot
 * @throws {TelarError} E_SHOT
 */
export function resolveWithoutModel(parsed) {
  const output = resolveOutput(parsed);
  const environment = resolveEnvironment(parsed.environment);
  checkToneMapping(parsed);
  return {
    output,
    environment,
    background: resolveBackground(parsed, output.format, environment),
    shading: resolveShading(parsed.shading),
    quality: resolveQuality(parsed.quality),
    layers: resolveLayers(parsed.layers),
  };
}

function resolveEnvironment(environment) {
  const isMap = typeof environment === 'string' || environment instanceof Uint8Array;
  return inOrder(ENVIRONMENT, isMap ? { map: environment } : environment);
}

const samePoint = (a, b) => a.every((x, i) => x === b[i]);

/** The lights with their shadows, and the ground that these fall on: each is sized by the others. */
function resolveStage({ lights: given, ground: wanted, shading }, facts) {
  const placed = resolveLights(given);
  const lacksShadow = wanted !== 'none' && !placed.some(({ castShadow }) => castShadow);
  const lights = lacksShadow ? [...placed, ...contactLights(facts)] : placed;
  const ground = resolveGround(wanted, lights, facts);
  const receivers = cornersOfGround(ground);
  const isPacked = resolveShading(shading).shadowFilter === 'packed-grid';
  const shadowed = (light, i) => ({ ...light, shadow: resolveShadow(light, ['lights', i], facts, receivers, isPacked) });
  return {
    lights: lights.map((light, i) => (light.castShadow ? shadowed(light, i) : light)),
    ground,
  };
}

function resolveLights(lights) {
  return lights.map((light, i) => {
    if (light.target && samePoint(light.target, light.position)) {
      throw wrongValue(['lights', i, 'target'], 'a point other than the position', light.target);
    }
    if (light.shadow && !light.castShadow) throw wrongValue(['lights', i, 'castShadow'], 'true where `shadow` is given', light.castShadow);
    return copied(light);
  });
}

function resolveBackground({ background, style }, format, environment) {
  if (background === undefined) return !FORMATS[format].alpha || style === 'flat' ? [...WHITE] : 'transparent';
  if (background === 'transparent' && !FORMATS[format].alpha) {
    throw wrongValue(['background'], `a colour or "environment", as ${format} has no transparency`, background);
  }
  const { type = background, blur } = background;
  if (type === 'environment' && environment.map === 'none') {
    throw wrongValue(['background'], '"transparent" or a colour, as shot.environment is "none"', background);
  }
  if (type === 'environment' && style === 'flat') throw wrongValue(['background'], '"transparent" or a colour with style "flat"', background);
  return blur === 0 ? 'environment' : background;
}

function resolveShading(shading) {
  if (WITHOUT_TERMS.includes(shading)) return shading;
  return shading.base === 'three' ? resolveThree(shading) : resolveTerms(shading);
}

/** A release of three.js that has not this tone mapping yet cannot be what the client shows. */
function checkToneMapping({ toneMapping, shading }) {
  const { since } = TONE_MAPPINGS[toneMapping];
  if (shading.base !== 'three' || !(shading.revision < since)) return;
  throw wrongValue(['toneMapping'], `a tone mapping that three.js 0.${shading.revision} has (0.${since} brought this one)`, toneMapping);
}

function resolveVariant(variant, variants) {
  if (variant === '' || !Array.isArray(variants) || variants.includes(variant)) return variant;
  const near = nearest(variant, variants);
  const hint = near ? `did you mean ${shown(near)}?` : `it has ${variants.length > 0 ? variants.slice(0, 8).map(shown).join(', ') : 'none'}`;
  throw new TelarError('E_VARIANT', `shot.variant: the model has no variant ${shown(variant)}; ${hint}`, { pointer: '/variant' });
}

function resolveOutput({ output, scale }) {
  const { bitDepths, ppi, icc } = FORMATS[output.format];
  const { bitDepth = bitDepths[0] } = output;
  if (!bitDepths.includes(bitDepth)) throw wrongValue(['output', 'bitDepth'], `${bitDepths.join(' or ')} for ${output.format}`, bitDepth);
  if (output.ppi > 0 && !ppi && scale === 'none') throw wrongValue(['output', 'ppi'], `0, as ${output.format} holds no ppi`, output.ppi);
  if (output.icc && !icc) throw wrongValue(['output', 'icc'], `false, as ${output.format} holds no profile here`, output.icc);
  return inOrder(OUTPUT, { ...output, bitDepth, layers: resolveLayerOutput(output) });
}

function resolveLayerOutput({ format: colour, layers }) {
  const bitDepths = LAYER_FORMATS[layers.format];
  const { bitDepth = bitDepths[0], format, together } = layers;
  if (!bitDepths.includes(bitDepth)) throw wrongValue(['output', 'layers', 'bitDepth'], `${bitDepths.join(' or ')} for ${format}`, bitDepth);
  if (together && (format !== 'exr' || colour !== 'exr')) {
    throw wrongValue(['output', 'layers', 'together'], 'false, as output.format and output.layers.format are not both "exr"', together);
  }
  return inOrder(OUTPUT.shape.layers, { ...layers, bitDepth });
}

/** Each once, in the order of the table; the colour is always drawn. */
const resolveLayers = (wanted) => ['beauty', ...Object.keys(LAYERS).filter((name) => wanted.includes(name))];
