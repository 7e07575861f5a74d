import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { isNamedEnvironment } from '../shot/table/environments.mjs';
import { describe } from './describe.mjs';
import { readAll } from './streams.mjs';

/** The command line's way to a shot: --shot FILE, then the flags, then each --set in order. */

/** Resolution of pictures in true scale: what printers take. */
const PAPER_PPI = 300;

const usage = (message) => new TelarError('E_USAGE', message);
/** Values of a flag that may be given again, as commander hands them over. */
export const collect = (value, list = []) => [...list, value];

/** Adds the options that make a shot to a commander command. */
export function addShotOptions(command) {
  return command
    .option('--shot <file>', 'JSON of a shot; relative paths in it start at the file; - is stdin')
    .option('--set <key=value>', 'one key of the shot, as in --set camera.fit=0.8 or --set lights.0.color=red; value is JSON or text', collect)
    .option('--look <look>', 'catalogue, ghost, hanger, flat-lay, furniture or hero: what the shot leaves out, as `telar looks` says')
    .option('--view <view>', describe('camera.view'))
    .option('--frame <what>', 'scene, model, node=NAME or material=NAME, as in --frame node=Sleeve: what a view frames')
    .option('--fit-to <what>', describe('camera.fitTo'))
    .option('--size <WxH>', `${describe('size')} in pixels, 512x512 or 512`)
    .option('--quality <quality>', describe('quality'))
    .option('--shading <shading>', describe('shading'))
    .option('--environment <map>', describe('environment.map'))
    .option('--background <colour>', describe('background'))
    .option('--variant <name>', describe('variant'))
    .option(
      '--material <part=cloth>',
      'a part in another cloth, PART=PRESET, PART=PRESET:COLOUR or PART=:COLOUR, as in --material "Body*=denim:#23324f"; may stand several times',
      collect,
    )
    .option(
      '--layers <names>',
      'images beside the colour, with commas between: depth, normal, partId, materialId, ao, albedo, shadow, coverage, line; OUT.depth.png and so on',
    )
    .option('--ghost <part[:opacity]>', 'draw a part translucent, as in --ghost node=front:0.2, or leave it out by 0; * in names; repeatable', collect)
    .option('--style <style>', describe('style'))
    .option('--scale <scale>', '1:5 and the like: true scale on paper at output.ppi, 300 where --set gives none; the size follows');
}

/**
 * @param {object} options as commander parsed them
 * @param {{stdin: import('node:stream').Readable}} io
 * @param {{isLocal?: boolean}} [how] isLocal: its environment may be a file here
 * @returns {Promise<object>} shot, not yet resolved
 * @throws {TelarError} E_USAGE, E_FILE
 */
export async function readShotOptions(options, io, { isLocal = true } = {}) {
  const shot = options.shot === undefined ? {} : await readShotFile(options.shot, io, isLocal);
  applyFlags(shot, options);
  for (const assignment of options.set ?? []) applyAssignment(shot, assignment);
  return shot;
}

async function readShotFile(file, { stdin }, isLocal) {
  const text = await readText(file, stdin);
  let shot;
  try {
    shot = JSON.parse(text);
  } catch (error) {
    throw usage(`--shot ${shown(file)} is not JSON: ${error.message}`);
  }
  if (typeof shot !== 'object' || shot === null || Array.isArray(shot)) throw usage(`--shot ${shown(file)}: expected an object, got ${shown(shot)}`);
  return file === '-' || !isLocal ? shot : withPathsFrom(path.dirname(file), shot);
}

async function readText(file, stdin) {
  if (file === '-') return (await readAll(stdin, 1 << 24)).toString('utf8');
  try {
    return await readFile(file, 'utf8');
  } catch (error) {
    throw new TelarError('E_FILE', `--shot ${shown(file)} cannot be read (${error.code})`, { cause: error });
  }
}

/** Relative paths in a shot start at its file. */
export function withPathsFrom(folder, shot) {
  const rebase = (map) => (typeof map === 'string' && !isNamedEnvironment(map) ? path.resolve(folder, map) : map);
  const { environment } = shot;
  if (typeof environment === 'string') return { ...shot, environment: rebase(environment) };
  if (environment?.map !== undefined) return { ...shot, environment: { ...environment, map: rebase(environment.map) } };
  return shot;
}

function applyFlags(shot, { look, view, frame, fitTo, size, quality, shading, environment, background, variant, material, layers, ghost, style, scale }) {
  if (look !== undefined) shot.look = look;
  if (view !== undefined) shot.camera = { ...framingOf(shot.camera), view };
  if (frame !== undefined) shot.camera = { ...shot.camera, frame: parseFrame(frame) };
  if (fitTo !== undefined) shot.camera = { ...shot.camera, fitTo };
  if (size !== undefined) shot.size = parseSize(size);
  if (quality !== undefined) shot.quality = parseValue(quality);
  if (shading !== undefined) shot.shading = parseShading(shading, '--shading');
  if (environment !== undefined) shot.environment = { ...settingsOf(shot.environment), map: environment };
  if (background !== undefined) shot.background = parseValue(background);
  if (variant !== undefined) shot.variant = variant;
  if (material !== undefined) shot.materials = { ...shot.materials, ...Object.fromEntries(material.map(parseMaterial)) };
  if (layers !== undefined) shot.layers = layers.split(',').map((name) => name.trim());
  if (ghost !== undefined) shot.ghost = ghost.map(parseGhost);
  if (style !== undefined) shot.style = style;
  if (scale !== undefined) {
    shot.scale = scale;
    shot.output = { ppi: PAPER_PPI, ...shot.output };
  }
}

