/** Longer side of the picture of depths, pixels. */
const PIXELS = 512;

/** Part of the model's diagonal by which a point may lie behind what is seen: it lies on the cloth itself. */
const LAYER = 0.005;

/** How far the garment is in each pixel of a picture: what tells points that are seen from those behind it. */
export class Depths {
  #width;
  #height;
  #values;
  #toMetres;

  /**
   * @param {object} drawn
   * @param {object} drawn.THREE
   * @param {object} drawn.renderer
   * @param {object} drawn.scene
   * @param {object} drawn.camera of the picture
   * @param {object} drawn.model what hides: all else in the scene does not
   */
  constructor({ THREE, renderer, scene, camera, model }) {
    const { width, height } = renderer.getSize(new THREE.Vector2());
    const part = PIXELS / Math.max(width, height);
    [this.#width, this.#height] = [width, height].map((side) => Math.max(1, Math.round(side * part)));
    const { near, far } = camera;
    this.#toMetres = camera.isOrthographicCamera ? (depth) => near + depth * (far - near) : (depth) => (near * far) / (far - depth * (far - near));
    const target = new THREE.WebGLRenderTarget(this.#width, this.#height, { type: THREE.FloatType });
    const others = scene.children.filter((child) => child !== model && child.visible);
    const { background, overrideMaterial } = scene;
    const clear = { color: renderer.getClearColor(new THREE.Color()), alpha: renderer.getClearAlpha() };
    for (const other of others) other.visible = false;
    // It writes 1 less the depth; what is cleared is as far as can be.
    const material = new THREE.MeshDepthMaterial({ depthPacking: THREE.BasicDepthPacking, side: THREE.DoubleSide, blending: THREE.NoBlending });
    Object.assign(scene, { background: null, overrideMaterial: material });
    renderer.setRenderTarget(target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    renderer.render(scene, camera);
    this.#values = new Float32Array(4 * this.#width * this.#height);
    renderer.readRenderTargetPixels(target, 0, 0, this.#width, this.#height, this.#values);
    renderer.setRenderTarget(null);
    renderer.setClearColor(clear.color, clear.alpha);
    Object.assign(scene, { background, overrideMaterial });
    for (const other of others) other.visible = true;
    target.dispose();
    material.dispose();
  }

  /**
   * Whether the garment lies before a point, in its pixel and in all around it: beside an edge the point is seen.
   * @param {number[]} place parts of the picture's width and height, from the top left corner
   * @param {number} depth 0 to 1, of the camera
   * @param {number} diagonal of the model, metres
   */
  hides([x, y], depth, diagonal) {
    const before = this.#toMetres(depth) - LAYER * diagonal;
    const [column, row] = [Math.floor(x * this.#width), Math.floor((1 - y) * this.#height)];
    for (let dy = -1; dy <= 1; dy++)
      for (let dx = -1; dx <= 1; dx++) {
        const [px, py] = [column + dx, row + dy];
        if (px < 0 || py < 0 || px >= this.#width || py >= this.#height) return false;
        if (this.#toMetres(1 - this.#values[4 * (py * this.#width + px)]) >= before) return false;
      }
    return true;
  }
}
