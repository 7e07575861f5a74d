// telar's side of test/bench/peers.mjs: a process that draws when asked, and says what that took. A process that talks to a browser has
// other work, which its CPU time would hold.
import { createRenderer } from '../../js/index.mjs';

const renderer = await createRenderer();
const works = {
  one: ({ model, shot }) => renderer.render(model, shot),
  views: ({ model, shots }) => renderer.renderAll(model, shots),
};
process.on('message', async ({ work = 'one', ...asked }) => {
  const [before, start] = [process.cpuUsage(), performance.now()];
  await works[work](asked);
  const { user, system } = process.cpuUsage(before);
  process.send({ cpu: (user + system) / 1000, wall: performance.now() - start });
});
process.on('disconnect', () => renderer.close());
process.send('ready');
