import { TelarError } from '../error/index.mjs';
import { nearest, shown } from './complain.mjs';
import { frameSchema } from './schema.mjs';

/**
 * A part of a model that a camera frames: the nodes of a name with all beneath them, or all that is drawn with a material.
 *
 * What the part measures, from `renderer` or from `factsOf` of telar/three.
 * @typedef {object} PartFact
 * @property {{node: number | string} | {material: number | string}} frame - What was measured.
 * @property {boolean} found - Whether the model has it.
 * @property {import('./frame.mjs').Bounds} [bounds] - Metres; undefined where it draws nothing.
 * @property {string[]} [names] - Where it draws nothing: of what could be framed instead.
 */

/** Whether a camera's `frame` is a part of the model. */
export const isPart = (frame) => typeof frame === 'object';

/**
 * The part that a shot frames, so that it can be measured before the shot is resolved.
 * @param {import('../index.d.ts').Shot} shot
 * @returns {{kind: 'node' | 'material', which: number | string, frame: object} | undefined} undefined where it frames the model; a wrong
 *   one is resolveShot's to tell
 */
export function resolvePart(shot) {
  const { success, data } = frameSchema.safeParse(shot?.camera?.frame);
  if (!success || !isPart(data)) return undefined;
  const [[kind, which]] = Object.entries(data);
  return { kind, which, frame: data };
}

const isSame = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const MOST_LISTED = 8;

/**
 * @param {object} frame a part
 * @param {{part?: PartFact}} facts
 * @returns {import('./frame.mjs').Bounds}
 * @throws {TelarError} E_FRAME
 */
export function boundsOfPart(frame, { part }) {
  const [[kind, which]] = Object.entries(frame);
  const wrong = (message) => new TelarError('E_FRAME', `shot.camera.frame.${kind}: ${message}`, { pointer: `/camera/frame/${kind}` });
  if (!part || !isSame(part.frame, frame))
    throw wrong(`the facts of the model do not measure the ${kind} ${shown(which)}; renderer.factsOf does, and factsOf of telar/three with \`frame\``);
  if (part.bounds) return part.bounds;
  const { names = [] } = part;
  const near = typeof which === 'string' && !part.found ? nearest(which, names) : undefined;
  const more = names.length > MOST_LISTED ? ' and others' : '';
  const instead = near
    ? `did you mean ${shown(near)}?`
    : names.length > 0
      ? `it has ${names.slice(0, MOST_LISTED).map(shown).join(', ')}${more}`
      : 'none has a name';
  throw wrong(part.found ? `the ${kind} ${shown(which)} draws nothing; ${instead}` : `the model has no ${kind} ${shown(which)}; ${instead}`);
}
