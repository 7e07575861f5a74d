import os from 'node:os';
import { toTelarError } from '../error/index.mjs';
import { keptCalibrations } from './calibration.mjs';
import { nativeCall } from './native_call.mjs';
import { isolationSteps, loadNative, nativePath, workerLibrary } from './native.mjs';
import { defaultCache } from './options.mjs';
import { versions } from './versions.mjs';

/** Documented in js/api/doctor.d.ts. */
export async function doctor() {
  const report = { ok: false, versions, system: `${os.type()} ${os.release()} ${os.arch()}`, calibration: await keptCalibrations(defaultCache()) };
  try {
    const native = loadNative();
    const probe = JSON.parse(await nativeCall(native, undefined, () => native.probe()));
    const reference = JSON.parse(await nativeCall(native, undefined, () => native.probeReference()));
    const failure = await nativeCall(native, undefined, () => native.failureOfImageFiles());
    const imageFiles = failure ? { works: false, failure } : { works: true };
    const { failure: absent } = workerLibrary();
    const isolation = isolationSteps(await nativeCall(native, undefined, () => native.probeIsolation(absent === null)), absent);
    return { ...report, ok: probe.chosen !== null, native: { path: nativePath() }, ...probe, reference, imageFiles, isolation };
  } catch (error) {
    return {
      ...report,
      native: { error: toTelarError(error).toJSON() },
      chosen: null,
      reason: error.message,
      backends: [],
      reference: { works: false, failure: error.message },
      imageFiles: { works: false, failure: error.message },
      isolation: [],
    };
  }
}
