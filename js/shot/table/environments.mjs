/** The environments that go by a name, and the file in js/assets of each; "none" has no light. Any other is a path or bytes. */
export const ENVIRONMENTS = Object.freeze({ studio: 'studio.hdr', none: null });

/** @param {unknown} map `environment.map` of a shot */
export const isNamedEnvironment = (map) => typeof map === 'string' && Object.hasOwn(ENVIRONMENTS, map);
