import { execFileSync } from 'node:child_process';
import { copyFileSync, cpSync, existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

// Bare systems of Debian, made once. As root, with debootstrap and a network.

/** Not under out/: tools that walk the checkout follow the links of a system. */
export const KEPT = path.join(tmpdir(), 'telar-bare');
/** The one in which js/setup/package_arm64.mjs compiles. */
export const CROSS_SYSTEM = 'bookworm-cross-arm64';

const CERTIFICATES = '/etc/ssl/certs/ca-certificates.crt';

/** What a proxy in between needs, as `docker build` hands it over too. */
export const PROXY = Object.fromEntries(Object.entries(process.env).filter(([name]) => /^(https?|no)_proxy$/i.test(name) || name === 'NODE_EXTRA_CA_CERTS'));

/**
 * @param {string} release - As bookworm
 * @param {string[]} packages - Installed beside those of a minimal system
 * @param {string} [name] - Of the folder
 * @returns {string} Folder
 */
export function system(release, packages, name = release) {
  const folder = path.join(KEPT, name);
  if (existsSync(path.join(folder, '.made'))) return folder;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  execFileSync('debootstrap', ['--variant=minbase', release, folder, 'http://deb.debian.org/debian'], { stdio: 'ignore' });
  copyFileSync('/etc/resolv.conf', path.join(folder, 'etc/resolv.conf'));
  execFileSync('chroot', [folder, 'apt-get', 'install', '-y', '--no-install-recommends', 'ca-certificates', ...packages], { stdio: 'ignore' });
  // A proxy in between has an authority of its own.
  copyFileSync(CERTIFICATES, path.join(folder, CERTIFICATES));
  writeFileSync(path.join(folder, '.made'), '');
  return folder;
}

const NPM = '#!/bin/sh\nexec node /opt/npm/bin/npm-cli.js "$@"\n';

/** Puts Node of a version and npm into a system. @returns {string} The version in full. */
export function addNode(folder, version) {
  const kept = path.join(KEPT, `node-${version}`);
  if (!existsSync(kept)) execFileSync('npm', ['install', '--silent', '--prefix', kept, `node@${version}`, 'npm@10'], { stdio: 'ignore' });
  copyFileSync(path.join(kept, 'node_modules/node/bin/node'), path.join(folder, 'usr/bin/node'));
  cpSync(path.join(kept, 'node_modules/npm'), path.join(folder, 'opt/npm'), { recursive: true, force: true, verbatimSymlinks: true });
  writeFileSync(path.join(folder, 'usr/local/bin/npm'), NPM, { mode: 0o755 });
  return execFileSync('chroot', [folder, 'node', '--version'], { encoding: 'utf8' }).trim();
}
