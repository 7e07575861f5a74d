import { Command } from 'commander';

/**
 * The command line's grammar: commands, options, help.
 * @typedef {object} Row a command, or one that has others
 * @property {(command: (name: string, text: string) => Command) => Command} [add] adds it with its options
 * @property {() => Promise<(...args: unknown[]) => Promise<number>>} [load] what does it
 * @property {string} [text] what a command that has others is for
 * @property {Record<string, Row>} [of] these others
 */

const EXIT_CODES =
  'Exit codes: 0 done, 1 over the gate, 2 usage, 3 input, 4 limit, 5 time or memory, 6 this machine, 7 internal or a crash.\n' +
  'Of many models, the highest exit code is told.';

const addRows = (parent, rows, actionOf) => {
  const command = (name, text) => parent.command(name).description(text).allowExcessArguments(false);
  for (const [name, { add, load, text, of }] of Object.entries(rows)) {
    if (of) addRows(command(name, text), of, actionOf);
    else add(command).action(actionOf(load));
  }
  return parent;
};

/**
 * @param {string} version
 * @param {Record<string, Row>} commands by name
 * @param {(load: Row['load']) => (...args: unknown[]) => Promise<void>} actionOf
 * @param {{writeOut: (text: string) => void, writeErr: (text: string) => void}} output of help and complaints
 */
export function buildProgram(version, commands, actionOf, output) {
  const program = new Command('telar')
    .description('Draws garment models on a server as the browser client shows them')
    .version(version, '-V, --version', 'print the version')
    .helpOption('-h, --help', 'print this help')
    .exitOverride()
    .configureOutput({ ...output, getOutHelpWidth: () => 100, getErrHelpWidth: () => 100 })
    .addHelpText('after', `\n${EXIT_CODES}`);
  return addRows(program, commands, actionOf);
}
