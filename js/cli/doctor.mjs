import { TABLE } from '../error/table.mjs';

/**
 * telar doctor
 * Which GL backends exist, which one is taken and why, what is missing and the cure.
 * @param {object} _options
 * @param {import('./console.mjs').Io & {api: object, console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} 0, or the exit code of a machine that cannot draw
 */
export async function doctor(_options, context) {
  const report = await context.api.doctor();
  await context.console.result(report, reportLines(report));
  return report.ok ? 0 : TABLE.X_GL.exit;
}

function backendLines({ backend, works, failure, cure, vendor, renderer, version, software }) {
  if (!works) return [`  ${backend}: no: ${failure}`, ...(cure ? [`    cure: ${cure}`] : [])];
  const facts = [renderer ?? vendor, version, software ? 'in software' : undefined].filter(Boolean);
  return [`  ${backend}: ${facts.join(', ')}`];
}

/** What the kernel refuses to a worker of the pool. */
function isolationLine(isolation) {
  const refused = isolation.filter(({ failure }) => failure !== null).map(({ step, failure }) => `${step} (${failure})`);
  return `workers     ${refused.length === 0 ? isolation.map(({ step }) => step).join(', ') : `without ${refused.join(', ')}`}`;
}

/** What {budgetMs} goes by. */
function calibrationLines(calibration) {
  const all = Object.entries(calibration);
  if (all.length === 0) return ['speed       not measured yet: the first picture with quality {budgetMs} does it'];
  return all.map(([gl, { raster, tracer }]) => `speed       ${raster.toFixed(0)} ms the raster, ${tracer.toFixed(0)} ms the tracer, for its sample by ${gl}`);
}

function reportLines({ versions, system, native, chosen, reason, backends, reference, imageFiles, isolation = [], calibration = {} }) {
  return [
    `telar       ${versions.telar}, node ${versions.node}`,
    `system      ${system}`,
    `native      ${native.error ? native.error.message : native.path}`,
    'backends',
    ...backends.flatMap(backendLines),
    `reference   ${reference.works ? reference.version : `no: ${reference.failure}`}`,
    `image files ${imageFiles.works ? 'all' : `PNG, JPEG and WebP alone: ${imageFiles.failure}`}`,
    ...(isolation.length > 0 ? [isolationLine(isolation)] : []),
    ...calibrationLines(calibration),
    chosen ? `chosen      ${chosen}: ${reason}` : `chosen      none: ${reason}`,
  ];
}
