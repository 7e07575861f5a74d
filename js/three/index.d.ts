import type { CameraFact, PartFact } from '../shot/index.js';
import type { ResolvedShot } from '../shot/shot.js';

// three.js brings no types of its own: its objects pass through as they are.
type Three = any;

/**
 * Parameters that a THREE.WebGLRenderer must be built with.
 * @example
 * const shot = resolveShot({}, factsOf(gltf, { THREE }));
 * const webgl = new THREE.WebGLRenderer(rendererParameters(shot));
 */
export function rendererParameters(shot: ResolvedShot): { antialias: boolean; alpha: boolean; premultipliedAlpha: boolean };

/**
 * Sets up a scene of the client's own three.js, 0.150 or later, from a resolved shot, so that browser and server draw the same picture.
 * @returns the camera to draw with
 * @example
 * const shot = resolveShot({}, factsOf(gltf, { THREE }));
 * const webgl = new THREE.WebGLRenderer(rendererParameters(shot));
 * const scene = new THREE.Scene();
 * scene.add(gltf.scene);
 * const camera = await applyShot(shot, { THREE, renderer: webgl, scene, model: gltf, environment: await new HDRLoader().loadAsync('studio.hdr') });
 * webgl.render(scene, camera);
 */
export function applyShot(shot: ResolvedShot, target: {
  /** The client's own three.js module. */
  THREE: Three;
  renderer: Three;
  scene: Three;
  camera?: Three;
  /** What GLTFLoader gave: {scene, parser}. */
  model?: Three;
  /**
   * Linear equirectangular texture; required where the shot has an environment. Loaded as FloatType it keeps suns above 65504, which
   * light every shading but "three".
   */
  environment?: Three;
  /**
   * Gives three's tables of rect lights, `() => import('three/addons/lights/RectAreaLightUniformsLib.js')`: called for the
   * first shot with such a light, required there.
   */
  areaLightTables?: () => Promise<Three>;
  /** Gives telar/cloths/PRESET.glb as GLTFLoader loads it; called for the presets of the shot's `materials`. */
  cloths?: (preset: string) => Promise<Three>;
  /**
   * Where the shot names another release of three.js than THREE is, and the two draw differently: "shot", the default, warns on the
   * console; "client" writes the client's release into `shot.shading`, so that the server, handed the same shot, draws as this client does.
   */
  revision?: 'shot' | 'client';
}): Promise<Three>;

/**
 * What resolveShot needs to know of a model that GLTFLoader gave, measured as the server measures it. Metres, world space.
 * The model takes the pose and keeps it.
 * @example
 * const shot: Shot = { camera: { frame: { node: 'Sleeve' } } };
 * const pose = resolvePose(shot, { animations: gltf.animations });
 * const resolved = resolveShot(shot, factsOf(gltf, { THREE, pose, frame: shot.camera?.frame }));
 */
export function factsOf(model: { scene: Three; parser?: Three; animations?: Three[] }, options: {
  THREE: Three;
  /** As `resolvePose(shot, {animations: model.animations})` of telar/shot gives it; default null, as the file stands. */
  pose?: ResolvedShot['pose'];
  /** The shot's `camera.frame`: where it names a node or a material, that is measured too. */
  frame?: unknown;
  /** The shot's `variant`, in which a material is looked for. Default '', the file's own materials. */
  variant?: string;
  /** The shot's `ghost`: bounds, outline and `part` are without what it leaves out. */
  ghost?: readonly object[];
}): {
  bounds: { min: number[]; max: number[] } | null;
  /** Drawn vertices that lie farthest out. */
  outline: number[][];
  /** As the shot's explicit camera, with a name; far is null where the file says infinite. */
  cameras: Array<Omit<CameraFact, 'node'>>;
  variants: string[];
  /** Duration in seconds. */
  animations: Array<{ name: string; duration: number }>;
  /** What `frame` measures. */
  part?: PartFact;
};

/**
 * Puts a model into a pose, or back as the file stands.
 * @example
 * applyPose(gltf, { animation: 0, time: 0.5 }, { THREE });
 * applyPose(gltf, null, { THREE });
 */
export function applyPose(model: { scene: Three; animations?: Three[] }, pose: ResolvedShot['pose'], three: { THREE: Three }): void;

/**
 * Draws a model's lit materials with a shading, or with its own materials again for "three". Part of applyShot; for clients that
 * set up their scenes by themselves.
 * @example
 * await applyShading(gltf, 'fabric', { THREE });
 */
export function applyShading(model: { scene: Three; parser?: Three }, shading: ResolvedShot['shading'], three: { THREE: Three }): Promise<void>;

/** Of the glTF extension TELAR_materials_fabric (js/docs/fabric.md), with THREE.Texture in place of references to textures. */
export interface Fabric {
  /** 0..1, from Lambert's diffuse to that of a thin scattering sheet. Default 0. */
  flatness?: number;
  /** Two sets of parallel yarns; warp runs along v, weft along u. */
  weave?: {
    warp?: Yarn;
    weft?: Yarn;
    /** Yarns that one unit of u crosses (warp) and of v (weft); 0 = not known. */
    threadsPerUv?: [number, number];
    /** Linear: RG the turn of the yarn on top, B its slope, A 0 weft .. 1 warp. */
    weaveTexture?: Three;
  };
  /** What the back side has of its own. */
  back?: {
    /** Linear Rec.709. */
    baseColorFactor?: [number, number, number];
    /** sRGB. */
    baseColorTexture?: Three;
    /** Perceptual; default that of the front. */
    roughnessFactor?: number;
  };
}

export interface Yarn {
  /** Share of the surface that shows it, 0..1. Default 0.5. */
  coverage?: number;
  /** Perceptual, across the yarn. Default 0.5. */
  roughnessFactor?: number;
  /** 0..1. Default 0. */
  anisotropyStrength?: number;
  /** Factor on its normal reflectance, linear Rec.709. Default white. */
  specularColorFactor?: [number, number, number];
}

/** Of the glTF extension KHR_materials_diffuse_transmission, with THREE.Texture in place of references to textures. */
export interface DiffuseTransmission {
  /** Share of the diffuse light that goes through to the other side, 0..1. Default 0. */
  diffuseTransmissionFactor?: number;
  /** Linear: A. */
  diffuseTransmissionTexture?: Three;
  /** Linear Rec.709. Default white. */
  diffuseTransmissionColorFactor?: [number, number, number];
  /** sRGB. */
  diffuseTransmissionColorTexture?: Three;
}

/**
 * The class FabricMaterial for a three.js module: a MeshPhysicalMaterial that is shaded as cloth, with three.js's own lights,
 * shadows, environment, maps and deformations. Fetches the shader text the first time.
 * @example
 * const FabricMaterial = await loadFabricMaterial(THREE);
 * const twill = new FabricMaterial({ color: '#23324f', fabric: { flatness: 0.5, weave: { warp: { coverage: 0.7 }, weft: { coverage: 0.3 }, threadsPerUv: [40, 30] } } });
 */
export function loadFabricMaterial(THREE: Three): Promise<new (parameters?: {
  fabric?: Fabric | null;
  diffuseTransmission?: DiffuseTransmission | null;
  /** Whether the geometries have tangents, along which a weave without a normal map stands. Default false: along the texture coordinates. */
  hasTangents?: boolean;
  [parameterOfMeshPhysicalMaterial: string]: Three;
}) => Three>;
