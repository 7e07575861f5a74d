// A bill of materials in CycloneDX 1.5: npm's own for the packages of JavaScript, and the libraries of Debian whose code is in the addon.

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

/**
 * @param {object} npm - What `npm sbom --sbom-format cyclonedx` says.
 * @param {{name: string, version: string}[]} packages - Of Debian.
 * @param {string} nativeName - Of the package that holds them.
 * @returns {object} CycloneDX 1.5.
 * @throws {Error} For a package without a licence above.
 */
export function withNative(npm, packages, nativeName) {
  const components = packages.map(({ name, version }) => {
    if (!LICENCES[name]) throw new Error(`js/build/package/sbom.mjs has no licence for ${name}`);
    const purl = `pkg:deb/debian/${encodeURIComponent(name)}@${encodeURIComponent(version)}`;
    return { 'bom-ref': purl, type: 'library', name, version, purl, licenses: [{ expression: LICENCES[name] }] };
  });
  const version = npm.metadata.component.version;
  const native = { 'bom-ref': `${nativeName}@${version}`, type: 'library', name: nativeName, version, purl: `pkg:npm/${nativeName}@${version}` };
  return {
    ...npm,
    // npm names it after its folder.
    metadata: { ...npm.metadata, component: { ...npm.metadata.component, name: 'telar' } },
    components: [...npm.components, native, ...components],
    dependencies: [
      ...npm.dependencies.map((entry) =>
        entry.ref === npm.metadata.component['bom-ref'] ? { ...entry, dependsOn: [...(entry.dependsOn ?? []), native['bom-ref']] } : entry,
      ),
      { ref: native['bom-ref'], dependsOn: components.map((component) => component['bom-ref']) },
      ...components.map((component) => ({ ref: component['bom-ref'], dependsOn: [] })),
    ],
  };
}
