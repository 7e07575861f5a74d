import type { Pool, PoolOptions } from '../pool/index.js';
import type { PluginSettings, ServiceSettings } from './options.js';

export { TelarError } from '../error/index.js';
export type { PluginSettings, ServiceSettings };

/** What is no plain data of the options. */
export interface OwnOptions {
  /**
   * The pool that draws: one of createPool, which its owner closes, or the options of one, which the plugin opens and closes.
   * @default {}
   */
  pool?: Pool | PoolOptions;
  /**
   * Gives the bytes of the model that a request names (`model` of its body or address); null where there is none. What it throws the client is not told.
   * @default undefined: such requests are refused
   */
  resolve?: (reference: string, options: { signal: AbortSignal }) => Uint8Array | null | undefined | Promise<Uint8Array | null | undefined>;
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
}

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
