// A table of numbers on the page.
import { el } from '../dom';

export type Cell = string | HTMLElement;

/// Makes a table; the first cell of a row is its name, `marked` the selected row.
export function numbersTable(
  caption: string,
  heading: readonly string[],
  rows: readonly (readonly Cell[])[],
  marked = -1,
): HTMLElement {
  const made = el(
    'table',
    {},
    el('caption', { class: 'unseen' }, caption),
    el(
      'thead',
      {},
      el('tr', {}, ...heading.map((text) => el('th', { scope: 'col' }, text.replace(/([0p])-p/, '$1\u2011p')))),
    ),
    el(
      'tbody',
      {},
      ...rows.map(([name = '', ...cells], i) =>
        el(
          'tr',
          i === marked ? { class: 'marked' } : {},
          el('th', { scope: 'row' }, name),
          ...cells.map((cell) => el('td', {}, cell)),
        ),
      ),
    ),
  );
  return made;
}
