// What the package exports. Each part is declared beside what it describes, in js/api.

export type { AnimationFact, Box, CameraFact, PartFact, ShotFacts, Vec3 } from './shot/index.js';
export type { Quantity, ResolvedShot, Shot } from './shot/shot.js';

export { TelarError, toTelarError } from './error/index.js';
export type { ErrorCode, ErrorKind, LimitFact, PlainError } from './error/index.js';

export * from './api/loading.js';
export * from './api/facts.js';
export * from './api/measure.js';
export * from './api/flat.js';
export * from './api/model.js';
export * from './api/picture.js';
export * from './api/renderer.js';
export * from './api/inspect.js';
export * from './api/picture_key.js';
export * from './api/bake.js';
export * from './api/lobes.js';
export * from './api/doctor.js';
export * from './api/versions.js';
export * from './api/animated_webp.js';
