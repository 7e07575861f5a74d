import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { parse, parseAllDocuments } from 'yaml';

// The compose file and the manifests of js/docs/queue.md: YAML, with flags that the commands have, and a metric that the service tells.

const ROOT = new URL('../../../', import.meta.url);
const PAGE = readFileSync(new URL('js/docs/queue.md', ROOT), 'utf8');
const METRICS = readFileSync(new URL('js/server/metrics.mjs', ROOT), 'utf8');
const BIN = fileURLToPath(new URL('js/cli/telar.mjs', ROOT));

const HELP = Object.fromEntries(['serve', 'worker'].map((name) => [name, execFileSync(BIN, [name, '--help'], { encoding: 'utf8' })]));

function faultsOf(page) {
  const [compose, manifests] = [...page.matchAll(/```yaml\n([\s\S]*?)```/g)].map(([, text]) => text);
  const { services } = parse(compose);
  const objects = parseAllDocuments(manifests).map((document) => document.toJS());
  const containers = objects.flatMap(({ spec }) => spec.template?.spec.containers ?? []);
  const commands = [...Object.values(services).map(({ image, command }) => ({ image, args: command })), ...containers].filter(({ image }) => image === 'telar');
  const faults = commands.flatMap(({ args: [name, ...flags] }) =>
    flags.filter((flag) => flag.startsWith('--') && !HELP[name].includes(`${flag} `)).map((flag) => `${name} has no ${flag}`),
  );
  const { command: redis } = services.redis;
  if (redis[redis.indexOf('--maxmemory-policy') + 1] !== 'noeviction' || redis[redis.indexOf('--appendonly') + 1] !== 'yes') faults.push('Redis may lose jobs');
  const scaled = objects.find(({ kind }) => kind === 'ScaledObject');
  const targets = objects.filter(({ kind }) => kind === 'Deployment').map(({ metadata }) => metadata.name);
  if (!targets.includes(scaled.spec.scaleTargetRef.name)) faults.push('what is scaled is not there');
  const [, metric] = /\((\w+)\{/.exec(scaled.spec.triggers[0].metadata.query);
  if (!METRICS.includes(`'${metric}'`)) faults.push('no such metric');
  if (commands.length !== 4) faults.push(`${commands.length} commands`);
  return faults;
}

test('the files of the page are in order, and planted faults are told', () => {
  assert.deepEqual(faultsOf(PAGE), []);
  for (const [right, wrong, told] of [
    ['--no-draw-jobs, --workers', '--no-jobs, --workers', 'serve has no --no-jobs'],
    ['--maxmemory-policy, noeviction', '--maxmemory-policy, allkeys-lru', 'Redis may lose jobs'],
    ['scaleTargetRef: { name: telar-worker }', 'scaleTargetRef: { name: telar-work }', 'what is scaled is not there'],
    ['max(telar_queue{', 'max(telar_depth{', 'no such metric'],
  ]) {
    assert.deepEqual(faultsOf(PAGE.replace(right, () => wrong)), [told]);
  }
});
