import { createSheet, firstSpec } from '../sheet/index.mjs';

/**
 * `sheet` of a pool, in a worker: it draws and measures there, and sets the pages.
 * @param {{renderer: object, source: unknown, others: Record<string, Uint8Array>, shots: object[], options: object, args: [{spec: object | null,
 *   name: string, format: string, templates: object, previous?: object, images: string[] | null, fonts: number}], limits: object, parts: Buffer[]}} job
 * @returns {Promise<{format: string, info: object}>} the files go to the parts
 */
export async function sheetJob({ renderer, source, others, shots, options, args: [asked], limits, parts }) {
  const { timeoutMs, signal, onProgress } = options;
  const { spec, name, format, templates, previous, images, fonts } = asked;
  const model = spec || source.facts ? source : await renderer.load(source, { signal, ...(timeoutMs !== undefined && { timeoutMs }) });
  const { files, info } = await createSheet(model, spec ?? firstSpec(model.facts, { name }), {
    renderer,
    format,
    templates,
    ...(previous && { previous }),
    fonts: Array.from({ length: fonts }, (_, i) => others[`font ${i}`]),
    ...(images && { resolve: (name) => (images.includes(name) ? others[`image ${name}`] : null) }),
    shot: shots[0],
    limits,
    ...(timeoutMs !== undefined && { timeoutMs }),
    signal,
    onProgress,
  });
  parts.push(...files);
  return { format, info };
}
