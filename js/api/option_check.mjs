import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';

/** @returns {TelarError} E_OPTION */
export const wrongOption = (name, expected, value) => new TelarError('E_OPTION', `${name}: expected ${expected}, got ${shown(value)}`);

export const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);
