import { readFile } from 'node:fs/promises';

/** What the service says of itself: openapi.json, and the page to try it. */

// From here, and from the bundle that require() loads, whose place is told as js/api.
const file = (name) => readFile(new URL(name, import.meta.url));

/** The page loads nothing from elsewhere, and runs no script but its own. */
const POLICY =
  "default-src 'none'; script-src 'self'; style-src 'self'; img-src blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

const PAGE = {
  page: ['page/index.html', 'text/html; charset=utf-8'],
  pageScript: ['page/page.mjs', 'text/javascript; charset=utf-8'],
  pageStyle: ['page/page.css', 'text/css; charset=utf-8'],
};

/** The document of a service whose routes begin at `prefix`. */
async function documentOf(prefix, { metrics }) {
  const { paths, ...document } = JSON.parse(await file('openapi.json'));
  const { '/metrics': _, ...unmetered } = paths;
  return JSON.stringify({ ...document, servers: [{ url: prefix || '/' }], paths: metrics ? paths : unmetered });
}

/**
 * Handlers of the routes, by their names in ROUTES.
 * @param {string} prefix where the routes begin
 * @param {{metrics: boolean}} options
 */
export async function descriptionHandlers(prefix, options) {
  const document = await documentOf(prefix, options);
  const pages = Object.entries(PAGE).map(async ([name, [from, type]]) => {
    const bytes = await file(from);
    return [name, async (request, reply) => reply.header('content-security-policy', POLICY).type(type).send(bytes)];
  });
  return { openapi: async (request, reply) => reply.type('application/json; charset=utf-8').send(document), ...Object.fromEntries(await Promise.all(pages)) };
}
