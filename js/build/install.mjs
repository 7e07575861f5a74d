import { spawnSync } from 'node:child_process';
import path from 'node:path';
import { main, ROOT, runShown } from '../machine/step.mjs';

// What npm runs on `npm install` and `npm ci`. node-gyp is told to take addon/gyp for Node's header folder, so that it
// downloads nothing; npm takes package.json's config for that from a checkout, but not from a lock file, hence this hook.
// Where node-gyp's own needs (python3, make) are missing, CMake is called without it.

const NODE_GYP = process.env.npm_config_node_gyp;
const runs = (program) => spawnSync(program, ['--version'], { stdio: 'ignore' }).status === 0;

await main(() =>
  NODE_GYP && runs('python3') && runs('make')
    ? runShown(process.execPath, [NODE_GYP, 'rebuild', `--nodedir=${path.join(ROOT, 'addon/gyp')}`, '--force-process-config'])
    : runShown(process.execPath, [path.join(ROOT, 'js/build/addon.mjs')]),
);
