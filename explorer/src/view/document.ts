// Statements, sheets and figures of a part of a result, and the list of contents.
import { headingOf, piecesOf, type Part, type Sheet, type Statement } from '../data/contents';
import { button, download, el } from '../dom';
import { hasSpots, pictureOfDescribed, tableOfDescribed, type Described } from '../figure/described';
import { numbersTable } from './numbers';
import { csvOf, fileName, saveMenu } from './panel';

export interface DocumentListener {
  part(id: string): void;
  /// Called after a station was chosen in a drawing.
  station(name: string): void;
}

/// Returns the station of the hot spot of a drawing at an event.
function stationAt({ target }: Event): string | undefined {
  return target instanceof Element ? target.closest<SVGElement>('[data-station]')?.dataset['station'] : undefined;
}

/// Makes the hot spots of a drawing act as buttons.
function listen(frame: HTMLElement, chosen: (station: string) => void): void {
  frame.addEventListener('click', (event) => {
    const station = stationAt(event);
    if (station !== undefined) chosen(station);
  });
  frame.addEventListener('keydown', (event) => {
    const station = event.key === 'Enter' || event.key === ' ' ? stationAt(event) : undefined;
    if (station === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    chosen(station);
  });
}

/// Makes a card with a picture, its caption, and menus to save it.
function figureCard(figure: Described, chosen: (station: string) => void): HTMLElement {
  const picture = pictureOfDescribed(figure);
  const seen = hasSpots(figure) ? pictureOfDescribed(figure, true) : picture;
  const drawn = new DOMParser().parseFromString(seen.svg, 'image/svg+xml').documentElement;
  const frame = el('figure', { class: 'described', role: 'group', tabindex: 0, 'aria-label': figure.title });
  frame.append(document.importNode(drawn, true));
  listen(frame, chosen);
  const whole = { root: frame, redraw: () => undefined, picture: () => picture };
  return card(
    figure.title,
    [
      saveMenu(
        figure.title,
        () => fileName(figure.name),
        () => whole,
        () => tableOfDescribed(figure),
      ),
    ],
    [frame, el('p', { class: 'how' }, figure.caption)],
    { 'data-figure': figure.name },
  );
}

function card(
  title: string,
  tools: readonly HTMLElement[],
  content: readonly HTMLElement[],
  attributes: Readonly<Record<string, string>> = {},
): HTMLElement {
  return el(
    'section',
    { class: 'card map-card', 'aria-label': title, ...attributes },
    el('header', {}, el('h2', { tabindex: -1 }, title), ...tools),
    ...content,
  );
}

/// Returns the numbers of a sheet as CSV, in the units of its columns with all digits.
function csvOfSheet({ columns, rows }: Sheet): string {
  const plain = (cell: Sheet['rows'][number][number], c: number): string =>
    typeof cell === 'number'
      ? String(cell / columns[c]!.size - (columns[c]!.zero ?? 0))
      : cell === null || typeof cell === 'string'
        ? (cell ?? '')
        : cell.map((each) => plain(each, c)).join(' ');
  return csvOf({ heading: columns.map(headingOf), rows: rows.map((row) => row.map(plain)) });
}

/// Makes the card of a sheet; empty columns are left out.
function sheetCard(sheet: Sheet): HTMLElement {
  const { table, name, title, about, looked_up, columns, shown } = sheet;
  const kept = columns.map((_, c) => c).filter((c) => shown.some((row) => row[c] !== ''));
  const of = (row: readonly string[]) => kept.map((c) => row[c]!);
  const save = () => download(`${fileName(table, name)}.csv`, 'text/csv', csvOfSheet(sheet));
  const numbers = el(
    'div',
    { class: 'numbers', role: 'region', tabindex: 0, 'aria-label': `${title}: table` },
    numbersTable(title, of(columns.map(headingOf)), shown.map(of)),
  );
  const content = about ? [el('p', { class: 'how' }, about), numbers] : [numbers];
  return card(
    title,
    [button('\u2913 CSV', `${title}: save as CSV`, save, { 'data-save': 'csv' })],
    looked_up ? [el('details', {}, el('summary', {}, 'Numbers to look up'), ...content)] : content,
    { 'data-sheet': `${table}/${name}` },
  );
}

function statementItem(statement: Statement): HTMLElement {
  const [at, what, rest] = piecesOf(statement);
  const verdict = statement.clause ? { 'data-verdict': statement.verdict } : {};
  const clause = statement.clause ? [' ', el('span', { class: 'clause' }, statement.clause)] : [];
  return el('li', verdict, at, el('strong', {}, what), rest, ...clause);
}

function statementList(part: Part): HTMLElement {
  return el(
    'ul',
    { class: 'statements' },
    ...part.statements.map(statementItem),
    ...part.notes.map((note) => el('li', {}, note)),
  );
}

const says = (part: Part) => part.statements.length + part.notes.length > 0;

const FOUND = 'What was found';

export class DocumentView {
  readonly contents = el('nav', { class: 'contents', 'aria-label': 'Contents' });
  readonly root = el('div', { class: 'document' });
  private shown: Part | undefined;

  constructor(private readonly listener: DocumentListener) {}

  /// Shows a part, or nothing.
  show(parts: readonly Part[], part: Part | undefined): void {
    this.root.hidden = this.contents.hidden = part === undefined;
    if (!part || part === this.shown) return;
    this.shown = part;
    const machine = part === parts[0];
    const found = machine ? parts.filter(says) : [part].filter(says);
    const statements = found.flatMap((one) => [
      ...(machine && one !== part ? [el('h3', {}, this.goal(one, false))] : []),
      statementList(one),
    ]);
    const statementCards = found.length > 0 ? [card(FOUND, [], statements)] : [];
    const figures = part.figures.map((figure) => figureCard(figure, (station) => this.listener.station(station)));
    // Place drawings of the machine before its findings.
    const sheets = part.sheets.map(sheetCard);
    const cards = machine ? [...figures, ...statementCards, ...sheets] : [...statementCards, ...sheets, ...figures];
    this.root.classList.toggle('of-machine', machine);
    this.root.replaceChildren(...cards);
    const goals = cards.map((each) => {
      const title = each.getAttribute('aria-label')!;
      return button(title, `Go to ${title}`, () => {
        each.scrollIntoView({ block: 'start' });
        each.querySelector('h2')!.focus({ preventScroll: true });
      });
    });
    const list = (label: string, entries: readonly HTMLElement[]) =>
      el('ul', { 'aria-label': label }, ...entries.map((entry) => el('li', {}, entry)));
    const had = this.contents.contains(document.activeElement);
    this.contents.replaceChildren(
      list(
        'Parts of the result',
        parts.map((each) => this.goal(each, each === part)),
      ),
      list(part.title, cards.length > 1 || part.view ? goals : []),
    );
    // Rebuilding the list removes the focused entry: focus the current one again.
    if (had) this.contents.querySelector<HTMLElement>('[aria-current]')?.focus({ preventScroll: true });
  }

  /// Marks the selected station in drawings.
  mark(station: string): void {
    for (const spot of this.root.querySelectorAll<SVGElement>('[data-station]'))
      spot.setAttribute('aria-pressed', String(spot.dataset['station'] === station));
  }

  private goal({ id, title }: Part, current: boolean): HTMLElement {
    const attributes = current ? { 'aria-current': 'page' } : {};
    return button(title, `Go to ${title}`, () => this.listener.part(id), attributes);
  }
}
