import { parentPort } from 'node:worker_threads';
import { difference, withinCoverage } from './metrics.mjs';
import { writePictures } from './pictures.mjs';
import { rasterizerDistances } from './rasterizers.mjs';

parentPort.on('message', async ({ id, name, pictures: drawn, second: drawnSecond }) => {
  try {
    const pictures = { ...drawn, expected: withinCoverage(drawn.expected) };
    const second = drawnSecond && withinCoverage(drawnSecond);
    const result = { difference: difference(pictures) };
    if (second) result.rasterizers = rasterizerDistances(pictures, second);
    await writePictures(name, pictures, second);
    parentPort.postMessage({ id, result });
  } catch (error) {
    parentPort.postMessage({ id, error });
  }
});
