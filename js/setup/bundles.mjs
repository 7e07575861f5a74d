import { existsSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { ROOT, runLogged } from '../machine/step.mjs';

const JS = path.join(ROOT, 'js');
const SHADERS = path.join(ROOT, 'shaders');
const BUNDLER = path.join(JS, 'build/dist.mjs');

/** What no bundle is made of. */
const NO_SOURCE = /^(assets\/make|build\/(docs|package|site)|dist|docs|setup)\//;

/** Whether every source is older than the oldest bundle. */
export function bundlesFresh() {
  const dist = path.join(JS, 'dist');
  if (!existsSync(dist)) return false;
  const times = (folder, pattern) =>
    readdirSync(folder, { recursive: true })
      .filter((file) => pattern.test(file) && !NO_SOURCE.test(file))
      .map((file) => statSync(path.join(folder, file)).mtimeMs);
  const bundles = ['shading', 'types', 'zod.mjs'].every((name) => existsSync(path.join(dist, name))) ? times(dist, /\.cjs$/) : [];
  const sources = [...times(JS, /\.(mjs|d\.ts|json|css|html|svg|glsl)$/), ...times(SHADERS, /\.(glsl|frag|vert)$/)];
  return bundles.length > 0 && Math.max(...sources) <= Math.min(...bundles);
}

/**
 * Writes js/dist where a source is newer than it.
 * @returns {Promise<string>} What was done, in a few words.
 */
export async function ensureBundles(begin) {
  if (bundlesFresh()) return 'up to date';
  begin('bundling');
  await runLogged(process.execPath, [BUNDLER], { log: 'bundles.log', cure: 'npm ci --ignore-scripts, then the same command again' });
  return 'done';
}
