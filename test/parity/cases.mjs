/**
 * One picture that the browser and the server both draw.
 * @typedef {object} Case
 * @property {string} name - Also the file name of its report.
 * @property {string} model - Name in test/fixtures/index.mjs, a path beneath `bundled:` (js/assets) or `shared:` (../shared/models), or
 *   `random:` or `random-cloth:` and the seed of a scene of test/fixtures/random_scene.mjs.
 * @property {string} [environment] - Name in test/fixtures/index.mjs, `studio`, or `shared:` and a path; needed where the
 *   shot has an environment.
 * @property {object} shot - Resolved shot.
 * @property {'uncompressed'} [textures] - Keeps three.js from transcoding KTX2 to a GPU format, which loses a little.
 * @property {string[]} [traits] - What decides whether an older release of three.js shows the model: test/families/gate.mjs. The case's name unless given.
 * @property {'none'} [failOn] - As telar's option: the file has faults that three.js draws without.
 * @property {boolean} [fast] - Part of the subset that `npm test` draws.
 * @property {boolean} [extended] - Drawn by `--all` only: shows nothing that another case does not.
 */

/** Files of this folder that export `CASES`, one line each. */
const FILES = [
  'cases_core.mjs',
  'cases_broken.mjs',
  'cases_decoders.mjs',
  'cases_files.mjs',
  'cases_pairs.mjs',
  'cases_motion.mjs',
  'cases_physical.mjs',
  'cases_area.mjs',
  'cases_transmission.mjs',
  'cases_shadow.mjs',
  'cases_framing.mjs',
  'cases_shading.mjs',
  'cases_materials.mjs',
  'cases_metering.mjs',
];

const modules = await Promise.all(FILES.map((file) => import(`./${file}`)));

/** @type {Case[]} */
export const CASES = modules.flatMap((module) => module.CASES);

/** The gate: all but the extended set. */
export const GATE_CASES = CASES.filter(({ extended }) => !extended);
