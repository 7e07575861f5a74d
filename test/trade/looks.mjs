import { chooseByWindow, openWindow } from '../../js/predict/probe.mjs';
import { SETTINGS } from '../../js/predict/settings.mjs';
import { MAX_ERRORS } from './judge.mjs';

/** Looks at windows of measured scenes: what the factors of js/predict/table.json are from, and what they are judged by. */

/** Of others the class says as much. */
const LOOKED_AT = ['draft', 'standard', 'medium', 'denoised 64/64', 'denoised 64/256', 'tracer 4', 'tracer 8'];

const DRAWN = { timeoutMs: null };

/** A scene as chooseByWindow takes it. */
async function opened(renderer, model, scene) {
  const draw = async (shot) => (await renderer.render(model, shot, DRAWN)).data;
  const { info } = await renderer.render(model, { ...scene.shot, quality: 'draft', output: { format: 'raw' } }, DRAWN);
  return { draw, resolved: info.shot };
}

/**
 * What a window shows of the settings that are looked at.
 * @param {import('../../js/trade/measure.mjs').Row[]} rows of the scene
 * @returns {Promise<import('../../js/predict/fit.mjs').Look[]>}
 */
export async function looksOf(renderer, model, scene, rows) {
  const { draw, resolved } = await opened(renderer, model, scene);
  const window = await openWindow(draw, resolved);
  const looks = [];
  for (const { setting, flip } of rows.filter((row) => LOOKED_AT.includes(row.setting)))
    looks.push({ setting, flip: await window.flipOf(SETTINGS[setting]), is: flip });
  return looks;
}

/**
 * What a renderer would choose for each error, and what it spends on looking: programs are there, as in a renderer that has drawn before.
 * @param {import('../../js/predict/choose.mjs').TradeTable} table
 * @param {import('../../js/predict/features.mjs').Features} features
 * @returns {Promise<Record<number, {setting: string, holds: boolean, flip: number, lookMs: number}>>} by error
 */
export async function answersOf(renderer, model, scene, table, features) {
  const { draw, resolved } = await opened(renderer, model, scene);
  const answers = {};
  for (const maxError of MAX_ERRORS) {
    let least = Infinity;
    let chosen;
    for (let run = 0; run < 2; run++) {
      const before = process.cpuUsage();
      chosen = await chooseByWindow(table, { maxError }, features, { tracer: true }, resolved, draw);
      const { user, system } = process.cpuUsage(before);
      least = Math.min(least, (user + system) / 1000);
    }
    const { setting, holds, flip } = chosen;
    answers[maxError] = { setting, holds, flip, lookMs: least };
  }
  return answers;
}
