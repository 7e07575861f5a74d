import { wrongOption } from './options.mjs';
import { flatOptions } from './flat_options.mjs';
import { svgOf } from './flat_svg.mjs';
import { measuredFor, Model, shownModel, shotModule } from './model.mjs';
import { loadNative } from './native.mjs';
import { nativeCall } from './native_call.mjs';
import { shotJson } from './shot_json.mjs';
import { Work } from './work.mjs';

const MM = 1000;

/**
 * Documented in js/api/model.d.ts as Model.flat.
 * @internal
 */
export async function flatOf(model, shot, options) {
  const { request, style, signal, timeoutMs } = flatOptions(options);
  const native = loadNative();
  const work = new Work(native, signal, timeoutMs);
  const posed = await shownModel(native, model, shot, { work });
  const { resolveShot } = await shotModule();
  const resolved = resolveShot(shot, await measuredFor(native, posed, shot, work));
  const { width, height } = resolved.size;
  const orthographic = resolved.camera.projection === 'orthographic';
  if (style.scale !== undefined && !orthographic) throw wrongOption('options.scale', 'none where the camera is not orthographic', style.scale);
  const asked = JSON.stringify({ ...request, foldLength: request.foldLength * height });
  const lines = JSON.parse(await nativeCall(native, work, (token) => native.drawFlat(Model.sceneOf(posed), shotJson(resolved), asked, token)));
  const flat = { width, height, millimetresPerPixel: orthographic ? (MM * resolved.camera.height) / height : null, ...lines, shot: resolved };
  return { ...flat, svg: svgOf(flat, style) };
}
