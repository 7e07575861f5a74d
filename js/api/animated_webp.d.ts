/**
 * An animated WebP file out of still ones of one size, which keep every byte of their pictures.
 * @example
 * const shots = turntable({ output: { format: 'webp' } }, 36).map(({ shot }) => shot);
 * const frames = await renderer.renderAll('shirt.glb', shots);
 * const file = animateWebp(frames.map(({ data }) => data), { frameMs: 80 });
 */
export function animateWebp(frames: readonly Uint8Array[], options?: { /** @default 100 */ frameMs?: number; /** 0 = for ever. @default 0 */ loops?: number }): Buffer;
