import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { FAMILIES, shadingText, textureShaders } from './translate.mjs';

// Writes js/dist/shading: the text of shaders/ as js/three hands it to three.js, one module for each family of shadings.

const OUT = fileURLToPath(new URL('../../dist/shading/', import.meta.url));

/** Name of the module that knows the others, and of the fabrics' presets. */
const INDEX = 'index';
const PRESETS = 'presets';

/** Of the shaders that make textures anew. */
const TEXTURE = 'texture';

const PRESET_FILE = new URL('../../assets/fabric_presets.json', import.meta.url);

const fabricPresets = () =>
  Object.fromEntries(Object.entries(JSON.parse(readFileSync(PRESET_FILE, 'utf8'))).map(([name, { material }]) => [name, { material }]));

/** @returns {string} The module of one family, of the presets, of the texture shaders, or of the index of all: each is fetched when first asked for. */
export function shadingModule(family) {
  if (family === INDEX) {
    return `// Written by js/build/shading.\nexport const TEXTS = {\n${[...FAMILIES, PRESETS, TEXTURE].map((name) => `  ${name}: () => import('./${name}.mjs'),\n`).join('')}};\n`;
  }
  if (family === PRESETS) return `// Written by js/build/shading.\nexport const PRESETS = ${JSON.stringify(fabricPresets())};\n`;
  const entries = Object.entries(family === TEXTURE ? textureShaders() : shadingText(family)).map(
    ([name, value]) => `export const ${name} = ${JSON.stringify(value)};\n`,
  );
  return `// Written by js/build/shading from shaders/.\n${entries.join('')}`;
}

export function buildShading() {
  mkdirSync(OUT, { recursive: true });
  for (const family of [INDEX, PRESETS, TEXTURE, ...FAMILIES]) writeFileSync(path.join(OUT, `${family}.mjs`), shadingModule(family));
}
