import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { cppFiles } from './cpp.mjs';
import { shaderFiles } from './glsl.mjs';

// Writes what js/material/table.mjs says as C++ and GLSL: node js/build/material/index.mjs FOLDER. CMake calls it.

const [folder] = process.argv.slice(2);
const files = { renderer: cppFiles(), shaders: shaderFiles() };
for (const [part, texts] of Object.entries(files)) {
  for (const [name, text] of Object.entries(texts)) {
    const file = path.join(folder, part, name);
    // A file that stays as it is compiles nothing anew.
    if (existsSync(file) && readFileSync(file, 'utf8') === text) continue;
    mkdirSync(path.dirname(file), { recursive: true });
    writeFileSync(file, text);
  }
}
