import { bodyOf } from './answer.mjs';
import { isUnchanged, tagOf } from './conditional.mjs';
import { jobJson } from './job_handlers.mjs';
import { isAsync } from './scope.mjs';

const queryOf = ({ raw }) => new URLSearchParams(raw.url.split(/\?(.*)/s)[1] ?? '');

/** How the routes that work reply: with a result, that the client has it already, or with a job. */
export class Replies {
  #service;
  #prefix;
  #cacheSeconds;

  /**
   * @param {import('./service.mjs').Service} service
   * @param {string} prefix where the routes begin
   * @param {number} cacheSeconds for which caches may keep what GET gives
   */
  constructor(service, prefix, cacheSeconds) {
    this.#service = service;
    this.#prefix = prefix;
    this.#cacheSeconds = cacheSeconds;
  }

  /** @param {string} kind of ROUTES */
  ofWork(kind, request, reply) {
    const { method, raw, telar } = request;
    return this.#reply(kind, { method, query: queryOf(request), raw, span: telar.span }, request, reply);
  }

  /** Of an address whose signature says what to draw, and until when. */
  ofSigned(request, reply) {
    const { method, raw, params, telar } = request;
    const { query, expires } = this.#service.signatures.open(params['*'], Date.now());
    telar.expires = expires;
    return this.#reply('thumbnail', { method, query: new URLSearchParams(query), raw, span: telar.span, isSigned: true }, request, reply);
  }

  async #reply(kind, asked, request, reply) {
    const { raw, method } = asked;
    if (method === 'POST' && isAsync(raw)) {
      const job = jobJson(await this.#service.submit(kind, asked, reply.raw), this.#prefix);
      return reply.code(202).headers({ location: job.links.self, 'preference-applied': 'respond-async', 'cache-control': 'no-store' }).send(job);
    }
    const { result, tag, ...answer } = await this.#service.answer(kind, asked, reply.raw);
    return result ? this.send(request, reply, { ...answer, result }) : this.#unchanged(request, reply, tag);
  }

  #unchanged(request, reply, tag) {
    return reply
      .headers({ vary: 'accept', 'cache-control': this.#publicFor(request), etag: tag })
      .code(304)
      .send();
  }

  /** What came of a job, or that the client has it already. */
  ofJob(request, reply, answer) {
    const { key } = answer.result;
    const tag = key && tagOf(key, answer.type);
    return tag && isUnchanged(request.raw, tag) ? this.#unchanged(request, reply, tag) : this.send(request, reply, answer);
  }

  /** A result, whoever kept it. */
  send(request, reply, { result, kind, type, waited, worked }) {
    const { method } = request;
    const isCached = method === 'GET' || method === 'HEAD';
    reply.header('vary', 'accept').header('cache-control', isCached ? this.#publicFor(request) : 'no-cache');
    const { type: own, body, headers } = bodyOf(result, { kind, type });
    if (result.key) reply.header('etag', tagOf(result.key, type));
    request.telar.key = result.key;
    if (waited !== undefined) reply.header('server-timing', `wait;dur=${Math.round(1000 * waited)}, work;dur=${Math.round(1000 * worked)}`);
    return reply
      .headers(headers || {})
      .type(own)
      .send(body);
  }

  /** A signed address is cached for no longer than it holds. */
  #publicFor({ telar: { expires } }) {
    const left = expires === undefined ? Infinity : Math.max(0, expires - Math.ceil(Date.now() / 1000));
    return `public, max-age=${Math.min(this.#cacheSeconds, left)}`;
  }
}
