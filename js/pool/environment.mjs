import path from 'node:path';
import { makeFolder } from '../api/make_folder.mjs';
import { workerLibrary } from '../api/native.mjs';
import { threadsOfEach } from './defaults.mjs';

/** What a worker gets of the environment of this process: where programs, libraries, caches and the GL driver are, and the language. No secret. */
const NAMES = ['PATH', 'HOME', 'USER', 'LANG', 'LANGUAGE', 'TZ', 'TMPDIR', 'LD_LIBRARY_PATH', 'LD_PRELOAD', 'CUDA_VISIBLE_DEVICES', 'DRI_PRIME'];
const BEGINNINGS = [
  'TELAR_',
  'XDG_CACHE_',
  'XDG_DATA_',
  'XDG_CONFIG_',
  'LC_',
  'LIBGL_',
  'GALLIUM_',
  'MESA_',
  'EGL_',
  '__EGL_',
  '__GLX_',
  '__NV_',
  'NVIDIA_',
  'LP_',
  'GLIBC_',
  'ASAN_',
  'UBSAN_',
  'LSAN_',
];

/** Of those, keys of the service: a worker that was taken over has none. */
const SECRET = /^TELAR_SIGN_/;

const isPassedOn = (name) => (NAMES.includes(name) || BEGINNINGS.some((beginning) => name.startsWith(beginning))) && !SECRET.test(name);

/**
 * The environment of one of so many workers.
 * @param {number} size
 * @param {{cacheDirectory?: string | null, from?: Record<string, string | undefined>, library?: string}} [options] the renderer's; `from`: where
 *   it is taken from; `library`: file of libtelar_worker.so
 */
export function workerEnvironment(size, { cacheDirectory = null, from = process.env, library = workerLibrary().file } = {}) {
  const own = Object.fromEntries(Object.entries(from).filter(([name]) => isPassedOn(name)));
  // io_uring is a second way to system calls, which the filter of a worker does not see. Decoded textures come and go with each job: kept as heap
  // and in large pages, their memory need not be given by the kernel and cleared anew.
  const threads = { LP_NUM_THREADS: String(threadsOfEach(size)), UV_USE_IO_URING: '0' };
  const env = { ...threads, GLIBC_TUNABLES: TUNABLES, ...programCache(cacheDirectory), ...own };
  return { ...env, ...preload(library, own.LD_PRELOAD, [cacheDirectory, env.MESA_SHADER_CACHE_DIR]) };
}

const NO_PROGRAM_CACHE = { MESA_SHADER_CACHE_DISABLE: 'true' };

/**
 * Mesa keeps the machine code of shaders in a folder, and each process that finds it there runs it. A worker that was taken over could leave its own there
 * for other programs of the user. So workers have a folder of their own, in telar's cache, and none where telar has no cache or the disk takes nothing.
 */
function programCache(folder) {
  if (!folder) return NO_PROGRAM_CACHE;
  try {
    // The name is Mesa's. It does not make the folder above, and complains on standard errors where it cannot make this one.
    makeFolder(path.join(folder, 'mesa_shader_cache'));
  } catch {
    return NO_PROGRAM_CACHE;
  }
  return { MESA_SHADER_CACHE_DIR: folder, MESA_SHADER_CACHE_MAX_SIZE: '256M' };
}

/** Sanitizers want to be first, and have an allocator of their own. */
const SANITIZER = /lib(clang_rt\.)?[alt]san/;

/**
 * The library before what the caller preloads: an allocator of the caller's is then asked through it. It knows by TELAR_IS_WORKER what it is in, and by
 * TELAR_WORKER_FOLDERS where a worker writes: nowhere else.
 */
function preload(library, own, folders) {
  if (!library || SANITIZER.test(own ?? '')) return {};
  return { TELAR_IS_WORKER: '1', TELAR_WORKER_FOLDERS: folders.filter(Boolean).join('\n'), LD_PRELOAD: own ? `${library} ${own}` : library };
}

const TUNABLES = 'glibc.malloc.hugetlb=1:glibc.malloc.mmap_threshold=4294967295:glibc.malloc.trim_threshold=4294967295';
