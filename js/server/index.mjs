// telar/server: pictures over HTTP, as a Fastify plugin and as a server of its own.
export { telarServer } from './plugin.mjs';
export { listen } from './listen.mjs';
export { signThumbnail } from './signature.mjs';
