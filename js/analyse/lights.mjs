import { TelarError } from '../error/index.mjs';
import { nearest, shown } from '../shot/complain.mjs';
import { toldApart } from './targets.mjs';

/**
 * Lights to look at cloth in, as keys of a shot. Each shows other terms: broad light from all around the diffuse lobe and the
 * albedo of the rest, one lamp the shape of the lobes, one from behind what happens towards grazing.
 */
const lamp = (position, intensity) => [{ type: 'directional', position, intensity, castShadow: true }];

export const LIGHTS = {
  studio: { about: 'the bundled studio', shot: { environment: 'studio' } },
  sun: {
    about: 'a lamp from the upper right before the cloth, casting shadows, and a little of the studio',
    shot: { environment: { map: 'studio', intensity: 0.15 }, lights: lamp([1.2, 1.6, 1.4], 3) },
  },
  rim: {
    about: 'a lamp from behind and above, and a little of the studio',
    shot: { environment: { map: 'studio', intensity: 0.15 }, lights: lamp([-1, 1.1, -1.6], 4) },
  },
  sky: {
    about: 'light from above without an environment',
    shot: { environment: 'none', lights: [{ type: 'hemisphere', intensity: 2.5, groundColor: [0.2, 0.2, 0.2] }] },
  },
};

/**
 * @param {string[]} names of LIGHTS, or paths of .hdr and .exr environments
 * @returns {Array<{name: string, shot: object}>}
 * @throws {TelarError} E_USAGE
 */
export function lightsOf(names) {
  const lights = names.map((name) => {
    if (Object.hasOwn(LIGHTS, name)) return { name, shot: LIGHTS[name].shot };
    if (/\.(hdr|exr)$/i.test(name)) return { name: name.replace(/^.*\//, ''), shot: { environment: name } };
    const near = nearest(name, Object.keys(LIGHTS));
    throw new TelarError(
      'E_USAGE',
      `--lights: expected ${Object.keys(LIGHTS).join(', ')} or an .hdr or .exr file, got ${shown(name)}${near ? `; did you mean ${near}?` : ''}`,
    );
  });
  return toldApart(lights);
}
