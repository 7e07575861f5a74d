// Cut-out cloth covers some of a pixel's samples. WebGL has no mask of samples that a shader could write, but GL's own sample
// coverage, which takes so many samples, or the others. Called the first n and the last n, they are all the masks that
// shaders/material/coverage.glsl makes: the cloth is drawn once for each, with the pixels that it is the mask of. A transparent
// material blends what is there in part from far.

/** As shaders/material/coverage.glsl has them. */
const COVERAGE = { masked: 0, whole: 1, blended: 2 };

/** Samples of the canvas, for each renderer: they never change. */
const canvasSamples = new WeakMap();

/** Samples of a pixel of what a renderer draws into. */
function samplesOf(renderer) {
  const target = renderer.getRenderTarget();
  if (target) return Math.max(1, target.samples);
  if (!canvasSamples.has(renderer)) {
    const gl = renderer.getContext();
    canvasSamples.set(renderer, Math.max(1, gl.getParameter(gl.SAMPLES)));
  }
  return canvasSamples.get(renderer);
}

/**
 * Draws the pixels of which the cloth covers a part, so that three.js's own draw, which follows, has those that it covers whole. Of a
 * transparent material it draws both, and what is blended follows.
 * @param {import('three').Material} material - With `coverageParts`, a list that this fills, and `setCoverage(samples, mask, draw)`.
 * @param {unknown[]} draw - Arguments of Material.onBeforeRender.
 */
export function drawPartlyCovered(material, [renderer, scene, camera, geometry, object, group]) {
  const gl = renderer.getContext();
  const samples = samplesOf(renderer);
  const all = firstSamples(samples);
  const shown = material.transparent ? COVERAGE.whole : COVERAGE.masked;
  let drawn = 0;
  const drawPart = (mask) => {
    const part = (material.coverageParts[drawn++] ??= partOf(material));
    part.setCoverage(samples, mask, shown);
    renderer.renderBufferDirect(camera, scene, geometry, part, object, group);
  };
  for (let count = 1; count < samples; count++) {
    for (const isLast of [false, true]) {
      const rest = samples - count;
      gl.enable(gl.SAMPLE_COVERAGE);
      gl.sampleCoverage((isLast ? rest : count) / samples, isLast);
      drawPart(isLast ? firstSamples(count) << rest : firstSamples(count));
    }
  }
  gl.disable(gl.SAMPLE_COVERAGE);
  if (material.transparent) drawPart(all);
  material.setCoverage(samples, all, material.transparent ? COVERAGE.blended : COVERAGE.masked);
}

/** Bits of the first samples of a pixel. */
const firstSamples = (count) => 2 ** count - 1;

let parts = 0;

/**
 * The same material again, for three.js to tell apart: it sets uniforms where the material is another one. Everything that it does
 * not have of its own is the material's, as it is at the time.
 */
function partOf(material) {
  const part = Object.create(material, { id: { value: `${material.id} part ${++parts}` }, depthWrite: { value: true } });
  // Its own listeners: three.js lets go of what it holds for a material when that one says so.
  Object.assign(part, { _listeners: undefined, ownUniforms: {} });
  material.addEventListener('dispose', () => part.dispatchEvent({ type: 'dispose' }));
  return part;
}