const pick = (object, keys) => Object.fromEntries(keys.filter((key) => object?.[key] !== undefined).map((key) => [key, object[key]]));

/** A named view takes the place of any other camera, and keeps how that one framed. */
export const framingOf = (camera) => (camera?.position === undefined ? pick(camera, ['projection', 'fovY', 'fit', 'frame', 'fitTo']) : {});
const settingsOf = (environment) => pick(environment, ['intensity', 'rotation']);

/** "node=front:0.2" as {node: "front", opacity: 0.2}. Other words are the schema's to judge. */
function parseGhost(text) {
  const [, part, opacity] = /^(.*?)(?::([\d.]+))?$/s.exec(text);
  const named = parseFrame(part);
  return typeof named === 'string' ? text : { ...named, ...(opacity !== undefined && { opacity: Number(opacity) }) };
}

/** "node=Sleeve" as {node: "Sleeve"}; a number is an index. Other words are the schema's to judge. */
function parseFrame(text) {
  const [, kind, which] = /^(node|material)=(.*)$/s.exec(text) ?? [];
  return kind === undefined ? text : { [kind]: /^\d+$/.test(which) ? Number(which) : which };
}

/** "Body*=denim:#23324f" as ["Body*", {preset: "denim", color: "#23324f"}]. @throws {TelarError} E_USAGE */
function parseMaterial(text) {
  const [isMaterial, part, preset, color] = /^(.*?)=([^:]*)(?::(.*))?$/s.exec(text) ?? [];
  if (!isMaterial || part === '' || (preset === '' && !color))
    throw usage(`--material: expected PART=PRESET:COLOUR, as in "Body*=denim:#23324f", got ${shown(text)}`);
  return [part, { ...(preset !== '' && { preset }), ...(color !== undefined && { color }) }];
}

/** "512x512" or "512" as {width, height} in pixels. @throws {TelarError} E_USAGE */
export function parseSize(text) {
  const match = /^(\d+)(?:x(\d+))?$/i.exec(text);
  if (!match) throw usage(`--size: expected WxH in pixels, as in 512x512, got ${shown(text)}`);
  return { width: Number(match[1]), height: Number(match[2] ?? match[1]) };
}

/** JSON where it is JSON, else the text itself: 0.8, true, [1, 0, 0], red. */
export function parseValue(text) {
  try {
    return JSON.parse(text);
  } catch {
    return text;
  }
}

/** three@180, three@0.180 or three@0.180.2: patches draw alike, and the table says where not. */
const RELEASE = /^three@(?:(\d+)|0\.(\d+)(?:\.\d+)?)$/;

/**
 * A shading as the user wrote it: a name, a release of three.js, or JSON.
 * @param {string} text
 * @param {string} option - Stands in the message.
 * @throws {TelarError} E_USAGE
 */
export function parseShading(text, option) {
  if (!text.startsWith('three@')) return parseValue(text);
  const [isRelease, number, minor] = RELEASE.exec(text) ?? [];
  if (!isRelease) throw usage(`${option}: expected a release of three.js as in three@180, got ${shown(text)}`);
  return { base: 'three', revision: Number(number ?? minor) };
}

/** Keys whose value may be a name alone: where the name goes when more is said. */
const NAMED_BY = { shading: 'base', quality: 'preset', environment: 'map' };

/**
 * Sets one key: "camera.fit=0.8", "lights.0.color=red". Only own keys are followed, so that no key reaches a prototype.
 * A number behind a list's key is an index, which may append one item.
 */
function applyAssignment(shot, assignment) {
  const equals = assignment.indexOf('=');
  if (equals < 1) throw usage(`--set: expected key=value, as in camera.fit=0.8, got ${shown(assignment)}`);
  const keys = assignment.slice(0, equals).split('.');
  const text = assignment.slice(equals + 1);
  const value = keys.length === 1 && keys[0] === 'shading' ? parseShading(text, '--set shading') : parseValue(text);
  let node = shot;
  keys.forEach((key, depth) => {
    if (Array.isArray(node) && !(/^\d+$/.test(key) && Number(key) <= node.length)) {
      throw usage(`--set ${shown(assignment)}: expected an index up to ${node.length} in place of ${shown(key)}`);
    }
    const isLast = depth === keys.length - 1;
    const next = Object.hasOwn(node, key) ? node[key] : undefined;
    const isObject = typeof next === 'object' && next !== null;
    const named = depth === 0 && typeof next === 'string' && Object.hasOwn(NAMED_BY, key) ? { [NAMED_BY[key]]: next } : {};
    const fresh = /^\d+$/.test(keys[depth + 1] ?? '') ? [] : named;
    const written = isLast ? value : isObject ? next : fresh;
    Object.defineProperty(node, key, { value: written, enumerable: true, configurable: true, writable: true });
    node = written;
  });
}
