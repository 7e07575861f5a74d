import { readFileSync } from 'node:fs';

const { version } = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8'));

/** Of telar, and of what it runs on. */
export const versions = Object.freeze({ telar: version, node: process.versions.node, napi: process.versions.napi });
