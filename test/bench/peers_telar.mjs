// telar's side of test/bench/peers.mjs: a process that draws when asked, and says what that took. A process that talks to a browser has
// other work, which its CPU time would hold.
import { createRenderer } from '../../js/index.mjs';

/** Pictures on their way at once, where many are asked for: one is drawn while another is decoded or encoded. */
const IN_FLIGHT = 3;

const renderer = await createRenderer();
const works = {
  one: ({ model, shot }) => renderer.render(model, shot),
  views: ({ model, shots }) => renderer.renderAll(model, shots),
  async turn({ models, shot, rounds }) {
    const left = Array.from({ length: rounds }, () => models).flat();
    const draw = async () => {
      for (let model = left.shift(); model; model = left.shift()) await renderer.render(model, shot);
    };
    await Promise.all(Array.from({ length: IN_FLIGHT }, draw));
  },
};
process.on('message', async ({ work = 'one', ...asked }) => {
  const [before, start] = [process.cpuUsage(), performance.now()];
  await works[work](asked);
  const { user, system } = process.cpuUsage(before);
  process.send({ cpu: (user + system) / 1000, wall: performance.now() - start });
});
process.on('disconnect', () => renderer.close());
process.send('ready');
