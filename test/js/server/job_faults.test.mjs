import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { JOB_CHECKS, JOB_OPTIONS, recording } from './job_checks.mjs';
import { importMutant, outcomeOf } from './mutants.mjs';
import { MODELS, SHOT, openPool } from './support.mjs';

// Faults planted in the code of jobs, each of which its check must find.

/** Milliseconds after which a check that passes would have passed. */
const HANG_MS = 2500;

/** By the beginning of the check's name: [what is wrong, file, right, wrong]; hangs: the check then waits for what never comes. */
const FAULTS = {
  'the result': [
    ['no tag', 'memory_queue.mjs', 'return result && { result, meta };', 'return result && { result: { ...result, key: undefined }, meta };'],
    ['it is over before it began', 'job_handlers.mjs', '{ ended: time(ended) }', '{ ended: time(created - 1) }'],
    ['done and not whole', 'memory_queue.mjs', 'progress: 1 }', 'progress: 0.9 }'],
    ['another address', 'replies.mjs', 'location: job.links.self', 'location: job.links.events'],
    ['another type', 'service.mjs', 'meta: { type, kind }', "meta: { type: 'image/png', kind }"],
    ['sent to who has it', 'replies.mjs', 'return tag && isUnchanged(request.raw, tag) ?', 'return false ?'],
    ['no link to it', 'job_handlers.mjs', "state === 'done' && { result:", "state === 'failed' && { result:"],
  ],
  'events: from': [
    ['no progress', 'memory_queue.mjs', 'job.progress = part;', 'return;'],
    ['progress goes back', 'memory_queue.mjs', 'job.progress = part;', 'job.progress = part > 0.5 ? 0.2 : part;'],
    ['another name', 'job_handlers.mjs', 'event(state.state, jobJson(state, prefix))', "event('change', jobJson(state, prefix))"],
    ['the end twice', 'job_handlers.mjs', 'return raw.end();', 'return raw.end(event(first.state, jobJson(first, prefix)));'],
    ['not what is now', 'job_handlers.mjs', 'event(first.state,', "event('running',"],
    ['the stream never ends', 'job_handlers.mjs', 'return raw.end();', 'return;', { hangs: true }],
  ],
  'events: pictures': [
    ['none', 'memory_queue.mjs', 'if (!isOver(job)) tell(job, preview);', '', { hangs: true }],
    ['the size of the small one', 'preview.mjs', 'width: preview.width, height: preview.height', 'width, height'],
    ['other pixels', 'preview.mjs', 'from[y * step * width + x * step]', 'from[0]'],
    ['without an id', 'job_handlers.mjs', '{ id: state.id, ...shown, data:', '{ ...shown, data:'],
  ],
  cancel: [
    ['told as failed', 'memory_queue.mjs', "? 'cancelled' : 'failed'", "? 'failed' : 'failed'"],
    ['a result of none', 'job_handlers.mjs', 'if (error) throw error;', ''],
    ['a result too early', 'job_handlers.mjs', "throw new TelarError('E_NOT_FOUND', `the job has", "throw new TelarError('X_BUSY', `the job has"],
    ['the worker goes on', 'memory_queue.mjs', 'job.controller.abort(reason);', '', { hangs: true }],
    ['what is over is cancelled', 'memory_queue.mjs', 'if (!isOver(job)) this.#stop', "if (isOver(job)) job.state = 'cancelled'; else this.#stop"],
  ],
  'a job that fails': [
    ['another code', 'memory_queue.mjs', '{ error: verdict.error }', "{ error: new TelarError('X_INTERNAL', 'no') }"],
    ['another message', 'job_handlers.mjs', 'if (error) throw error;', "if (error) throw new TelarError(error.code, 'no');"],
  ],
  'what is wrong': [
    [
      'a job all the same',
      'service.mjs',
      'const { task, type } = await this.#wanted(kind, request, scope, () => this.queue.check(tenant));',
      'await this.queue.add({ kind, asked: {}, files: {} }); const { task, type } = await this.#wanted(kind, request, scope);',
    ],
  ],
  'so many jobs': [
    ['one more', 'memory_queue.mjs', 'this.#waits >= this.#bounds.jobs', 'this.#waits > this.#bounds.jobs'],
    ['jobs come first', 'admission.mjs', 'this.#waiting.size > 0 ? this.#waiting : this.#later', 'this.#later.size > 0 ? this.#later : this.#waiting'],
    ['the last comes first', 'memory_queue.mjs', 'let [job] = this.#waiting;', 'let job = [...this.#waiting].at(-1);'],
  ],
  'a job may take': [
    ['twice the time', 'service.mjs', 'scope.startClock(this.#options.jobMs)', 'scope.startClock(2 * this.#options.jobMs)'],
    ['the result is not kept', 'memory_queue.mjs', 'const age = Date.now() - job.ended;', 'const age = Infinity;'],
    ['the result is kept for ever', 'memory_queue.mjs', 'const age = Date.now() - job.ended;', 'const age = 0;', { hangs: true }],
  ],
  'more results': [
    ['all are kept', 'memory_queue.mjs', 'this.#resultBytes > resultBytes ||', ''],
    ['the newest go first', 'memory_queue.mjs', '.filter(isOver);', '.filter(isOver).reverse();'],
  ],
  draining: [
    ['nobody is told', 'memory_queue.mjs', 'tell(job);\n    job.listeners.clear();', 'job.listeners.clear();'],
    ['another reason', 'service.mjs', "new TelarError('X_SHUTDOWN', 'the service ended", "new TelarError('X_TIMEOUT', 'the service ended"],
    ['those that wait are left', 'memory_queue.mjs', '[...this.#waiting, ...this.#delayed.keys(), ...this.#running]', '[...this.#running]', { hangs: true }],
  ],
  'asked for again': [
    ['drawn again', 'memory_queue.mjs', 'if (found && isKept(found)) return stateOf(found);', ''],
    ['tenants share it', 'service.mjs', "(tenantHeader && headers[tenantHeader.toLowerCase()]) || ''", "''"],
  ],
  'a job that is none': [
    ['another code', 'job_handlers.mjs', "if (!state) throw new TelarError('E_NOT_FOUND'", "if (!state) throw new TelarError('E_REQUEST'"],
  ],
};

