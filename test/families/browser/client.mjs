// What a client of an older three.js may set beside applyShot, which does by itself what such a release asks for.
import * as THREE from 'three';

/**
 * @typedef {object} Client
 * @property {(drawn: {renderer: object, settings?: Settings}) => void} finishScene - After applyShot.
 *
 * What a client sets beside the shot.
 * @typedef {object} Settings
 * @property {string} [shadowType] - Name of a constant of three.js, in place of PCFShadowMap, its default.
 * @property {boolean} [legacyLights] - Keeps the light units that 0.150 to 0.154 have by default.
 */

/** @type {Client} */
export const client = {
  finishScene({ renderer, settings = {} }) {
    if (settings.legacyLights) renderer.useLegacyLights = true;
    if (settings.shadowType) renderer.shadowMap.type = THREE[settings.shadowType];
  },
};
