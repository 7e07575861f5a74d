import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('..', import.meta.url));

/** The command telar as npm installs it. */
export const TELAR = path.join(ROOT, JSON.parse(readFileSync(path.join(ROOT, 'package.json'), 'utf8')).bin.telar);

/** Node reads the certificates that this variable names at each start, 40 ms on some machines: a picture has no use for them. */
const { NODE_EXTRA_CA_CERTS: _, ...env } = process.env;

/** What a command is started with. */
export const PLAIN_ENVIRONMENT = env;
