import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import path from 'node:path';
import { expanded } from './dockerfile.mjs';
import { addNode, KEPT, PROXY, system } from '../../js/setup/bare_system.mjs';

// Stages of a Dockerfile as folders: each an overlay over its base, made by the stage's own lines. As root, in a mount namespace of its own.

const bash = (text, options) => execFileSync('bash', ['-euc', text], { stdio: ['ignore', 'ignore', 'inherit'], ...options });
const inside = (root, text, env) => execFileSync('chroot', [root, '/bin/sh', '-c', text], { stdio: ['ignore', 'ignore', 'inherit'], env });
const PATH = '/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin';

/** What node:VERSION-RELEASE[-slim] is: Debian, Node, npm, and the user `node`. @returns {string} Folder */
function base(image) {
  const [, version, release] = /^node:(\d+)-([a-z]+?)(?:-slim)?$/.exec(image) ?? [];
  if (!version) throw new Error(`FROM ${image}: only node:VERSION-RELEASE and its slim form are known here`);
  const folder = system(release, [], `node-${version}-${release}`);
  addNode(folder, version);
  inside(folder, 'id node > /dev/null 2>&1 || useradd --uid 1000 --user-group --create-home node');
  return folder;
}

/** A folder with what is written on top of another one. @returns {string} */
function overlay(lower, folder) {
  rmSync(folder, { recursive: true, force: true });
  const [upper, work, root] = ['upper', 'work', 'root'].map((name) => path.join(folder, name));
  for (const each of [upper, work, root]) mkdirSync(each, { recursive: true });
  bash(`mount -t overlay overlay -o lowerdir=${lower},upperdir=${upper},workdir=${work} ${root}
    mount -t proc proc ${root}/proc; mount --rbind /dev ${root}/dev`);
  return root;
}

/** What .dockerignore leaves of the checkout, copied as `COPY . TO` does. Its lines are names at the top, where `*` is no `/`. */
function copyContext(context, to) {
  const ignored = readFileSync(path.join(context, '.dockerignore'), 'utf8')
    .split('\n')
    .filter((line) => line && !line.startsWith('#'));
  const excludes = ignored.map((line) => `--exclude='./${line}'`).join(' ');
  bash(`mkdir -p ${to}; tar -C ${context} --anchored --wildcards --no-wildcards-match-slash ${excludes} -cf - . | tar -C ${to} --no-same-owner -xf -`);
}

/** `COPY --from`: the content of a folder, or files. */
function copyFrom(from, sources, to) {
  for (const source of sources) {
    bash(
      `mkdir -p ${to}; for each in ${from}${source.replace(/\/$/, '')}; do if [ -d "$each" ]; then cp -a "$each/." ${to}; else cp -a "$each" ${to}; fi; done`,
    );
  }
}

/**
 * Makes a stage, and those that it takes from.
 * @param {import('./dockerfile.mjs').Stage} stage
 * @param {{stages: import('./dockerfile.mjs').Stage[], made: Map<string, object>, context: string}} build - made: what stands, by name
 * @returns {{root: string, config: {env: object, user: string, cwd: string, entrypoint: string[], command: string[], healthcheck: string[]}}}
 */
export function make(stage, build) {
  const stands = build.made.get(stage.name);
  if (stands) return stands;
  const folder = path.join(KEPT, 'stages', stage.name);
  const root = stage.from === 'scratch' ? emptied(folder) : overlay(base(stage.from), folder);
  const config = { env: { PATH }, user: '0:0', cwd: '/', entrypoint: [], command: [], healthcheck: [] };
  const variables = {};
  const at = (name) => path.join(root, path.resolve(config.cwd, name));
  for (const { keyword, text, flags, words, variables: own } of stage.steps) {
    const started = performance.now();
    if (keyword === 'RUN') inside(root, `cd ${config.cwd} && ${text}`, { ...PROXY, ...variables, ...config.env });
    else if (keyword === 'COPY' && flags.from) copyFrom(make(stageOf(flags.from, build), build).root, words.slice(0, -1), at(words.at(-1)));
    else if (keyword === 'COPY' && words[0] === '.') copyContext(build.context, at(words[1]));
    else if (keyword === 'ENV') for (const [name, value] of Object.entries(own)) config.env[name] = expanded(value, { ...variables, ...config.env });
    else if (keyword === 'ARG') Object.assign(variables, own);
    else if (keyword === 'USER') config.user = words[0];
    else if (keyword === 'WORKDIR') mkdirSync(at((config.cwd = path.resolve(config.cwd, words[0]))), { recursive: true });
    else if (keyword === 'ENTRYPOINT') config.entrypoint = words;
    else if (keyword === 'CMD') config.command = words;
    else if (keyword === 'HEALTHCHECK') config.healthcheck = words;
    else if (keyword !== 'EXPOSE') throw new Error(`${keyword} is not known here`);
    if (/RUN|COPY/.test(keyword))
      console.log(`${stage.name}: ${keyword} ${text.split('\n')[0].slice(0, 90)} (${((performance.now() - started) / 1000).toFixed(1)} s)`);
  }
  build.made.set(stage.name, { root, config });
  return { root, config };
}

function emptied(folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  return folder;
}

function stageOf(name, { stages }) {
  const stage = stages.find((each) => each.name === name);
  if (!stage) throw new Error(`no stage ${name}`);
  return stage;
}
