import { after, before, test } from 'node:test';
import { JOB_CHECKS, JOB_OPTIONS, recording } from './job_checks.mjs';
import { MODELS, SHOT, openPool, serve } from './support.mjs';

// Jobs: asked for now, fetched later.

let real, about, service;
const others = [];
before(async () => {
  const [opened, glb] = await Promise.all([openPool(), MODELS.cloth()]);
  real = opened;
  const pool = recording(real);
  service = await serve({ pool, ...JOB_OPTIONS });
  const own = async (options) => {
    others.push(await serve({ pool, ...options }));
    return others.at(-1);
  };
  about = { url: service.url, pool, serve: own, glb, drawn: (await real.render(glb, SHOT)).data };
});
after(async () => {
  await Promise.all([service, ...others].map((one) => one.drain()));
  await real.close();
});

for (const [name, check] of Object.entries(JOB_CHECKS)) test(name, () => check(about));
