/**
 * The one table of telar's error and warning codes: the API, `--json` of the CLI, HTTP problem+json and queue results
 * all read it. A code is never reused for another meaning.
 *
 * Prefixes: E_ the caller's input, L_ a limit that the input went over, X_ this process or machine, W_ a warning.
 */

/**
 * What a kind of error means to the caller.
 * exit: exit code of the CLI; http: status of the HTTP service; retryable: the same call may succeed later.
 */
export const KINDS = Object.freeze({
  usage: { exit: 2, http: 400, retryable: false },
  input: { exit: 3, http: 422, retryable: false },
  denied: { exit: 3, http: 422, retryable: false },
  unsupported: { exit: 3, http: 415, retryable: false },
  limit: { exit: 4, http: 413, retryable: false },
  time: { exit: 5, http: 504, retryable: true },
  memory: { exit: 5, http: 507, retryable: true },
  cancelled: { exit: 5, http: 499, retryable: true },
  busy: { exit: 5, http: 429, retryable: true },
  machine: { exit: 6, http: 500, retryable: false },
  crash: { exit: 7, http: 500, retryable: true },
  internal: { exit: 7, http: 500, retryable: false },
  warning: { exit: 0, http: 200, retryable: false },
});

/** Exit code of a comparison that ran well and found the images over the gate. Not an error, so it has no code. */
export const EXIT_OVER_THE_GATE = 1;

const FIX_FILE = 'Export the model again; gltf-validator names the same fault in more detail.';
const RAISE = 'Reduce the file, or raise this limit for files that you trust.';

