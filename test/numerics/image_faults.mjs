// Faults that a renderer may have, planted between a check of whole pictures and the renderer: the shot that it draws is
// another than it is asked for.

/**
 * @typedef {object} ImageFault
 * @property {string} name
 * @property {string} check - Name of the check that finds it.
 * @property {string[]} fails - Figures of that check that are off their bars then: what stands after the colon.
 * @property {(shot: object, number: number) => object} shot - The shot that is drawn in place of the one asked for; number
 *   counts the pictures from 0.
 */

const withCamera = (shot, camera) => ({ ...shot, camera: { ...shot.camera, ...camera } });

/** @type {ImageFault[]} */
export const IMAGE_FAULTS = [
  {
    name: 'light that depends on the size of the model',
    check: 'scale and offset',
    fails: ['largest difference away from edges, of 255', 'part of all pixels that differ by more than 1'],
    shot: (shot, number) => ({ ...shot, exposure: 1 + 0.05 * number }),
  },
  {
    name: 'an environment that is turned by one degree too far',
    check: 'rotation',
    fails: ['largest difference away from edges, of 255'],
    shot: (shot) => ({ ...shot, environment: { ...shot.environment, rotation: shot.environment.rotation * (1 + 1 / 37) } }),
  },
  {
    name: 'a picture that depends on the ones before it',
    check: 'order of triangles',
    fails: ['largest difference, of 255'],
    shot: (shot, number) => withCamera(shot, { azimuth: 0.5 * number }),
  },
  {
    name: 'a near plane at the eye, which leaves the depth no digits',
    check: 'close surfaces',
    fails: ['pixels of the hidden one'],
    shot: (shot) => ({ ...shot, camera: { position: [0, 0, 2], target: [0, 0, 0], fovY: 40, near: 1e-7, far: 1e3 } }),
  },
  {
    name: 'a rectangle light that a parallel view straight ahead loses',
    check: 'rectangle light straight ahead',
    fails: ['relative difference'],
    shot: (shot) => (shot.camera.azimuth === 0 ? { ...shot, lights: [] } : shot),
  },
  {
    name: 'a sun that is lost in half floats',
    check: 'sun beyond half floats',
    fails: ['part of its light kept'],
    shot: (shot) => ({ ...shot, quality: 'standard', shading: 'three' }),
  },
];

/** The renderer with the fault. */
export function misled(renderer, fault) {
  let number = 0;
  return { render: (model, shot, options) => renderer.render(model, fault.shot(shot, number++), options) };
}
