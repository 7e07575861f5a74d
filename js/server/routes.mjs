import { REQUESTS } from './requests.mjs';

/**
 * The routes of the service: the plugin registers them, and openapi.json lists them.
 * @type {Readonly<Record<string, {url: string, methods: string[], doc: string, kind?: string, pattern?: string}>>} by name; kind: of REQUESTS, where the
 *   route does work; pattern: in place of the url, for Fastify
 */
export const ROUTES = Object.freeze({
  thumbnails: { url: '/v1/thumbnails', methods: ['GET', 'POST'], doc: REQUESTS.thumbnail.doc, kind: 'thumbnail' },
  signed: {
    url: '/v1/thumbnails/:signature/:options/:source',
    // Fastify bounds the length of a parameter that has a name.
    pattern: '/v1/thumbnails/*',
    methods: ['GET'],
    doc: 'Draws what a signed address says: see signThumbnail() of telar/server',
  },
  inspect: { url: '/v1/inspect', methods: ['POST'], doc: REQUESTS.inspect.doc, kind: 'inspect' },
  compare: { url: '/v1/compare', methods: ['POST'], doc: REQUESTS.compare.doc, kind: 'compare' },
  sheets: { url: '/v1/sheets', methods: ['POST'], doc: REQUESTS.sheet.doc, kind: 'sheet' },
  job: { url: '/v1/jobs/:id', methods: ['GET', 'DELETE'], doc: 'Says how far a job is; DELETE cancels it' },
  jobEvents: { url: '/v1/jobs/:id/events', methods: ['GET'], doc: 'Tells of each change of a job until it is over' },
  jobResult: { url: '/v1/jobs/:id/result', methods: ['GET'], doc: 'Gives what came of a job' },
  error: { url: '/v1/errors/:code', methods: ['GET'], doc: 'Says what a code of an error means, and what cures it' },
  health: { url: '/healthz', methods: ['GET'], doc: 'Answers while the process lives' },
  readiness: { url: '/readyz', methods: ['GET'], doc: 'Says whether a worker is there and work is let in' },
  metrics: { url: '/metrics', methods: ['GET'], doc: 'Gives figures in the text format of Prometheus' },
  openapi: { url: '/openapi.json', methods: ['GET'], doc: 'Gives this description' },
  page: { url: '/try', methods: ['GET'], doc: 'Gives a page to try the service' },
  pageScript: { url: '/try/page.mjs', methods: ['GET'], doc: 'Gives the script of that page' },
  pageStyle: { url: '/try/page.css', methods: ['GET'], doc: 'Gives the style of that page' },
});

/** Routes that Prometheus, people and this page itself have no description for. */
export const UNDESCRIBED = Object.freeze(['pageScript', 'pageStyle']);
