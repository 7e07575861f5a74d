import { bakeBody, bakeLowering } from './body.mjs';
import { Drape } from './drape.mjs';
import { sewGarment } from './garment.mjs';
import { placeGarment } from './placement.mjs';
import { transferDrape } from './surface.mjs';
import { seeded } from '../random.mjs';

const GRAVITY = 9.81;

/**
 * Coarse to fine: the fall and the lowering of the arms on few particles, the folds on many.
 * `spacing` metres, `step` seconds, `damping` 1/s at the start and at the end, `sway` the share of
 * gravity that rocks the cloth sideways at the start, so that folds settle as on a person who moved.
 */
export const LEVELS = [
  { spacing: 0.018, step: 1e-3, steps: 2600, damping: [2, 3], sway: 0, lowering: [0.25, 0.8] },
  { spacing: 0.0095, step: 6e-4, steps: 3000, damping: [1.5, 16], sway: 0.16 },
];

function controlOf(level, first, lowering, body) {
  const { damping, steps, step, sway } = level;
  return (progress) => {
    const time = progress * steps * step;
    const rocking = sway * GRAVITY * Math.max(0, 1 - progress / 0.5);
    const share = first ? Math.min(1, progress * 6) : 1;
    const pull = [rocking * Math.sin(time * 9), -GRAVITY * share, rocking * 0.7 * Math.sin(time * 6.3 + 1)];
    const [from, to] = level.lowering ?? [0, 0];
    const moving = level.lowering && progress < to;
    return {
      damping: damping[0] + (damping[1] - damping[0]) * progress ** 2,
      pull,
      body: moving ? lowering((progress - from) / (to - from)) : body,
    };
  };
}

/**
 * Dress the invisible body.
 * @param {object} pattern - From `tshirtPattern`.
 * @param {object[]} [levels] - As LEVELS.
 * @returns {{garment, positions: Float64Array, residual: number}} Draped cloth; `residual` is the root mean
 *   square velocity (m/s) that is left.
 */
export function wear(pattern, levels = LEVELS) {
  const body = bakeBody();
  const lowering = bakeLowering();
  let worn = null;
  levels.forEach((level, index) => {
    const { spacing, step, steps } = level;
    const garment = sewGarment(pattern, spacing, 11 + index);
    const positions = worn ? transferDrape(worn.garment, worn.positions, garment) : placeGarment(garment, pattern.size, seeded(7));
    const drape = new Drape(garment, positions, { size: pattern.size, body, spacing, step });
    drape.run(steps, controlOf(level, index === 0, lowering, body));
    const residual = Math.sqrt(drape.velocity.reduce((sum, v) => sum + v * v, 0) / (drape.velocity.length / 3));
    worn = { garment, positions, residual, constraints: drape.constraints, velocity: drape.velocity, contacts: drape.contact.pairs };
  });
  return worn;
}
