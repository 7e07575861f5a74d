import { aptLine, listedPackages, missingPackages } from '../machine/debian.mjs';
import { runLogged, SetupError } from '../machine/step.mjs';

/** Whether the system's packages are nobody's business but the caller's: images of CI, production. */
const leavesSystemAlone = () => !['', '0', undefined].includes(process.env.TELAR_NO_SYSTEM);

/**
 * The commands that install packages: these very lists are printed, and run as root.
 * @param {string[]} names
 * @param {{root: boolean, terminal: boolean}} who
 * @returns {string[][]}
 */
export function rootCommands(names, { root, terminal }) {
  // Without a terminal nobody can type a password: -n makes sudo fail instead of waiting for one.
  const sudo = terminal ? ['sudo'] : ['sudo', '-n'];
  const options = ['-y', '-q', '-o', 'DPkg::Lock::Timeout=300', '-o', 'Acquire::Retries=3'];
  const apt = [...(root ? [] : sudo), 'env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get', ...options];
  return [
    [...apt, 'update'],
    [...apt, 'install', '--no-install-recommends', ...names],
  ];
}

/**
 * Installs the missing packages of these groups. Asks no question; needs root or sudo. Each line that is run as root is printed
 * before the first of them runs; with TELAR_NO_SYSTEM=1 they are printed alone.
 * @returns {Promise<string>} What was done, in a few words.
 * @throws {SetupError} With the cure: no root, TELAR_NO_SYSTEM, what apt-get says.
 */
export async function ensureDebianPackages(groups, begin) {
  const names = listedPackages(groups);
  const missing = missingPackages(names);
  if (missing === null) return `this is not Debian; on your own: the equivalents of ${names.join(' ')}`;
  if (missing.length === 0) return `all ${names.length} present`;

  const commands = rootCommands(missing, { root: process.getuid() === 0, terminal: process.stdin.isTTY === true });
  for (const command of commands) process.stderr.write(`as root: ${command.join(' ')}\n`);
  const cure = `run this, then the same command again:\n    ${aptLine(missing)}`;
  if (leavesSystemAlone()) throw new SetupError(`${missing.length} Debian packages are missing, and TELAR_NO_SYSTEM is set: nothing was run`, { cure });
  begin(`installing ${missing.length} of ${names.length} (${missing.join(' ')})`);
  const logs = ['apt-update.log', 'apt-install.log'];
  for (const [i, [program, ...args]] of commands.entries()) await runLogged(program, args, { log: logs[i], cure });
  const still = missingPackages(names);
  if (still.length) throw new SetupError(`apt-get installed without an error, yet these are missing: ${still.join(' ')}`, { cure });
  return 'done';
}