const checkOf = (beginning) => Object.entries(JOB_CHECKS).find(([name]) => name.startsWith(beginning));

let real, glb, drawn;
before(async () => {
  [real, glb] = await Promise.all([openPool(), MODELS.cloth()]);
  drawn = (await real.render(glb, SHOT)).data;
});
after(() => real.close());

/** Runs a check of a service with a fault. */
async function outcome(check, edits, { hangs }) {
  const { listen } = await importMutant(edits);
  const ending = new AbortController();
  const pool = recording(real, ending.signal);
  const all = [];
  const serve = async (options) => {
    all.push(await listen({ port: 0, pool, drainMs: 1, ...options }));
    return all.at(-1);
  };
  const { url } = await serve(JOB_OPTIONS);
  const about = { url, pool, serve, glb, drawn };
  const found = await outcomeOf(() => check(about), { hangMs: hangs ? HANG_MS : 100 * HANG_MS });
  // What hangs would hold the worker.
  ending.abort();
  await Promise.all(all.map((one) => one.drain()));
  return found;
}

test('each check has a fault that it must find', () => {
  const checked = Object.keys(FAULTS).map((beginning) => checkOf(beginning)[0]);
  assert.deepEqual(checked, Object.keys(JOB_CHECKS));
});

for (const [beginning, faults] of Object.entries(FAULTS)) {
  const [name, check] = checkOf(beginning);
  for (const [fault, file, right, wrong, how = {}] of faults) {
    test(`planted: ${fault}. Found by: ${name}`, async () => {
      assert.equal(await outcome(check, [[file, right, wrong]], how), how.hangs ? 'hangs' : 'fails');
    });
  }
}
