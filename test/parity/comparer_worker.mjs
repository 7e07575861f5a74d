import { parentPort } from 'node:worker_threads';
import { difference } from './metrics.mjs';
import { writePictures } from './pictures.mjs';
import { rasterizerDistances } from './rasterizers.mjs';

parentPort.on('message', async ({ id, name, pictures, second }) => {
  try {
    const result = { difference: difference(pictures) };
    if (second) result.rasterizers = rasterizerDistances(pictures, second);
    await writePictures(name, pictures, second);
    parentPort.postMessage({ id, result });
  } catch (error) {
    parentPort.postMessage({ id, error });
  }
});
