import { checkName, checkText } from './figures.mjs';
import { escaped } from './markup.mjs';

const testcase = (name, item, hints) => {
  const open = `    <testcase classname="${escaped(name)}" name="${escaped(checkName(item))}"`;
  if (item.pass) return `${open}/>`;
  return `${open}>\n      <failure message="${escaped([checkText(item), ...hints].join('; '))}"/>\n    </testcase>`;
};

/** A picture that could not be compared: an error where reading failed, a failure where one of the two is not there. */
function brokenSuite({ name, problem, status }) {
  const kind = status === 'failed' ? 'error' : 'failure';
  return `  <testsuite name="${escaped(name)}" tests="1" failures="${kind === 'failure' ? 1 : 0}" errors="${kind === 'error' ? 1 : 0}">
    <testcase classname="${escaped(name)}" name="compared">\n      <${kind} message="${escaped(problem)}"/>\n    </testcase>
  </testsuite>`;
}

/** A first picture that was accepted: there was nothing to compare it with. */
const acceptedSuite = ({ name }) => `  <testsuite name="${escaped(name)}" tests="1" failures="0">
    <testcase classname="${escaped(name)}" name="accepted"/>
  </testsuite>`;

const suiteOf = (each) => (each.verdict ? suite(each) : each.problem ? brokenSuite(each) : acceptedSuite(each));

function suite({ name, verdict: { gate, checks }, hints = [], status }) {
  // What was accepted is no failure any more.
  const shown = status === 'updated' ? checks.map((item) => ({ ...item, pass: true })) : checks;
  return `  <testsuite name="${escaped(`${name} (${gate})`)}" tests="${shown.length}" failures="${shown.filter(({ pass }) => !pass).length}">
${shown
  .map((item) =>
    testcase(
      name,
      item,
      hints.map(({ message }) => message),
    ),
  )
  .join('\n')}
  </testsuite>`;
}

/**
 * JUnit XML: a test suite for each comparison, a test case for each check of its gate.
 * @param {Array<{name: string, verdict?: import('./gates.mjs').Verdict, hints?: {message: string}[], problem?: string, status?: string}>} comparisons
 *   `problem` in place of a verdict says why there is none; `status` is 'failed' where an image could not be read
 * @returns {string}
 */
export function junitReport(comparisons) {
  const suites = comparisons.filter(({ verdict, problem, status }) => verdict ?? problem ?? (status === 'updated' || undefined)).map(suiteOf);
  return `<?xml version="1.0" encoding="UTF-8"?>\n<testsuites>\n${suites.join('\n')}\n</testsuites>\n`;
}
