/** What a sheet warns of: what the file of its model does, what does not fit the spec, and what its pictures do not show well. */

const kindOf = ({ code, pointer = '' }) => `${code} ${pointer}`;

/**
 * Each once: numbers in a message differ from picture to picture, and every picture repeats what the file warns of.
 * @param {{code: string, message: string, pointer?: string}[][]} lists of the model, of the layout, and of each picture
 */
export function eachOnce(lists) {
  const told = [];
  const said = new Set();
  for (const warnings of lists) {
    // Several of one kind in one list are of several things.
    told.push(...warnings.filter((warning) => !said.has(kindOf(warning))));
    for (const warning of warnings) said.add(kindOf(warning));
  }
  return told;
}
