import { CASE_ENVIRONMENT, shot } from './shot.mjs';

/**
 * A case.
 * @param {string} name
 * @param {string} model - Name in test/fixtures/index.mjs.
 * @param {string | null} environment - As Case.environment; null for none.
 * @param {object} [overrides] - Keys of the shot as shot() takes them; `environmentSettings` for {intensity, rotation}.
 * @param {boolean} [fast]
 * @returns {import('./cases.mjs').Case}
 */
export const makeCase = (name, model, environment, { environmentSettings, ...overrides } = {}, fast = false) => ({
  name,
  model,
  environment: environment ?? undefined,
  shot: shot({ environment: environment ? { map: CASE_ENVIRONMENT, ...environmentSettings } : 'none', ...overrides }),
  fast,
});
