import { TelarError } from '../error/index.mjs';
import { complaint, nearest, shown } from './complain.mjs';
import { poseSchema } from './schema.mjs';

/**
 * The moment that a shot shows, with every default written out. What a model measures depends on it, so that it comes before
 * the rest of the shot: first the pose, then the facts of the model in that pose, then `resolveShot(shot, facts)`.
 * @param {import('../index.d.ts').Shot} shot
 * @param {{animations?: {name: string, duration: number}[]}} [facts] of the model, in any pose
 * @returns {{animation: number, time: number} | null} index into the model's animations, seconds; null = as the file stands
 * @throws {TelarError} E_SHOT, E_POSE
 */
export function resolvePose(shot, facts) {
  const result = poseSchema.safeParse(shot?.pose);
  if (!result.success) throw complaint(result.error.issues, shot.pose, poseSchema, { path: ['pose'] });
  return posed(result.data, facts?.animations);
}

/** @internal on a parsed pose */
export function posed(pose, animations) {
  if (pose === null) return null;
  const { animation: wanted } = pose;
  if (typeof wanted === 'number' && (animations === undefined || wanted < animations.length)) return { ...pose };
  const index = animations?.findIndex(({ name }) => name === wanted) ?? -1;
  if (index < 0) throw new TelarError('E_POSE', missing(wanted, animations), { pointer: '/pose/animation' });
  return { ...pose, animation: index };
}

function missing(wanted, animations) {
  if (animations === undefined) return `shot.pose.animation: the facts of the model list no animations to find ${shown(wanted)} in`;
  const has = `shot.pose.animation: the model has no animation ${shown(wanted)}`;
  if (animations.length === 0) return `${has}; it has none`;
  const near =
    typeof wanted === 'string'
      ? nearest(
          wanted,
          animations.map(({ name }) => name),
        )
      : undefined;
  const names = animations
    .slice(0, 8)
    .map(({ name }, index) => `${index} ${shown(name)}`)
    .join(', ');
  return `${has}; ${near ? `did you mean ${shown(near)}?` : `it has ${names}`}`;
}
