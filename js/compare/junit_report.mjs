import { checkName, checkText } from './figures.mjs';
import { escaped } from './markup.mjs';

const testcase = (name, item) => {
  const open = `    <testcase classname="${escaped(name)}" name="${escaped(checkName(item))}"`;
  if (item.pass) return `${open}/>`;
  return `${open}>\n      <failure message="${escaped(checkText(item))}"/>\n    </testcase>`;
};

/**
 * JUnit XML: a test suite for each comparison, a test case for each check of its gate.
 * @param {Array<{name: string, verdict: import('./gates.mjs').Verdict}>} comparisons
 * @returns {string}
 */
export function junitReport(comparisons) {
  const suites = comparisons.map(({ name, verdict: { gate, checks } }) => {
    const failures = checks.filter(({ pass }) => !pass).length;
    return `  <testsuite name="${escaped(`${name} (${gate})`)}" tests="${checks.length}" failures="${failures}">
${checks.map((item) => testcase(name, item)).join('\n')}
  </testsuite>`;
  });
  return `<?xml version="1.0" encoding="UTF-8"?>\n<testsuites>\n${suites.join('\n')}\n</testsuites>\n`;
}
