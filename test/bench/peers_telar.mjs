// telar's side of test/bench/peers.mjs: a process that draws when asked, and says what that took. A process that talks to a browser has
// other work, which its CPU time would hold.
import { createRenderer } from '../../js/index.mjs';

const renderer = await createRenderer();
process.on('message', async ({ model, shot }) => {
  const [before, start] = [process.cpuUsage(), performance.now()];
  await renderer.render(model, shot);
  const { user, system } = process.cpuUsage(before);
  process.send({ cpu: (user + system) / 1000, wall: performance.now() - start });
});
process.on('disconnect', () => renderer.close());
process.send('ready');
