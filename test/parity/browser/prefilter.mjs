// Reads what three's PMREMGenerator makes of an equirectangular map: a cube, or before 0.187 an atlas.

/**
 * @param {typeof import('three')} THREE
 * @param {object} renderer - THREE.WebGLRenderer
 * @param {object} environment - Equirectangular texture
 * @returns {Generator<{name: string, size: number, height?: number, values: Float32Array}>} Each face of each level,
 *   `LEVEL-FACE`: RGBA fp32 (of stored halfs), size * size, rows in GL's order; faces +x -x +y -y +z -z. Of an atlas all of it,
 *   `atlas`, size * height.
 */
export function* prefilteredFaces(THREE, renderer, environment) {
  environment.mapping = THREE.EquirectangularReflectionMapping;
  const generator = new THREE.PMREMGenerator(renderer);
  const target = generator.fromEquirectangular(environment);
  const gl = renderer.getContext();
  if (!target.isWebGLCubeRenderTarget) yield atlasOf(renderer, target);
  // three gives size x size faces a mip chain that ends at 8 px (roughness 1).
  for (let level = 0, size = target.isWebGLCubeRenderTarget ? target.width : 0; size >= 8; level++, size /= 2) {
    for (let face = 0; face < 6; face++) {
      renderer.setRenderTarget(target, face, level);
      const values = new Float32Array(size * size * 4);
      gl.readPixels(0, 0, size, size, gl.RGBA, gl.FLOAT, values);
      yield { name: `${level}-${face}`, size, values };
    }
  }
  renderer.setRenderTarget(null);
  target.dispose();
  generator.dispose();
}

function atlasOf(renderer, target) {
  const { width, height } = target;
  const values = new Float32Array(width * height * 4);
  renderer.setRenderTarget(target);
  renderer.getContext().readPixels(0, 0, width, height, WebGL2RenderingContext.RGBA, WebGL2RenderingContext.FLOAT, values);
  return { name: 'atlas', size: width, height, values };
}
