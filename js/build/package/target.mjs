// What a machine's architecture is called by Node, Debian and GCC.

const NAMES = {
  x64: { debian: 'amd64', triple: 'x86_64-linux-gnu' },
  arm64: { debian: 'arm64', triple: 'aarch64-linux-gnu' },
};

/**
 * @typedef {{arch: string, debian: string, triple: string, preset: string, packageName: string, tool: (name: string) => string}} Target
 *   preset: of CMakePresets.json; tool: a program of GCC or binutils that reads or makes files of this architecture
 */

/**
 * @param {string} [arch] - As process.arch
 * @returns {Target}
 */
export function targetOf(arch = process.arch) {
  if (!NAMES[arch]) throw new Error(`no package for ${arch}: one of ${Object.keys(NAMES).join(', ')}`);
  const isOwn = arch === process.arch;
  const tool = (name) => (isOwn ? name : `${NAMES[arch].triple}-${name}`);
  return { arch, ...NAMES[arch], preset: isOwn ? 'release' : `release-${arch}`, packageName: `telar-linux-${arch}`, tool };
}
