import * as THREE from 'three';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { namesOf } from '../../three/cloths.mjs';
import { applyShot, factsOf, rendererParameters } from '../../three/index.mjs';
import { ANY_MODEL } from '../../shot/facts.mjs';
import { resolveLeftOut } from '../../shot/left_out.mjs';
import { resolvePart } from '../../shot/part.mjs';
import { resolvePose } from '../../shot/pose.mjs';
import { resolveShot } from '../../shot/resolve.mjs';
import { Depths } from './depths.mjs';
import { alphaOf, straightPixels } from './pixels.mjs';
import { loadedBy } from './remote.mjs';

/**
 * The browser client: stock three.js with the model, set up from a shot.
 */
export class Client {
  #place;
  #renderers = new Map();
  #scene = new THREE.Scene();
  #model;
  #measured;
  #camera;
  #renderer;
  #environments;
  #depths;
  #diagonal;
  #loader;
  #files = new Map();

  /** Is called when a picture stands. */
  onDraw = () => {};

  /** three.js's own number. */
  static revision = THREE.REVISION;

  /**
   * @param {object} options
   * @param {HTMLElement} options.place where the canvas goes
   * @param {string} options.model URL
   * @param {{map: string, format: string | null}[]} options.environments
   * @param {object} options.shot where the page begins
   */
  static async load({ place, model, environments, shot }) {
    const self = new Client();
    self.#place = place;
    self.#environments = environments;
    const renderer = self.#rendererFor(resolveShot({ quality: shot.quality }, ANY_MODEL));
    const loader = new GLTFLoader()
      .setDRACOLoader(new DRACOLoader().setDecoderPath(new URL('page/draco/', document.baseURI).href))
      .setKTX2Loader(new KTX2Loader().setTranscoderPath(new URL('page/basis/', document.baseURI).href).detectSupport(renderer))
      .setMeshoptDecoder(MeshoptDecoder);
    self.#loader = loader;
    self.#model = await loader.loadAsync(model);
    self.#scene.add(self.#model.scene);
    return self;
  }

  /** What resolveShot needs to know of the model in the shot's pose; measured anew where that, or the part framed or left out, is another one. */
  facts(shot) {
    const { frame } = resolvePart(shot) ?? {};
    const wanted = { pose: resolvePose(shot, this), frame, variant: shot.variant, ghost: resolveLeftOut(shot) };
    const key = JSON.stringify(wanted);
    if (this.#measured?.key !== key) this.#measured = { key, facts: factsOf(this.#model, { THREE, ...wanted }) };
    return this.#measured.facts;
  }

  /** @returns {{name: string, duration: number}[]} seconds */
  get animations() {
    return this.#model.animations.map(({ name, duration }) => ({ name, duration }));
  }

  /** The camera of the last picture. */
  get camera() {
    return this.#camera;
  }

  /** What draws: the GL's own name. */
  get glName() {
    const gl = this.#renderer.getContext();
    const info = gl.getExtension('WEBGL_debug_renderer_info');
    return gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  }

  /** A canvas cannot change its antialiasing: one renderer for each way. */
  #rendererFor(resolved) {
    const parameters = rendererParameters(resolved);
    const key = JSON.stringify(parameters);
    if (!this.#renderers.has(key)) {
      const renderer = new THREE.WebGLRenderer({ ...parameters, preserveDrawingBuffer: true });
      this.#renderers.set(key, renderer);
    }
    return this.#renderers.get(key);
  }

