import { EarlyGl } from '../api/opening.mjs';

/** Words that ask for another GL than the default one, or for none. */
const OTHER = /^(--backend|--limit|--jobs|--help|-h)(=|$)/;

function begun(words) {
  if (words.some((word) => OTHER.test(word))) return undefined;
  try {
    return new EarlyGl();
  } catch {
    // The command tells that there is no addon.
    return undefined;
  }
}

/** The GL of `telar thumbnail`, where its command line asks for the default one. To be imported first: what is read after it takes as long as the GL. */
export const earlyGl = begun(process.argv.slice(3));
