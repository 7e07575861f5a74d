import { parentPort, workerData } from 'node:worker_threads';
import { SHOT, model, openRenderer } from './double.mjs';

// One renderer in a worker: says when it is open, draws what it is told to, and says what came out.
const renderer = await openRenderer();
parentPort.postMessage('open');
const { data } = await renderer.render(model(workerData.plan), SHOT);
if (workerData.close) await renderer.close();
parentPort.postMessage(data.length);
