// three.js's own Basis Universal transcoder (WebAssembly), run here: what KTX2Loader would hand to WebGL uncompressed.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

const FOLDER = fileURLToPath(new URL('../../../node_modules/three/examples/jsm/libs/basis/', import.meta.url));
const RGBA32 = 13;

let pending;

function load() {
  pending ??= (async () => {
    const script = readFileSync(`${FOLDER}basis_transcoder.js`, 'utf8');
    // The file is a classic script that leaves one global.
    const BASIS = new Function('require', '__dirname', '__filename', 'module', `${script}; return BASIS;`)(
      createRequire(import.meta.url),
      FOLDER,
      `${FOLDER}basis_transcoder.js`,
      {},
    );
    const module = await BASIS({ wasmBinary: readFileSync(`${FOLDER}basis_transcoder.wasm`) });
    module.initializeBasis();
    return module;
  })();
  return pending;
}

/**
 * @param {Uint8Array} bytes a KTX2 file
 * @returns {Promise<{width: number, height: number, pixels: Uint8Array}[] | null>} its levels as RGBA8; null where the
 *   transcoder refuses it
 */
export async function referenceLevels(bytes) {
  const { KTX2File } = await load();
  const file = new KTX2File(new Uint8Array(bytes));
  try {
    if (!file.isValid() || !file.startTranscoding()) return null;
    const levels = [];
    for (let level = 0; level < file.getLevels(); ++level) {
      const { origWidth: width, origHeight: height } = file.getImageLevelInfo(level, 0, 0);
      const pixels = new Uint8Array(file.getImageTranscodedSizeInBytes(level, 0, 0, RGBA32));
      if (!file.transcodeImage(pixels, level, 0, 0, RGBA32, 0, -1, -1)) return null;
      levels.push({ width, height, pixels });
    }
    return levels;
  } finally {
    file.close();
    file.delete();
  }
}
