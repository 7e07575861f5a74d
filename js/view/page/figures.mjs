import { checkName, checkText, COLUMNS, number, regionRows } from '../../compare/figures.mjs';

const element = (name, properties = {}, children = []) => {
  const node = Object.assign(document.createElement(name), properties);
  node.append(...children);
  return node;
};

const cell = (text) => element('td', { textContent: text });

/** What it means to be within a gate of telar compare. */
const WITHIN = { parity: 'Parity', 'other-gl': 'Alike by two GLs' };

/** Fills the table of figures, the checks and the verdict. */
export function showFigures({ comparison, verdict }, { table, checks, pill, ssim, hint }) {
  const head = element(
    'tr',
    {},
    ['region', ...COLUMNS].map((name) => element('th', { scope: 'col', textContent: name })),
  );
  const rows = regionRows(comparison).map(([name, ...cells]) => element('tr', {}, [element('th', { scope: 'row', textContent: name }), ...cells.map(cell)]));
  table.tHead.replaceChildren(head);
  table.tBodies[0].replaceChildren(...rows);
  checks.replaceChildren(
    ...verdict.checks.map((item) =>
      element('li', { className: item.pass ? 'within' : 'over' }, [
        element('span', { textContent: item.pass ? 'within' : 'over' }),
        ` ${checkName(item)}: ${checkText(item)}`,
      ]),
    ),
  );
  ssim.textContent = number(comparison.ssim);
  pill.textContent = verdict.pass ? WITHIN[verdict.gate] : 'Over the gate';
  hint.hidden = verdict.gate === 'parity';
  pill.dataset.verdict = verdict.pass ? 'within' : 'over';
}
