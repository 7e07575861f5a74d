import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { parse } from 'yaml';
import { COMMANDS } from '../../../js/cli/commands.mjs';
import { buildProgram } from '../../../js/cli/program.mjs';
import { listedPackages } from '../../../js/machine/debian.mjs';
import { stagesOf } from '../../install/dockerfile.mjs';

// What can be told of the Dockerfile without running it. test/install/image.mjs runs it.

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const read = (file) => readFileSync(path.join(ROOT, file), 'utf8');
const DOCKERFILE = read('Dockerfile');
const COMPOSE = read('compose.yaml');
const IGNORED = read('.dockerignore');

/** The other way to draw: one that EGL makes needless in an image. */
const LEFT_OUT = ['libosmesa6'];

function faultsOf({ dockerfile = DOCKERFILE, compose = COMPOSE, ignored = IGNORED }) {
  const stages = stagesOf(dockerfile);
  const { steps } = stages.at(-1);
  const last = (keyword) => steps.findLast((step) => step.keyword === keyword);
  const service = parse(compose).services.telar;
  const installed = steps
    .filter(({ keyword }) => keyword === 'RUN')
    .flatMap(({ text }) => [...text.matchAll(/apt-get install ([^&]+)/g)])
    .flatMap(([, names]) => names.split(/[\s\\]+/));
  const names = stages.map(({ name }) => name);
  const lines = ignored.split('\n');
  const wanted = listedPackages(['run']).filter((name) => !LEFT_OUT.includes(name));
  const built = listedPackages(['build', 'test', 'lint', 'fuzz']);
  const serve = buildProgram('0', COMMANDS, () => {}, {}).commands.find((command) => command.name() === last('CMD').words[0]);
  return [
    [stages.filter(({ from }) => from !== 'scratch' && !/^node:\d+-bookworm(-slim)?$/.test(from)), 'a base image that is not Debian 12 with a version of Node'],
    [stages.flatMap((stage) => stage.steps).filter(({ flags }) => flags.from && !names.includes(flags.from)), 'copied from a stage that is not there'],
    [stages.flatMap((stage) => stage.steps).filter(({ keyword }) => keyword === 'ADD'), 'ADD fetches'],
    [wanted.filter((name) => !installed.includes(name)), 'a package that drawing needs is missing'],
    [installed.filter((name) => built.includes(name) && name !== 'fonts-dejavu-core'), 'a package that only compiling or testing needs'],
    [/^[1-9]\d*:[1-9]\d*$/.test(last('USER')?.text) ? [] : ['USER'], 'no user by number'],
    [steps.slice(steps.indexOf(last('USER'))).filter(({ keyword }) => keyword === 'RUN'), 'run by a user that is not root'],
    [
      serve
        ? last('CMD')
            .words.slice(1)
            .filter((word) => word.startsWith('--') && !serve.options.some(({ long }) => long === word))
        : ['CMD'],
      'no such command',
    ],
    [
      service.read_only === true && service.cap_drop?.includes('ALL') && service.security_opt?.includes('no-new-privileges:true') ? [] : ['rights'],
      'not locked',
    ],
    [service.tmpfs?.some((entry) => entry.startsWith('/tmp:')) ? [] : ['tmpfs'], 'nowhere to write'],
    [service.ports.filter((port) => !port.startsWith('127.0.0.1:')), 'a port that the network sees'],
    [['.git', 'node_modules', 'out', 'build', 'js/dist', '*.tgz'].filter((name) => !lines.includes(name)), 'of this machine, and sent to the builder'],
  ]
    .filter(([found]) => found.length)
    .map(([, fault]) => fault);
}

test('the Dockerfile, compose.yaml and .dockerignore are in order', () => assert.deepEqual(faultsOf({}), []));

test('planted faults are found, one each', () => {
  const planted = [
    [{ dockerfile: DOCKERFILE.replace('USER 1000:1000', 'USER node') }, 'no user by number'],
    [{ dockerfile: DOCKERFILE.replace('libgles2', '') }, 'a package that drawing needs is missing'],
    [{ dockerfile: DOCKERFILE.replace('libgles2', 'libgles2 g++') }, 'a package that only compiling or testing needs'],
    [{ dockerfile: DOCKERFILE.replace('--from=app', '--from=apps') }, 'copied from a stage that is not there'],
    [
      { dockerfile: DOCKERFILE.replace('FROM node:${NODE}-bookworm-slim\n#', 'FROM node:latest\n#') },
      'a base image that is not Debian 12 with a version of Node',
    ],
    [{ dockerfile: DOCKERFILE.replace('"--host"', '"--address"') }, 'no such command'],
    [{ dockerfile: `${DOCKERFILE}RUN true\n` }, 'run by a user that is not root'],
    [{ dockerfile: DOCKERFILE.replace('WORKDIR /tmp', 'ADD https://example.com/a /tmp') }, 'ADD fetches'],
    [{ compose: COMPOSE.replace('read_only: true', '') }, 'not locked'],
    [{ compose: COMPOSE.replace('/tmp:size', '/var:size') }, 'nowhere to write'],
    [{ compose: COMPOSE.replace('127.0.0.1:8080:', '8080:') }, 'a port that the network sees'],
    [{ ignored: IGNORED.replace('node_modules\n', '') }, 'of this machine, and sent to the builder'],
  ];
  for (const [texts, fault] of planted) assert.deepEqual(faultsOf(texts), [fault]);
});
