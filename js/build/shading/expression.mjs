// Integer expressions of the preprocessor, of which part is known.

const TOKEN = /\s*(defined\s*\(\s*\w+\s*\)|\d+|[A-Za-z_]\w*|&&|\|\||[=!<>]=|[-+*<>!()])/gy;

/** Operators that bind alike, the loosest first. */
const LEVELS = [['||'], ['&&'], ['==', '!='], ['<', '>', '<=', '>='], ['+', '-'], ['*']];

const OPERATIONS = {
  '||': (a, b) => Number(a !== 0 || b !== 0),
  '&&': (a, b) => Number(a !== 0 && b !== 0),
  '==': (a, b) => Number(a === b),
  '!=': (a, b) => Number(a !== b),
  '<': (a, b) => Number(a < b),
  '>': (a, b) => Number(a > b),
  '<=': (a, b) => Number(a <= b),
  '>=': (a, b) => Number(a >= b),
  '+': (a, b) => a + b,
  '-': (a, b) => a - b,
  '*': (a, b) => a * b,
};

/**
 * @param {string} text
 * @param {Record<string, number>} known
 * @returns {number | string} The value, or the text of what is left to find out.
 */
export function reduced(text, known) {
  const tokens = [...text.matchAll(TOKEN)].map(([, token]) => token);
  if (tokens.join('').replaceAll(/\s/g, '') !== text.replaceAll(/\s/g, '')) throw new Error(`#if ${text}: not an expression of integers`);
  const state = { tokens, at: 0, known };
  const { value, text: left } = parseLevel(state, 0);
  if (state.at !== tokens.length) throw new Error(`#if ${text}: not an expression of integers`);
  return value ?? left;
}

/** @returns {{value?: number, text: string, level: number}} `level` of the operator that is left, for parentheses. */
function parseLevel(state, level) {
  if (level === LEVELS.length) return parseUnary(state);
  let a = parseLevel(state, level + 1);
  while (LEVELS[level].includes(state.tokens[state.at])) {
    const operator = state.tokens[state.at++];
    a = joined(operator, a, parseLevel(state, level + 1), level);
  }
  return a;
}

function joined(operator, a, b, level) {
  if (a.value !== undefined && b.value !== undefined) return numberOf(OPERATIONS[operator](a.value, b.value));
  const decisive = { '||': 1, '&&': 0 }[operator];
  if (decisive !== undefined) {
    const [given, other] = a.value === undefined ? [b, a] : [a, b];
    if (given.value !== undefined) return Number(given.value !== 0) === decisive ? numberOf(decisive) : other;
  }
  const within = (part) => (part.level < level || part.level === level && level > 1 ? `(${part.text})` : part.text);
  return { text: `${within(a)} ${operator} ${within(b)}`, level };
}

const numberOf = (value) => ({ value, text: String(value), level: LEVELS.length });

function parseUnary(state) {
  const token = state.tokens[state.at++];
  if (token === '(') {
    const inner = parseLevel(state, 0);
    if (state.tokens[state.at++] !== ')') throw new Error('#if: a parenthesis is not closed');
    return inner;
  }
  if (token === '!') {
    const inner = parseUnary(state);
    return inner.value === undefined ? { text: `!${inner.level < LEVELS.length ? `(${inner.text})` : inner.text}`, level: LEVELS.length } : numberOf(Number(inner.value === 0));
  }
  if (/^\d/.test(token ?? '')) return numberOf(Number(token));
  if (!/^[A-Za-z_]/.test(token ?? '')) throw new Error(`#if: ${token ?? 'the end'} where a value is expected`);
  return Object.hasOwn(state.known, token) ? numberOf(state.known[token]) : { text: token, level: LEVELS.length };
}
