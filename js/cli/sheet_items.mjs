import path from 'node:path';

/** What a contact sheet says of each picture. */

const nameOf = ({ model }) => (model === '-' ? 'stdin' : path.parse(model).name);
const parentOf = ({ model }) => path.basename(path.dirname(path.resolve(model)));

/** Whether the values of a property differ. */
const varies = (jobs, of) => new Set(jobs.map(of)).size > 1;

/**
 * The first line names the model: by its folder too where models share a name. The second one has what differs beside.
 * @param {import('./draw_jobs.mjs').Result[]} results
 * @returns {import('./contact_sheet.mjs').SheetItem[]}
 */
export function itemsOf(results) {
  const jobs = results.map(({ job }) => job);
  const models = new Map(jobs.map((job) => [job.model, job]));
  const names = [...models.values()].map(nameOf);
  const areAlike = new Set(names).size < names.length;
  const details = ['variant', 'view'].filter((part) => varies(jobs, (job) => job[part]));
  const hasMany = models.size < results.length;
  return results.map(({ job, file, error }, i) => ({
    begins: hasMany && job.model !== results[i - 1]?.job.model,
    name: areAlike ? `${parentOf(job)} / ${nameOf(job)}` : nameOf(job),
    detail: details.map((part) => job[part]).join('  ·  '),
    ...(error ? { error: `not drawn (${error.code})` } : { file }),
  }));
}

/** So many pictures stand in one row as a group: those of one model, or its views where it has variants too. */
export function groupOf(results, views) {
  const first = results[0]?.job;
  const sameModel = results.filter(({ job }) => job.model === first.model);
  const group = views === undefined ? sameModel : sameModel.filter(({ job }) => job.variant === first.variant);
  return group.length;
}
