import { EarlyRenderer } from '../api/early.mjs';

/** Words that ask for another renderer than the default one, for another way to load, or for neither. */
const OTHER = /^(--backend|--limit|--jobs|--fail-on|--timeout-ms|--ambient-visibility|--help|-h)(=|$)/;
const MODEL = /\.(glb|gltf)$/i;

function begun(words) {
  if (words.some((word) => OTHER.test(word))) return undefined;
  const models = words.filter((word) => MODEL.test(word));
  try {
    return new EarlyRenderer(models.length === 1 && !models[0].startsWith('-') ? models[0] : undefined);
  } catch {
    // The command tells that there is no addon.
    return undefined;
  }
}

/** The renderer of `telar thumbnail`, where its command line asks for the default one. To be imported first: what is read after it takes as long as the GL. */
export const earlyRenderer = begun(process.argv.slice(3));
