import { zodOf } from '../shot/schema.mjs';
import { SHEET } from './table/index.mjs';

/** What checks a spec, made of its table. */
export const specSchema = zodOf(SHEET);
