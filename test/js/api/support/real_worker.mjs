import { parentPort, workerData } from 'node:worker_threads';
import { createRenderer } from '../../../../js/index.mjs';

// Draws the same frame over and over on its own context, and tells of each.
const renderer = await createRenderer({ backend: workerData.backend ?? 'auto', cacheDirectory: null });
parentPort.postMessage('open');
for (let i = 0; i < workerData.frames; ++i) {
  const { data } = await renderer.render(workerData.model, workerData.shot);
  parentPort.postMessage(data);
}
await renderer.close();
