import { bundlesFresh } from '../../js/setup/bundles.mjs';

// js/dist, for tests of what is built: `npm test` makes it before they run. They make nothing, since others read it meanwhile.
if (!bundlesFresh()) throw new Error('js/dist is older than its sources: npm run build:js');
