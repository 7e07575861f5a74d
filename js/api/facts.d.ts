import type { AnimationFact, CameraFact, Vec3 } from '../shot/index.js';

export interface Warning {
  code: string;
  message: string;
  /** JSON pointer into the glTF. */
  pointer?: string;
}

/** What is in a model file. */
export interface ModelFacts {
  name: string;
  /** Metres, world space; null when there is nothing to draw. */
  bounds: { min: Vec3; max: Vec3 } | null;
  /** Width, height, depth in metres. */
  size: Vec3;
  nodes: number;
  meshes: number;
  drawCalls: number;
  vertices: number;
  triangles: number;
  fileBytes: number;
  /** Of the file and of the external parts that it names: 64 hex digits. */
  sha256: string;
  /**
   * Of a flat swatch alone: its base colour as a whole, linear Rec.709: the mean over the texels of a texture that repeats, where the garment wears all of
   * it; else, as of a print or an atlas, the mean over the triangles that wear the material, by their area. What is sheer or has holes counts by what
   * covers; where nothing does, all alike. Null where it is draped, and of a texture that is not coded as sRGB in bytes, whose colour a picture of the
   * square tells.
   */
  meanBaseColor?: [number, number, number] | null;
  materials: Array<{
    name: string;
    alphaMode: 'OPAQUE' | 'MASK' | 'BLEND';
    doubleSided: boolean;
    unlit: boolean;
    metallic: number;
    roughness: number;
    textures: string[];
    /** Of TELAR_materials_fabric; null where it names none. */
    preset: string | null;
    /** What only the shading "fabric" reads, with the material's preset (js/docs/fabric.md); null where there is nothing. */
    fabric: {
      diffuseTransmission?: number;
      flatness?: number;
      /** Coverages, and yarns in one unit of u and v. */
      weave?: { warp: number; weft: number; threadsPerUv: [number, number] };
      back?: true;
    } | null;
    /**
     * Metres that one unit of u and one of v cover, in TEXCOORD_0: medians by area over the file's surfaces of this material; null where they
     * have none. Of inspect alone.
     */
    metresPerUv?: [number, number] | null;
    /** The cloth that the name suggests, for a look at it by `materials` of a shot; it is never applied by itself. Of inspect alone. */
    proposedPreset?: string | null;
  }>;
  /** Width 0: no drawn material uses it, so it was not decoded. */
  images: Array<{
    width: number;
    height: number;
    /** What the file is: "PNG", "KTX2 UASTC zstd". */
    format?: string;
    /** Mip levels that a KTX2 file brings; of other files they are generated. */
    levels?: number;
  }>;
  lights: Array<{
    name: string;
    type: 'directional' | 'point' | 'spot';
    /** Linear Rec.709. */
    color: Vec3;
    intensity: number;
    position: Vec3;
    range: number;
    innerConeAngle?: number;
    outerConeAngle?: number;
  }>;
  cameras: CameraFact[];
  /** In the file's order. */
  animations: AnimationFact[];
  variants: string[];
  /** Of each variant, the indices of the materials that it draws, those of most triangles first, at most 8. */
  variantMaterials: number[][];
  extensionsUsed: string[];
  generator: string;
  copyright: string;
  warnings: Warning[];
}

/** What a render compiles and runs. That of `inspect` tells the wish: where the path tracer is to draw quality "high" and Embree is not there, the raster does. */
export interface Plan {
  features: string[];
  programs: Array<{ features: string[] }>;
  passes: string[];
  /** Whether quality "reference" shows all of it: no points or lines, no glass, no texture in blocks that only a GPU reads, and no ghosts, whose shadow the raster leaves out. Of inspect alone. */
  traceable?: boolean;
  /** Of one pass over the picture and its shadow maps, hidden ones too, at most; counting stops beyond L_FRAGMENTS. Of inspect alone. */
  fragments?: number;
}
