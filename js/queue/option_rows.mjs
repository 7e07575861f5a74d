import { number } from '../shot/table/rows.mjs';

/** Rows of the tables of options of queue and service: numbers with their flag of the command line. */

/**
 * @typedef {import('../shot/table/rows.mjs').Row & {flag?: string, of?: 'server'}} OptionRow
 * of: 'server' where the server that `telar serve` makes reads it, and not the plugin
 */

export const HOUR = 3_600_000;
export const MIB = 2 ** 20;

/** @returns {OptionRow} */
export const whole = (doc, { flag, of, ...rest }) => ({ ...number(doc, { what: 'a whole number', integer: true, ...rest }), flag, of });

/** @returns {OptionRow} from 1 ms to a day unless said otherwise */
export const milliseconds = (doc, flag, rest) => whole(doc, { flag, unit: 'milliseconds', min: 1, max: 24 * HOUR, ...rest });
