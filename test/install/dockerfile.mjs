import { DockerfileParser } from 'dockerfile-ast';

// The Dockerfile as a list of stages, so that what checks it runs its own lines.

/** Instructions that are written as a JSON array: no shell between the signal and the program. */
const EXEC = ['ENTRYPOINT', 'CMD', 'HEALTHCHECK'];

/**
 * @typedef {{keyword: string, text: string, flags: Record<string, string>, words: string[], line: number}} Step
 *   text: the arguments as they stand, without flags
 * @typedef {{name: string, from: string, steps: Step[]}} Stage name: of AS, or its number
 */

/** `$NAME` and `${NAME}` by their values. @param {Record<string, string>} values */
export const expanded = (text, values) => text.replace(/\$(?:\{(\w+)\}|(\w+))/g, (_, braced, plain) => values[braced ?? plain] ?? '');

function stepOf(instruction) {
  const keyword = instruction.getKeyword();
  const text = instruction.getRawArgumentsContent() ?? '';
  return {
    keyword,
    text,
    flags: Object.fromEntries((instruction.getFlags?.() ?? []).map((flag) => [flag.getName(), flag.getValue()])),
    words: EXEC.includes(keyword) ? JSON.parse(text.replace(/^CMD\s+/, '')) : instruction.getArguments().map((argument) => argument.getValue()),
    line: instruction.getRange().start.line + 1,
  };
}

/**
 * @param {string} text - Of the Dockerfile
 * @param {Record<string, string>} [buildArguments] - As --build-arg
 * @returns {Stage[]}
 */
export function stagesOf(text, buildArguments = {}) {
  const values = {};
  const stages = [];
  for (const instruction of DockerfileParser.parse(text).getInstructions()) {
    const step = stepOf(instruction);
    if (step.keyword === 'FROM') {
      stages.push({ name: instruction.getBuildStage() ?? String(stages.length), from: expanded(instruction.getImage(), values), steps: [] });
      continue;
    }
    if (step.keyword === 'ARG' || step.keyword === 'ENV') step.variables = variablesOf(instruction, step.keyword === 'ARG' ? buildArguments : {});
    if (stages.length === 0) Object.assign(values, step.variables);
    else stages.at(-1).steps.push(step);
  }
  return stages;
}

/** Names and values of ARG or ENV. */
function variablesOf(instruction, overrides) {
  const properties = instruction.getProperties?.() ?? [instruction.getProperty()];
  return Object.fromEntries(properties.map((property) => [property.getName(), overrides[property.getName()] ?? property.getValue() ?? '']));
}
