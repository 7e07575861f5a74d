/**
 * Whether a pattern means a name of a file: `*` stands for any characters. Without backtracking over more than one star, as names are a
 * stranger's. renderer/core/part_opacities.cpp does the same.
 * @param {string} pattern
 * @param {string} name
 */
export function matchesName(pattern, name) {
  let [p, n, star, mark] = [0, 0, -1, 0];
  while (n < name.length) {
    if (pattern[p] === '*') [star, mark, p] = [p, n, p + 1];
    else if (pattern[p] === name[n]) [p, n] = [p + 1, n + 1];
    else if (star >= 0) [p, mark, n] = [star + 1, mark + 1, mark + 1];
    else return false;
  }
  while (pattern[p] === '*') p += 1;
  return p === pattern.length;
}