/** Rows by kind: code: [meaning, cure, differences from the kind's row]. */
const ROWS = {
  usage: {
    E_USAGE: ['A command, option or argument is wrong', 'See `telar --help`.'],
    E_SHOT: ['A value of the shot is wrong', 'The message names its path, what is expected and what was given.'],
    E_SPEC: ['A value of the spec of a sheet is wrong', 'The message names its path, what is expected and what was given.'],
    E_OPTION: ['An option of the API is wrong', 'The message names the option, what is expected and what was given.'],
    E_REQUEST: ['A request over HTTP is malformed, or a value of it is wrong', 'The message names the value, what is expected and what was given.'],
    E_NOT_FOUND: ['The service has no such route, model or job', '/openapi.json lists the routes.', { http: 404 }],
    E_METHOD: ['The route takes another method', 'The header `allow` names it.', { http: 405 }],
    E_ACCEPT: ['The answer is of none of the types that the request accepts', 'The message names the types; send another header `accept`.', { http: 406 }],
    E_PRECONDITION: ['The answer is the one that `if-none-match` names', 'Use the one that you have.', { http: 412 }],
    E_MEDIA_TYPE: ['The body of the request is of a type that the route does not take', 'The message names the types that it takes.', { http: 415 }],
  },
  input: {
    E_EMPTY: ['The file has no bytes', 'Check the export or the upload.'],
    E_FILE: ['A file named by the caller cannot be read', 'Check the path and the permissions.'],
    E_NOT_GLTF: ['The file is neither GLB nor glTF JSON', 'Give a .glb or .gltf file, not an archive or a page.'],
    E_GLB_HEADER: ['The GLB header is incomplete', FIX_FILE],
    E_GLB_VERSION: ['The GLB container is not version 2', 'Export as glTF 2.0.'],
    E_GLB_LENGTH: ['The GLB length does not match the file', 'The file was cut or padded: transfer it again.'],
    E_GLB_CHUNK: ['A GLB chunk is missing, misplaced or has a wrong length', FIX_FILE],
    E_JSON: ['The glTF JSON is not well formed', FIX_FILE],
    E_VERSION: ['The asset is not glTF 2.x', 'Export as glTF 2.0.'],
    E_SCHEMA: ['A glTF property is missing, of a wrong type or out of range', FIX_FILE],
    E_REF: ['An index names an object that does not exist', FIX_FILE],
    E_GRAPH: ['The node graph has a cycle or a node with two parents', FIX_FILE],
    E_BUFFER: ['A buffer has fewer bytes than it declares', FIX_FILE],
    E_BUFFERVIEW: ['A buffer view leaves its buffer', FIX_FILE],
    E_STRIDE: ['A byte stride is wrong for its accessor', FIX_FILE],
    E_ACCESSOR: ['An accessor leaves its buffer view or has a wrong type', FIX_FILE],
    E_SPARSE: ['A sparse accessor is inconsistent', FIX_FILE],
    E_INDEX: ['A vertex index is not below the vertex count', FIX_FILE],
    E_ANIMATION: ['An animation is inconsistent', FIX_FILE],
    E_INSTANCING: ['The instances of a mesh are inconsistent', FIX_FILE],
    E_SKIN: ['A skin is inconsistent', FIX_FILE],
    E_NO_GEOMETRY: ['The scene has nothing to draw', 'Check that the exported scene holds the garment.'],
    E_EXTENT: ['The model, or its part that is framed, is too small to be drawn', 'glTF is in metres: check the unit and the scale of the export.'],
    E_IMAGE_FORMAT: [
      'A texture is not PNG, JPEG, WebP or KTX2, is KTX2 of a kind that is not drawn, or is KTX2 without KHR_texture_basisu',
      'Export textures as PNG, JPEG, WebP, or KTX2 in ETC1S, UASTC or RGBA8 by KHR_texture_basisu.',
    ],
    E_IMAGE_CORRUPT: ['A texture is damaged or cut', 'Export the texture again.'],
    E_IMAGE_SIZE: ['Two images to compare differ in size', 'Draw both at one size.'],
    E_DRACO: ['Draco data is damaged or contradicts its accessors', FIX_FILE],
    E_MESHOPT: ['meshopt data is damaged, or of a kind that is not read', FIX_FILE],
    E_URI_DATA: ['A data: URI is malformed', FIX_FILE],
    E_URI_MISSING: ['An external file is not there', 'Put it beside the model, or export a single .glb.'],
    E_ENVIRONMENT_FORMAT: ['The environment is neither .hdr nor .exr', 'Give an equirectangular .hdr or .exr map.'],
    E_ENVIRONMENT_CORRUPT: ['The environment is damaged or cut', 'Save the map again.'],
    E_ENVIRONMENT_MISSING: ['The environment file does not exist, is a folder or cannot be read', 'Check the path and the permissions.'],
    E_VARIANT: ['The model has no such material variant', '`telar inspect` lists the variants.'],
    E_POSE: ['The model has no such animation', '`telar inspect` lists the animations.'],
    E_CLOTH: [
      'No material or node of the model has this name, or the cloth that it is to be shown in has no material',
      '`telar inspect` lists the materials; the message names what it has.',
    ],
    E_FRAME: ['The model has no such node or material to frame, or to draw as a ghost', 'The message names what it has; `telar inspect` lists the materials.'],
    E_MEASURE: ['What is to be measured is not there, or no way over the surface joins it', 'The message names the point, the part or the gap.'],
    E_CAMERA: ['The model has no such camera, or one that cannot be drawn from', '`telar inspect` lists the cameras.'],
    E_WARNING: ['The model or the shot gives a warning, and `failOn` is "warning"', 'The message holds the warning, whose code has a row of its own.'],
  },
  denied: {
    E_SIGNATURE: [
      'The address of a thumbnail is not signed by a key of the service, or its time is over',
      'Ask who gave the address for a new one; `telar sign` makes them.',
      { http: 403 },
    ],
    E_URI_DENIED: ["A URI leads out of the model's folder, or there is no folder", 'Embed the file, or put it beneath the model.'],
  },
  unsupported: {
    E_EXT_REQUIRED: ['The model requires a glTF extension that telar does not have', 'Export without that extension.'],
    E_SHOT_UNAVAILABLE: ['The shot asks for something that this version does not have', 'Leave it out, or use a later version.'],
  },
  limit: {
    L_MEMORY_BYTES: ['The model takes too much memory', RAISE],
    L_FILE_BYTES: ['A file is too large', RAISE],
    L_EXTERNAL_BYTES: ['The external files are too large together', RAISE],
    L_EXTERNAL_FILES: ['Too many external files', RAISE],
    L_JSON_BYTES: ['The glTF JSON is too large', RAISE],
    L_JSON_DEPTH: ['The glTF JSON is nested too deep', RAISE],
    L_JSON_VALUES: ['The glTF JSON has too many values', RAISE],
    L_NODES: ['Too many nodes', RAISE],
    L_NODE_DEPTH: ['The node tree is too deep', RAISE],
    L_DRAW_CALLS: ['Too many primitives to draw', RAISE],
    L_VERTICES: ['Too many vertices', RAISE],
    L_TRIANGLES: ['Too many triangles, lines or points', RAISE],
    L_BUFFERS: ['Too many buffers', RAISE],
    L_BUFFER_VIEWS: ['Too many buffer views', RAISE],
    L_ACCESSORS: ['Too many accessors', RAISE],
    L_MATERIALS: ['Too many materials', RAISE],
    L_TEXTURES: ['Too many textures', RAISE],
    L_IMAGES: ['Too many images', RAISE],
    L_MESHOPT_BYTES: ['The meshopt buffer views are too large together when decompressed', RAISE],
    L_IMAGE_DIMENSION: ['A texture is too wide or too high', RAISE],
    L_IMAGE_PIXELS: ['A texture has too many pixels', RAISE],
    L_IMAGE_BYTES: ['The decoded textures are too large together', RAISE],
    L_IMAGE_SCANS: ['A progressive JPEG has too many scans', RAISE],
    L_OUTPUT_SIZE: ['The image is wider or higher than this GL can draw', 'Ask for a smaller size, or use another backend.'],
    L_LIGHTS: ['Too many lights', RAISE],
    L_SHADOW_TEXELS: ['The shadow maps are too large together', 'Let fewer lights cast shadows, or give them a smaller shadow.mapSize.'],
    L_TEXTURE_UNITS: [
      'A material has too many textures for the lights that cast shadows',
      'Let fewer lights cast shadows: each takes one of the 16 textures of a WebGL 2 program.',
    ],
    L_ENVIRONMENT_PIXELS: ['The environment has too many pixels', RAISE],
    L_PROGRAMS: ['The scene needs too many shader programs', RAISE],
    L_FRAGMENTS: [
      'Too much is drawn over one another',
      'Reduce what the model stacks, or the size of the picture; or raise this limit for files that you trust.',
    ],
    L_MEASURE: ['A length along the surface takes too much work', 'Measure a part of the model, or in shorter steps.'],
    L_INSTANCES: ['Too many instances', RAISE],
    L_VISIBILITY_RAYS: [
      'Too many rays for the ambient visibility of so many vertices',
      'Ask for fewer rays, reduce the file, or raise this limit for files that you trust.',
    ],
    L_KEYFRAME_VALUES: ['The animations have too many keyframes', RAISE],
    L_MORPH_TARGETS: ['Too many morph targets', RAISE],
    L_REQUEST_BYTES: ['A request, or a part of it, is too large', 'Send less, or let the owner of the service raise `requestBytes`.'],
    L_OUTPUT_BYTES: ['The pictures of a job are too large together for this pool', 'Ask for fewer or smaller ones, or raise `outputBytes` of createPool.'],
  },
  time: {
    X_TIMEOUT: ['The work took longer than allowed', 'Try again; reduce the model, the size or the quality.'],
    X_UPLOAD_TIME: ['The body of a request came too slowly', 'Send it faster, or let the owner of the service raise `uploadMs`.', { http: 408 }],
  },
  memory: {
    X_MEMORY: ['There is not enough memory', 'Reduce the model or the size, or give the process more memory.'],
    X_GL_MEMORY: ['The GL driver has not enough memory', 'Reduce the model or the size, or use another backend.'],
  },
  cancelled: {
    X_CANCELLED: ['The caller cancelled the work', 'Nothing to cure.'],
    X_CLOSED: ['The renderer or pool was closed', 'Create a new one.', { retryable: false }],
  },
  busy: {
    X_BUSY: ['Too much work is waiting', 'Send the request again later.'],
    X_SHUTDOWN: ['The service is ending', 'Send the request again: another one, or the next one, answers.', { http: 503 }],
  },
  machine: {
    X_GL: ['No OpenGL ES 3.0 context', '`telar doctor` says what is missing and the cure.'],
    X_GL_LOST: ['The GL context was lost', 'Try again; a new context is made.', { retryable: true }],
    X_OUTPUT: ['The image cannot be encoded or written', 'The message says why; check free space, the folder and its permissions.'],
    X_NATIVE_MISSING: ['The native part of telar is not built or does not load', 'Run `npm run build`; see the message.'],
    X_PORT: ['The port of a local page is taken', 'Name another one, or none to get a free one.'],
    X_INSTALL: ['A file of telar itself is missing', 'Install telar again.'],
    X_RESOLVE: ['The option `resolve` of the caller failed', "See the error's cause.", { retryable: true }],
    X_REFERENCE: ['The path tracer does not start on this machine', 'Report it with the message and the output of `telar doctor --json`.'],
    X_SHEET: [
      'The template of a sheet does not lay it out',
      'The message holds what the layout engine says: of an own template correct it, of telar report it.',
    ],
    X_SOURCE: [
      'The host that has the model does not give it',
      'The message says what it answers. Try again, or upload the model.',
      { retryable: true, http: 502 },
    ],
    X_WORKERS: [
      'The workers of a pool do not start',
      'The message says why; the pool tries again by itself. `telar doctor` says what is missing.',
      { retryable: true, http: 503 },
    ],
    X_QUEUE: [
      'The queue of jobs is not there, is not set up as it has to be, or has lost what belongs to a job',
      'The message says which. Try again; js/docs/queue.md says how a queue has to be set up.',
      { retryable: true, http: 503 },
    ],
    X_LIBRARY_MISSING: ['A library that this job needs is not installed', 'Install the package that the message names.'],
  },
  crash: {
    X_CRASH: [
      'The worker that drew this ended in the middle of it',
      'Try again once; `signal` says how it ended, and `input` which file it drew. Report a file that does it twice.',
    ],
    X_QUARANTINE: [
      'The file ended two workers of this pool in a row, or the job as many as `poison` of its queue says; it is refused for a while',
      'Report the file whose digest is `input`; `quarantineMs` of createPool and of openQueue is how long.',
      { retryable: false, http: 422 },
    ],
  },
  internal: {
    X_INTERNAL: ['A fault of telar itself', 'Report it together with the model and the shot.'],
    X_SHADER: ['A shader did not compile or link', 'Report it with the output of `telar doctor`.'],
  },
  warning: {
    W_ANIMATION: ['A channel of an animation moves nothing that is drawn', 'The other channels of the animation are played.'],
    W_EMPTY: [
      'The picture shows next to nothing of the model: less than 0.1 % of its pixels',
      'Let a view frame the model (leave out the camera), and check the opacity of its materials.',
    ],
    W_EXPOSURE: [
      'More than half of the model is black, white or saturated in the picture',
      'Change the exposure, the lights or the environment. Unlit materials of pure colours are meant so.',
    ],
    W_QUEUE: ['The queue of jobs is kept where jobs can be lost', 'The message names the setting; js/docs/queue.md says what it has to be.'],
    W_ENUM: ['An unknown enumeration value was replaced by its default', FIX_FILE],
    W_CAMERA: ['A camera is malformed and was left out', FIX_FILE],
    W_ENVIRONMENT_RANGE: [
      'Texels of the environment are brighter than a half float can be, and are cut as three.js cuts them',
      'Use another shading than "three", whose suns keep their light, or limit the map to 65504 for both sides.',
    ],
    W_THREE_REVISION: [
      'The release of three.js that the shading names is drawn as another one',
      'Name a release of js/docs/families.md, and let the client use one: the message says which is drawn.',
    ],
    W_LENS: ['The depth of field of the lens is not drawn', 'Ask for quality "reference", or leave out lens.focusDistance.'],
    W_LIBRARY_MISSING: [
      'The raster draws quality "high" where the path tracer would, for Embree is not there',
      'Install the package that the message names, or give the settings of "high" one by one: the raster draws these everywhere.',
    ],
    W_QUALITY: [
      'No settings are predicted to hold the error or the time that the shot asks for',
      'The picture has the most accurate or the fastest ones: allow more, or take it as it is. `info.goal` has the prediction.',
    ],
    W_LIGHT: ['A light is malformed and was left out', FIX_FILE],
    W_GEOMETRY: ['A primitive has nothing to draw and was left out', FIX_FILE],
    W_SCALE: ["A node's scale is zero or not finite, so its mesh is not drawn", FIX_FILE],
    W_EXT: ['The lists of extensions contradict each other', FIX_FILE],
    W_EXT_REQUIRED: ['A required extension is not drawn, as `failOn` is "none"', 'The picture is what readers without this extension show.'],
    W_EXT_IGNORED: ['An optional extension is not drawn', 'The picture lacks what this extension adds.'],
    W_GLB_CHUNK: ['An unknown GLB chunk was skipped', 'Nothing to cure.'],
    W_IMAGE: ['An image that no material uses is damaged', 'Export the texture again.'],
    W_IMAGE_MIME: ['An image is of another type than it declares', FIX_FILE],
    W_MINMAX: ['The declared bounds of an accessor are wrong and were not used', FIX_FILE],
    W_NONFINITE: ['Vertices that are not finite were dropped', FIX_FILE],
    W_NO_SCENE: ['The file names no scene; all root nodes are drawn', FIX_FILE],
    W_RANGE: ['A value was clamped to its range', FIX_FILE],
    W_SAMPLER: ['A texture sampler is wrong and was replaced by the default', FIX_FILE],
    W_TEXCOORD: ['A texture uses a UV set above TEXCOORD_1 and is not drawn', 'Export the model with the set as TEXCOORD_0 or TEXCOORD_1.'],
    W_CLOTH_UV: [
      'A surface without texture coordinates wears a cloth: the maps of the cloth are not drawn',
      'Unwrap the mesh, or choose a cloth without a pattern.',
    ],
    W_TEXTURE: ['A texture has no usable image and is not drawn', FIX_FILE],
    W_INSTANCING: ['Instances are not drawn as the file says, or not as three.js draws them', 'The message names the reason.'],
    W_SHEET_FIT: ['A part of a sheet finds no room in its figure', 'The message says where it stands instead; use a larger paper, or other views.'],
    W_SHEET_GIRTH: [
      'A girth of a sheet does not close, or does not stay in its plane',
      'An open girth has the length of an open line: check its point and its part, or close gaps with `join`. If it slides when it is drawn tight, leave out `tight`.',
    ],
    W_SHEET_POINT: ['A point of measure lies off the garment', 'The nearest point of the surface, or the nearest line around it, is taken: check the anchors.'],
    W_SHEET_ROUND: [
      'A length of the spec of a sheet is printed as another one',
      'The message says which: print it in the `units` of the spec, or give it with fewer digits.',
    ],
    W_SHEET_SIDE: ['A call-out stands on the other side than was wished', 'Leave out its side, or give it to fewer call-outs.'],
    W_SKIN: ['A part of a skin is not applied', 'As in three.js; the message names the part.'],
    W_MORPH: ['A part of a morph target is not applied', 'As in three.js; the message names the part.'],
  },
};

/**
 * @typedef {object} ErrorRow
 * @property {string} kind
 * @property {number} exit exit code of the CLI
 * @property {number} http HTTP status
 * @property {boolean} retryable the same call may succeed later
 * @property {string} meaning
 * @property {string} cure
 */

/** @type {Readonly<Record<string, Readonly<ErrorRow>>>} */
export const TABLE = Object.freeze(
  Object.fromEntries(
    Object.entries(ROWS).flatMap(([kind, rows]) =>
      Object.entries(rows).map(([code, [meaning, cure, differences]]) => [code, Object.freeze({ kind, ...KINDS[kind], ...differences, meaning, cure })]),
    ),
  ),
);

/**
 * Exit code of a run over many models: the highest of theirs, so that the most serious class is told
 * (internal 7 over machine 6 over time or memory 5 over limit 4 over input 3 over usage 2 over done 0).
 * @param {Iterable<number>} exits
 */
export const worstExit = (exits) => Math.max(0, ...exits);
