import { Option } from 'commander';
import { OPTIONS } from '../server/table.mjs';

/** Flags of `telar serve`, from the table of the service's options. */

/** Numbers as such; what is none is told by the table's own message. */
const numberOf = (text) => (/^\d{1,15}$/.test(text) ? Number(text) : text);

const collect = (value, list = []) => [...list, value];

/** @param {string} name of OPTIONS @returns {Option} */
export function serviceFlag(name) {
  const { flag, doc, kind, values, default: value } = OPTIONS[name];
  const isSaid = value !== undefined && typeof value !== 'boolean' && !Array.isArray(value);
  const option = new Option(flag, kind === 'boolean' ? `do not: ${doc}` : `${doc}${isSaid ? ` (${value} by default)` : ''}`);
  if (values) option.choices(values);
  if (kind === 'number') option.argParser(numberOf);
  if (kind === 'list') option.argParser(collect);
  return option;
}

/** @param {import('commander').Command} command */
export function addServiceOptions(command) {
  for (const name of Object.keys(OPTIONS)) command.addOption(serviceFlag(name));
  return command;
}
