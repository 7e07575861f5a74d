import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { readShotOptions } from './shot_options.mjs';

const NAMES = { key: 'TELAR_SIGN_KEY', salt: 'TELAR_SIGN_SALT' };
const usage = (message) => new TelarError('E_USAGE', message);

/**
 * Keys of signed addresses from the environment, where no list of processes shows them. Several, with commas between, are for rotation: the first signs.
 * @param {NodeJS.ProcessEnv} env
 * @returns {{key: string, salt: string}[]}
 * @throws {TelarError} E_USAGE
 */
export function signingKeysOf(env) {
  const [keys, salts] = [NAMES.key, NAMES.salt].map((name) => (env[name] ? env[name].split(',').map((text) => text.trim()) : []));
  if (keys.length !== salts.length) throw usage(`${NAMES.key} and ${NAMES.salt}: expected as many keys as salts, got ${keys.length} and ${salts.length}`);
  return keys.map((key, i) => ({ key, salt: salts[i] }));
}

/**
 * telar sign MODEL
 * Prints an address that `telar serve` with the same key draws on GET.
 * @param {string} model reference
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} 0
 */
export async function sign(model, options, context) {
  const [pair] = signingKeysOf(process.env);
  if (!pair) throw usage(`expected key and salt in ${NAMES.key} and ${NAMES.salt}, in hexadecimal, as \`openssl rand -hex 32\` makes them`);
  const shot = await readShotOptions(options, context, { isLocal: false });
  const expires = expiresOf(options.expires);
  // What no service would draw is told now.
  const { shotIdentity } = await import('../shot/identity.mjs');
  shotIdentity(shot);
  const { signThumbnail } = await import('../server/signature.mjs');
  const asked = { ...(Object.keys(shot).length > 0 && { shot }), ...(expires !== undefined && { expires }) };
  const url = `${options.url.replace(/\/$/, '')}${signThumbnail(model, asked, pair)}`;
  await context.console.result({ ok: true, url, ...(expires !== undefined && { expires }) }, [url]);
  return 0;
}

function expiresOf(seconds) {
  if (seconds === undefined) return undefined;
  if (!/^\d{1,10}$/.test(seconds)) throw usage(`--expires: expected whole seconds, got ${shown(seconds)}`);
  return Math.floor(Date.now() / 1000) + Number(seconds);
}
