import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { ROOT } from '../../machine/step.mjs';

// A bill of materials in CycloneDX 1.5: npm's own for the packages of JavaScript, what is bundled into js/dist, and the libraries of Debian whose
// code is in the addon.

/** Licences of those packages, by the names of SPDX. The texts are in the package, in licences/. */
export const LICENCES = {
  'libdraco-dev': 'Apache-2.0',
  'libglm-dev': 'MIT',
  'libtinygltf-dev': 'MIT',
  'nlohmann-json3-dev': 'MIT',
  libdeflate0: 'MIT',
  'libjpeg62-turbo': 'IJG AND BSD-3-Clause AND Zlib',
  libmeshoptimizer2d: 'MIT',
  libnettle8: 'LGPL-3.0-or-later OR GPL-2.0-or-later',
  'libpng16-16': 'libpng-2.0',
  libwebp7: 'BSD-3-Clause',
  libzstd1: 'BSD-3-Clause OR GPL-2.0-only',
  zlib1g: 'Zlib',
};

/** What js/dist holds of others; NOTICE says the same. The decoders come with three.js, without a version. */
const BUNDLED = [
  { name: 'three', npm: true, license: 'MIT' },
  { name: 'zod', npm: true, license: 'MIT' },
  { name: 'draco', purl: 'pkg:github/google/draco', license: 'Apache-2.0' },
  { name: 'basis_universal', purl: 'pkg:github/BinomialLLC/basis_universal', license: 'Apache-2.0' },
];

function bundledComponents() {
  const require = createRequire(import.meta.url);
  return BUNDLED.map(({ name, npm, purl, license }) => {
    const version = npm && JSON.parse(readFileSync(path.join(path.dirname(require.resolve('zod/package.json')), '..', name, 'package.json'), 'utf8')).version;
    const reference = npm ? `pkg:npm/${name}@${version}` : purl;
    return { 'bom-ref': reference, type: 'library', name, ...(version && { version }), purl: reference, licenses: [{ expression: license }] };
  });
}

/** What `npm sbom` says of this checkout, without what only develops it. */
function npmBill() {
  const args = ['sbom', '--omit', 'dev', '--sbom-format', 'cyclonedx'];
  return JSON.parse(execFileSync('npm', args, { cwd: ROOT, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }));
}

/**
 * The bill of telar and its compiled part.
 * @param {{name: string, version: string, architecture: string}[]} packages - Of Debian, whose code is in the compiled part.
 * @param {string} nativeName - Of the package that holds them.
 * @returns {object} CycloneDX 1.5.
 */
export const billOf = (packages, nativeName) => withParts(npmBill(), { packages, nativeName, bundled: bundledComponents() });

/**
 * @param {object} npm - What `npm sbom --sbom-format cyclonedx` says.
 * @param {{packages: {name: string, version: string, architecture: string}[], nativeName: string, bundled?: object[]}} parts - `packages` of Debian, in the package
 *   `nativeName`; `bundled`: components in js/dist.
 * @returns {object} CycloneDX 1.5.
 * @throws {Error} For a package without a licence above.
 */
export function withParts(npm, { packages, nativeName, bundled = [] }) {
  const components = packages.map(({ name, version, architecture }) => {
    if (!LICENCES[name]) throw new Error(`js/build/package/sbom.mjs has no licence for ${name}`);
    const purl = `pkg:deb/debian/${encodeURIComponent(name)}@${encodeURIComponent(version)}?arch=${architecture}`;
    return { 'bom-ref': purl, type: 'library', name, version, purl, licenses: [{ expression: LICENCES[name] }] };
  });
  const version = npm.metadata.component.version;
  const native = { 'bom-ref': `${nativeName}@${version}`, type: 'library', name: nativeName, version, purl: `pkg:npm/${nativeName}@${version}` };
  return {
    ...npm,
    // npm names it after its folder.
    metadata: { ...npm.metadata, component: { ...npm.metadata.component, name: 'telar' } },
    components: [...npm.components, ...bundled, native, ...components],
    dependencies: [
      ...npm.dependencies.map((entry) =>
        entry.ref === npm.metadata.component['bom-ref']
          ? { ...entry, dependsOn: [...(entry.dependsOn ?? []), ...bundled.map((component) => component['bom-ref']), native['bom-ref']] }
          : entry,
      ),
      { ref: native['bom-ref'], dependsOn: components.map((component) => component['bom-ref']) },
      ...[...bundled, ...components].map((component) => ({ ref: component['bom-ref'], dependsOn: [] })),
    ],
  };
}
