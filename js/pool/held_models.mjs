/** Bytes of a vertex with the attributes that garments have, on the CPU and on the GPU. */
const VERTEX_BYTES = 2 * 64;
const TEXEL_BYTES = 4;
/** A texture with its mip levels, and its copy on the GPU. */
const COPIES = 8 / 3;

/** What a loaded model takes in a worker, roughly: textures are nearly all of it. */
export const modelBytes = ({ vertices, images, fileBytes }) =>
  fileBytes + vertices * VERTEX_BYTES + images.reduce((sum, { width, height }) => sum + width * height * TEXEL_BYTES * COPIES, 0);

/** Which models one worker has loaded: as many as fit, those that were used last. */
export class HeldModels {
  #maxBytes;
  /** id to bytes, used longest ago first. */
  #models = new Map();

  constructor(maxBytes) {
    this.#maxBytes = maxBytes;
  }

  has(id) {
    return this.#models.has(id);
  }

  /** The worker has loaded it, or used it. */
  use(id, bytes = this.#models.get(id) ?? 0) {
    this.#models.delete(id);
    this.#models.set(id, bytes);
  }

  /** @returns {boolean} whether it was there */
  forget(id) {
    return this.#models.delete(id);
  }

  /** Takes what does not fit from the list. @returns {number[]} ids that the worker has to let go */
  trim() {
    const gone = [];
    let bytes = [...this.#models.values()].reduce((sum, each) => sum + each, 0);
    for (const [id, each] of this.#models) {
      if (bytes <= this.#maxBytes) break;
      this.#models.delete(id);
      gone.push(id);
      bytes -= each;
    }
    return gone;
  }
}
