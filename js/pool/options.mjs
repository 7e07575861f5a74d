import { checkObject, count, RENDERER_KEYS, rendererOptions, wrongOption } from '../api/options.mjs';
import { Cgroup } from './cgroup.mjs';
import { DEFAULTS, defaultSize } from './defaults.mjs';

const POOL_KEYS = ['size', ...Object.keys(DEFAULTS)];
/** More workers than a machine has cores. */
const MOST_WORKERS = 1024;

/**
 * Options of createPool with every default written out.
 * @param {object} options see js/pool/index.d.ts
 * @param {string[]} limitNames
 */
export function poolOptions(options, limitNames) {
  checkObject('options', options, [...POOL_KEYS, ...RENDERER_KEYS]);
  const renderer = rendererOptions(Object.fromEntries(Object.entries(options).filter(([key]) => RENDERER_KEYS.includes(key))), limitNames);
  const { memoryBytes, cpuMs, outputBytes, quarantineMs, recycleJobs, recycleBytes, modelBytes, cgroup } = { ...DEFAULTS, ...defined(options) };
  const bound = {
    memoryBytes: count('options.memoryBytes', memoryBytes, 1),
    cpuMs: cpuMs === null ? null : count('options.cpuMs', cpuMs, 1),
    outputBytes: count('options.outputBytes', outputBytes, 1),
  };
  const { size = defaultSize(bound.memoryBytes) } = options;
  if (count('options.size', size, 1) > MOST_WORKERS) throw wrongOption('options.size', `workers from 1 to ${MOST_WORKERS}`, size);
  return {
    renderer,
    size,
    bound,
    quarantineMs: count('options.quarantineMs', quarantineMs, 0),
    recycle: {
      jobs: count('options.recycleJobs', recycleJobs, 1),
      // A job finds at least half of what it may take.
      bytes: Math.min(count('options.recycleBytes', recycleBytes, 1), bound.memoryBytes / 2),
    },
    modelBytes: count('options.modelBytes', modelBytes, 0),
    ...(cgroup !== null && { cgroup: readCgroup(cgroup) }),
  };
}

function readCgroup(folder) {
  if (typeof folder !== 'string' || !folder.startsWith('/')) throw wrongOption('options.cgroup', 'the path of a cgroup, from /, or null', folder);
  return new Cgroup(folder);
}

const defined = (options) => Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined));
