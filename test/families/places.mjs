import { fileURLToPath } from 'node:url';

/** Releases of three.js, one a folder. */
export const RELEASES_FOLDER = fileURLToPath(new URL('../../out/families/releases/', import.meta.url));

/** Pictures by release and case. */
export const PICTURES = fileURLToPath(new URL('../../out/families/pictures/', import.meta.url));

/** The page that the table is written to. */
export const PAGE = fileURLToPath(new URL('../../js/docs/families.md', import.meta.url));
