import { statSync, existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

const ROOT = new URL('../../..', import.meta.url).pathname;

/**
 * Path of the C++ tool that runs telar's image code from the command line: in TELAR_BUILD_DIR, else the newest one
 * under out/.
 * @throws {Error} when no build has it.
 */
export function imageTool() {
  const folders = process.env.TELAR_BUILD_DIR
    ? [process.env.TELAR_BUILD_DIR]
    : existsSync(join(ROOT, 'out'))
      ? readdirSync(join(ROOT, 'out')).map((name) => join(ROOT, 'out', name))
      : [];
  const tools = folders.map((folder) => join(folder, 'bin/image_tool')).filter((path) => existsSync(path));
  if (!tools.length) throw new Error('image_tool is not built; run: cmake --preset dev && cmake --build --preset dev');
  return tools.sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs)[0];
}