  async #environment(map) {
    const { format } = this.#environments.find((known) => known.map === map) ?? {};
    if (!format) return undefined;
    const loader = format === 'exr' ? new (await import('three/addons/loaders/EXRLoader.js')).EXRLoader() : new HDRLoader();
    return this.#file(`environment/${encodeURIComponent(map)}`, loader.setDataType(THREE.FloatType));
  }

  #cloth(preset) {
    return this.#file(`page/cloths/${preset}.glb`, this.#loader);
  }

  /** Of the server, loaded once. What has not come is asked for again. */
  #file(path, loader) {
    if (!this.#files.has(path)) {
      const loading = loadedBy(loader, path);
      this.#files.set(path, loading);
      loading.catch(() => this.#files.delete(path));
    }
    return this.#files.get(path);
  }

  /** What its parts are called. */
  get names() {
    return namesOf(this.#model);
  }

  /** Draws a resolved shot; one at a time. */
  async draw(resolved) {
    const renderer = this.#rendererFor(resolved);
    const environment = await this.#environment(resolved.environment.map);
    this.#camera = await applyShot(resolved, {
      THREE,
      renderer,
      scene: this.#scene,
      camera: this.#camera,
      model: this.#model,
      environment,
      cloths: (preset) => this.#cloth(preset),
      areaLightTables: () => import('three/addons/lights/RectAreaLightUniformsLib.js'),
    });
    renderer.render(this.#scene, this.#camera);
    if (renderer !== this.#renderer) this.#place.replaceChildren(renderer.domElement);
    this.#renderer = renderer;
    this.#depths = undefined;
    this.onDraw();
  }

  /**
   * The point of the garment that the last picture shows at a place.
   * @param {number[]} place parts of its width and height, from the top left corner
   * @returns {number[] | undefined} metres; undefined beside the garment
   */
  pick([x, y]) {
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2(2 * x - 1, 1 - 2 * y), this.#camera);
    const isShown = (object) => object === null || (object.visible && isShown(object.parent));
    const hits = ray.intersectObject(this.#model.scene, true);
    // A shot leaves parts out by their materials.
    return hits.find(({ object }) => object.isMesh && object.material.visible && isShown(object))?.point.toArray();
  }

  /**
   * Where the last picture shows a point.
   * @param {number[]} point metres
   * @returns {number[] | undefined} as pick's place; undefined behind the camera
   */
  project(point) {
    const at = new THREE.Vector3(...point).project(this.#camera);
    return at.z < 1 && at.z > -1 ? [(at.x + 1) / 2, (1 - at.y) / 2] : undefined;
  }

  /**
   * Whether the garment hides a point from the last picture.
   * @param {number[]} point metres
   */
  hides(point) {
    const at = new THREE.Vector3(...point).project(this.#camera);
    if (!(at.z < 1 && at.z > -1)) return false;
    const model = this.#model.scene;
    this.#diagonal ??= new THREE.Box3().setFromObject(model).getSize(new THREE.Vector3()).length();
    this.#depths ??= new Depths({ THREE, renderer: this.#renderer, scene: this.#scene, camera: this.#camera, model });
    return this.#depths.hides([(at.x + 1) / 2, (1 - at.y) / 2], (at.z + 1) / 2, this.#diagonal);
  }

  /** @returns {number[]} the direction from what the last picture shows to the viewer */
  get back() {
    return this.#camera.getWorldDirection(new THREE.Vector3()).negate().toArray();
  }

  /** @returns {import('../../compare/image.mjs').Image} the last picture */
  pixels() {
    const { width, height, buffer } = this.#drawingBuffer();
    return { width, height, data: straightPixels(buffer, width, height) };
  }

  /**
   * Where the object is, before a background whose alpha does not tell: the last picture is drawn without it, and again.
   * @returns {Uint8Array | undefined} alpha of each pixel; undefined where the picture has no background
   */
  mask() {
    const { background } = this.#scene;
    if (!background) return undefined;
    this.#scene.background = null;
    this.#renderer.render(this.#scene, this.#camera);
    const { width, height, buffer } = this.#drawingBuffer();
    this.#scene.background = background;
    this.#renderer.render(this.#scene, this.#camera);
    return alphaOf(buffer, width, height);
  }

  #drawingBuffer() {
    const gl = this.#renderer.getContext();
    const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    const buffer = new Uint8Array(width * height * 4);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, buffer);
    return { width, height, buffer };
  }

  /** A colour of a resolved shot as `#rrggbb`. */
  static hexOf([r, g, b]) {
    return `#${new THREE.Color().setRGB(r, g, b, THREE.LinearSRGBColorSpace).getHexString(THREE.SRGBColorSpace)}`;
  }
}
