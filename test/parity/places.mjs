import { fileURLToPath } from 'node:url';

/** What telar ships: the T-shirt and its studio. */
export const ASSETS = fileURLToPath(new URL('../../js/assets/', import.meta.url));

/** Models by others, beside the project; may be absent. */
export const SHARED_MODELS = fileURLToPath(new URL('../../../shared/models/', import.meta.url));

/** Where pictures and reports go. */
export const OUT = fileURLToPath(new URL('../../out/parity/', import.meta.url));
