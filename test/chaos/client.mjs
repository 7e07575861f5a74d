import http from 'node:http';
import { setTimeout as sleep } from 'node:timers/promises';

/** Milliseconds between two questions. */
const ASK_MS = 100;
/** Milliseconds that an answer may take: a connection to a process that was killed is cut at once, one to a stopped one is not. */
const ANSWER_MS = 20_000;
/** Of the requests, so many are slow, and so many cut. */
const [SLOW, CUT] = [0.1, 0.1];
const SLOW_MS = 1500;

/**
 * @param {URL} url
 * @param {{method: string, headers?: object, body?: Buffer, manner?: 'slow' | 'cut'}} how slow: the body comes in two halves; cut: the client leaves after one
 * @returns {Promise<{status: number, body: Buffer} | undefined>} undefined: the connection was cut
 */
function ask(url, { method, headers = {}, body, manner }) {
  return new Promise((resolve) => {
    const request = http.request(url, { method, agent: false, headers: { ...headers, ...(body && { 'content-length': body.length }) } });
    request.setTimeout(ANSWER_MS, () => request.destroy());
    request.on('error', () => resolve(undefined));
    request.on('close', () => resolve(undefined));
    request.on('response', async (response) => {
      const chunks = await response.toArray().catch(() => undefined);
      resolve(chunks && response.complete ? { status: response.statusCode, body: Buffer.concat(chunks) } : undefined);
    });
    if (!manner) return request.end(body);
    request.write(body.subarray(0, body.length / 2));
    setTimeout(() => (manner === 'cut' ? request.destroy() : request.end(body.subarray(body.length / 2))), manner === 'cut' ? ASK_MS : SLOW_MS);
  });
}

/** A client that asks until it has its result, and counts what must not happen. */
export function clientOf(base, { next, deadline }) {
  const facts = { done: 0, lost: 0, wrong: 0, stuck: 0, failed: {}, asked: 0, again: 0, slow: 0, cut: 0, longest: 0 };
  const isLate = () => performance.now() > deadline();

  /** The job, once it is accepted: asked for as often as it takes. */
  async function accepted({ model, shot }) {
    const url = new URL(`/v1/thumbnails?shot=${encodeURIComponent(JSON.stringify(shot))}`, base);
    for (let times = 0; !isLate(); ++times) {
      facts.asked += 1;
      if (times > 0) facts.again += 1;
      const chance = next();
      const manner = chance < SLOW ? 'slow' : chance < SLOW + CUT ? 'cut' : undefined;
      if (manner) facts[manner] += 1;
      const headers = { 'content-type': 'model/gltf-binary', prefer: 'respond-async' };
      const answer = await ask(url, { method: 'POST', headers, body: model, manner });
      if (answer?.status === 202) return JSON.parse(answer.body);
      if (answer && ![429, 503].includes(answer.status)) throw new Error(`the API answers ${answer.status}: ${answer.body}`);
      await sleep(ASK_MS);
    }
    return undefined;
  }

  /** What an accepted job became. */
  async function ended({ links }) {
    while (!isLate()) {
      const answer = await ask(new URL(links.self, base), { method: 'GET' });
      if (answer?.status === 404) return 'lost';
      const told = answer?.status === 200 ? JSON.parse(answer.body) : undefined;
      if (told?.state === 'done') return 'done';
      if (told && ['failed', 'cancelled'].includes(told.state)) return told.error.code;
      await sleep(ASK_MS);
    }
    return 'stuck';
  }

  async function result({ links }) {
    while (!isLate()) {
      const answer = await ask(new URL(`${links.self}/result`, base), { method: 'GET' });
      if (answer?.status === 200) return answer.body;
      // A job that is done and has no result.
      if (answer?.status === 404) return undefined;
      await sleep(ASK_MS);
    }
    return undefined;
  }

  return {
    facts,
    async job({ model, shot, right }) {
      const start = performance.now();
      const job = await accepted({ model, shot });
      const end = job ? await ended(job) : 'stuck';
      facts.longest = Math.max(facts.longest, (performance.now() - start) / 1000);
      if (end !== 'done') {
        if (end === 'lost' || end === 'stuck') facts[end] += 1;
        else facts.failed[end] = (facts.failed[end] ?? 0) + 1;
        return;
      }
      const bytes = await result(job);
      if (!bytes) facts.lost += 1;
      else if (!bytes.equals(right)) facts.wrong += 1;
      else facts.done += 1;
    },
  };
}
