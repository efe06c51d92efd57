// A panel: one picture of a motion in a card, with a menu to save picture and data.
import type { Diagram } from '../data/diagram';
import type { MeasuredMotion } from '../data/measured';
import type { Motion } from '../data/motion';
import { button, download, el } from '../dom';
import type { StationInfo } from '../engine/protocol';
import type { Figure } from '../figure/figure';
import { pngOf } from '../figure/pen';
import type { Theme } from '../figure/theme';
import type { Scales, Units } from '../model/units';

/// Data shown by a panel.
export interface Subject {
  /// The motion; undefined before the first result.
  readonly motion: Motion | undefined;
  readonly station: number;
  readonly info: StationInfo;
  readonly units: Units;
  readonly scales: Scales;
  /// Colour of the setting (A or B).
  readonly accent: (colours: Theme) => string;
  /// Diagram of the same run, for the path of the centreline.
  readonly diagram: Diagram | undefined;
  /// Measured motions at the station.
  readonly measured: readonly MeasuredMotion[];
  /// Label for files and titles: "r_k = 0.45".
  readonly label: string;
}

export interface Table {
  readonly heading: readonly string[];
  readonly rows: Iterable<readonly (number | string)[]>;
}

/// Returns a table as CSV (RFC 4180), numbers with all digits.
export function csvOf(table: Table): string {
  const cell = (value: number | string) => {
    const text = String(value);
    return /[",\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
  };
  const lines = [table.heading, ...table.rows].map((row) => row.map(cell).join(','));
  return lines.join('\r\n') + '\r\n';
}

/// Returns a file name of letters, digits and a few signs.
export function fileName(...parts: readonly string[]): string {
  return parts
    .map((part) => part.replace(/[^A-Za-z0-9._+-]+/g, '-').replace(/^[-.]+|-+$/g, ''))
    .filter((part) => part)
    .join('-');
}

/// Makes a menu that saves a figure as PNG or SVG and its data as CSV.
export function saveMenu(title: string, name: () => string, figure: () => Figure, table: () => Table): HTMLElement {
  const menu = el(
    'details',
    { class: 'menu' },
    el('summary', { 'aria-label': `Save: ${title}`, title: 'Save the picture or its data' }, '\u2913'),
  );
  const item = (kind: string, what: string, act: () => void | Promise<void>) =>
    button(
      kind,
      `${title}: save ${what}`,
      () => {
        menu.open = false;
        void act();
      },
      { 'data-save': kind.toLowerCase() },
    );
  menu.append(
    el(
      'div',
      { class: 'menu-items' },
      item('PNG', 'the picture as PNG', async () => {
        const { svg, width, height } = figure().picture();
        download(`${name()}.png`, 'image/png', await pngOf(svg, width, height));
      }),
      item('SVG', 'the picture as SVG', () => download(`${name()}.svg`, 'image/svg+xml', figure().picture().svg)),
      item('CSV', 'the data as CSV', () => download(`${name()}.csv`, 'text/csv', csvOf(table()))),
    ),
  );
  menu.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') menu.open = false;
  });
  document.addEventListener('pointerdown', (event) => {
    if (menu.open && !menu.contains(event.target as Node)) menu.open = false;
  });
  return menu;
}

/// Makes entries of a legend for measured motions.
export function measuredKeys(measured: readonly MeasuredMotion[], more: readonly string[] = []): HTMLElement[] {
  return measured.map(({ name }, i) =>
    el('span', { class: 'key key-measured' }, `measured: ${name}${more[i] ? `, ${more[i]}` : ''}`),
  );
}

/// Data that every panel needs for file names.
interface Named {
  readonly info: { readonly name: string };
  readonly label: string;
}

export abstract class Panel<S extends Named = Subject> {
  readonly root: HTMLElement;
  protected subject: S | undefined;
  protected readonly note = el('p', { class: 'panel-note' });
  private readonly tools = el('div', { class: 'panel-tools' });

  constructor(
    readonly name: string,
    readonly title: string,
  ) {
    this.root = el(
      'section',
      { class: `card panel panel-${name}`, role: 'group', 'aria-label': title },
      el('header', {}, el('h3', {}, title), this.tools),
    );
  }

  /// Builds the card; constructors call it after making the figure.
  protected assemble(...tools: readonly HTMLElement[]): void {
    const name = () => fileName('whirl', this.name, this.subject?.info.name ?? '', this.subject?.label ?? '');
    this.tools.append(
      ...tools,
      saveMenu(
        this.title,
        name,
        () => this.figure,
        () => this.table(),
      ),
    );
    this.root.append(this.figure.root, this.note);
  }

  update(subject: S): void {
    this.subject = subject;
    this.refresh();
  }

  redraw(): void {
    this.figure.redraw();
  }

  abstract readonly figure: Figure;
  protected abstract refresh(): void;
  protected abstract table(): Table;
}
