import type { Pool, PoolOptions } from '../pool/index.js';
import type { Queue, QueueOptions, ResultAddresses } from '../queue/index.js';
import type { Shot } from '../shot/index.js';
import type { PluginSettings, ServiceSettings } from './options.js';

export { TelarError } from '../error/index.js';
export type { PluginSettings, ServiceSettings };
export type { ResultAddress, ResultAddresses } from '../queue/index.js';

/** What is no plain data of the options. */
export interface OwnOptions {
  /**
   * The pool that draws: one of createPool, which its owner closes, or the options of one, which the plugin opens and closes.
   * @default {}
   */
  pool?: Pool | PoolOptions;
  /**
   * The queue of jobs (`prefer: respond-async`): one of openQueue, which its owner closes, or the options of one, which the plugin opens and closes.
   * @default a queue in this process
   */
  queue?: Queue | QueueOptions;
  /**
   * Gives the bytes of the model that a request names (`model` of its body or address); null where there is none. What it throws the client is not told.
   * `maxBytes`: more bytes are refused (L_FILE_BYTES), so they need not be read.
   * @default undefined: such requests are refused
   */
  resolve?: (
    reference: string,
    options: { signal: AbortSignal; maxBytes: number },
  ) => Uint8Array | null | undefined | Promise<Uint8Array | null | undefined>;
  /**
   * Bytes of .hdr or .exr maps, by the name that shots may give as their environment. A path is nothing that a request may name.
   * @default {}
   */
  environments?: Record<string, Uint8Array>;
  /**
   * Folders of own templates of sheets, by the name that a spec's `template` has.
   * @default {}
   */
  templates?: Record<string, string>;
  /**
   * Keys of signed addresses, in hexadecimal: key of at least 16 bytes, salt of at least 1. Several are for rotation. Where there are some, references
   * of models are taken from signed addresses alone; models in the request itself are not concerned.
   * @default []
   */
  signingKeys?: SigningKey[];
  /**
   * Where results of thumbnails are kept, so that none is drawn twice: a folder, or callbacks that give addresses. Their name is the content key, with
   * "-avif" and its quality and a `failOn` that is not the default behind it. What fails
   * there costs no answer; `telar_store_total` of /metrics counts it.
   * @default undefined: nowhere
   */
  store?: string | ResultAddresses;
}

/** A key and its salt, in hexadecimal. `openssl rand -hex 32` makes one. */
export interface SigningKey {
  key: string;
  salt: string;
}

/** What a signed address asks for. */
export interface SignedRequest {
  /** As of a request; its environment is one that the service names. @default {} */
  shot?: Shot;
  /** @default 'error' */
  failOn?: 'error' | 'warning' | 'none';
  /** @default false */
  ambientVisibility?: boolean;
  /** Seconds since 1970 from which on the address is refused. @default undefined: never */
  expires?: number;
}

/**
 * Makes the address of a thumbnail that a service with the same key draws on GET: /v1/thumbnails/SIGNATURE/OPTIONS/SOURCE, to put behind the address
 * of the service and its prefix. Options and source are base64url, readable by whoever has the address; the signature is HMAC-SHA256.
 * @param model - The reference, as of `model` of a request.
 * @throws {TelarError} E_OPTION, whose message has nothing of the key
 * @example
 * const path = signThumbnail('shirts/cloth.glb', { shot: { size: { width: 256, height: 256 } } }, { key, salt });
 */
export function signThumbnail(model: string, asked: SignedRequest, key: SigningKey): string;

/** Options of the plugin. */
export interface ServerOptions extends PluginSettings, OwnOptions {}

/**
 * The Fastify plugin (Fastify 5): routes beneath its `prefix`. js/docs/server.md lists them.
 * @throws {TelarError} E_OPTION, and what createPool() throws
 * @example
 * await fastify.register(telarServer, { prefix: '/pictures', resolve: (name) => store.get(name) });
 */
export function telarServer(fastify: any, options?: ServerOptions & { prefix?: string }): Promise<void>;

/** A server that listens. */
export interface Listening {
  url: string;
  port: number;
  /** As the option says it. */
  drainMs: number;
  /** Of the queue: W_QUEUE. */
  warnings: Array<{ code: string; message: string }>;
  /** Lets no new work in, waits for what runs, at most `drainMs`, and ends. */
  drain(): Promise<void>;
}

/**
 * Makes a server of its own around the plugin, as `telar serve` does.
 * @param io - log: where lines of the log go; without it there are none.
 * @throws {TelarError} E_OPTION, X_PORT, and what createPool() throws
 * @example
 * const service = await listen({ port: 8080, pool: { size: 2 } });
 * process.once('SIGTERM', () => service.drain());
 */
export function listen(options?: ServerOptions & ServiceSettings, io?: { log?: { write(line: string): unknown } }): Promise<Listening>;
