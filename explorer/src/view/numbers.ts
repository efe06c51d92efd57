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
  // Columns of words are aligned to the left, those of numbers to the right.
  const side = heading.map((_, column) =>
    rows.some(({ [column]: cell }) => typeof cell === 'string' && /^\p{L}/u.test(cell)) ? { class: 'words' } : {},
  );
  const made = el(
    'table',
    {},
    el('caption', { class: 'unseen' }, caption),
    el(
      'thead',
      {},
      el(
        'tr',
        {},
        ...heading.map((text, column) =>
          el('th', { scope: 'col', ...side[column] }, text.replace(/([0p])-p/, '$1\u2011p')),
        ),
      ),
    ),
    el(
      'tbody',
      {},
      ...rows.map(([name = '', ...cells], row) =>
        el(
          'tr',
          row === marked ? { class: 'marked' } : {},
          el('th', { scope: 'row' }, name),
          ...cells.map((cell, i) => el('td', side[i + 1] ?? {}, cell)),
        ),
      ),
    ),
  );
  return made;
}
