// Choice of the columns of a measured file: what each is (time, keyphasor, the signal of a probe), and its unit.
import { button, el, setChoices } from '../dom';
import type { ChosenColumn, MeasuredColumn } from '../engine/protocol';
import type { AskedFile } from '../model/measured';

export interface ChooserListener {
  chosen(name: string, columns: readonly ChosenColumn[]): void;
  dismissed(name: string): void;
}

const NOT_USED = '';
const OTHER = '\u2026';
/// Columns without a probe, with their usual units.
const AXES: ReadonlyMap<string, string> = new Map([
  ['time', 's'],
  ['angle', 'deg'],
  ['speed', 'rpm'],
  ['keyphasor', ''],
]);

/// One column: its name, its use and its unit.
class ColumnRow {
  readonly root: HTMLElement;
  private readonly use = el('select');
  private readonly other = el('input', { type: 'text', placeholder: 'disc 45', size: 10, hidden: true });
  private readonly unit = el('input', { type: 'text', size: 5 });

  constructor(
    private readonly column: MeasuredColumn,
    uses: readonly string[],
  ) {
    const { name, unit, count } = column;
    this.use.setAttribute('aria-label', `Use of ${name}`);
    this.other.setAttribute('aria-label', `Heading of ${name}`);
    this.unit.setAttribute('aria-label', `Unit of ${name}`);
    setChoices(
      this.use,
      [
        { value: NOT_USED, text: 'not used' },
        ...uses.map((value) => ({ value, text: value })),
        { value: OTHER, text: 'other\u2026' },
      ],
      guess(name, uses),
    );
    this.unit.value = unit;
    this.changed();
    this.use.addEventListener('change', () => this.changed());
    this.root = el(
      'tr',
      {},
      el('th', { scope: 'row' }, name),
      el('td', {}, String(count)),
      el('td', {}, this.use, this.other),
      el('td', {}, this.unit),
    );
  }

  /// The column with its heading; undefined if it is not used.
  get chosen(): ChosenColumn | undefined {
    const what = this.use.value === OTHER ? this.other.value.trim() : this.use.value;
    const unit = this.unit.value.trim();
    return what ? { heading: unit ? `${what} [${unit}]` : what, name: this.column.name } : undefined;
  }

  private changed(): void {
    const what = this.use.value;
    this.other.hidden = what !== OTHER;
    this.unit.disabled = what === NOT_USED;
    // The unit of the file counts; without one the usual unit is proposed.
    if (!this.column.unit && what !== NOT_USED)
      this.unit.value = AXES.get(what) ?? (what.endsWith(' lag') ? 'deg' : 'um');
  }
}

/// Proposes the use of a column by its name.
function guess(name: string, uses: readonly string[]): string {
  const plain = name.split('/').at(-1)!.replaceAll('_', ' ').toLowerCase();
  const same = uses.find((use) => use.toLowerCase() === plain);
  if (same) return same;
  if (/^(t|time|zeit|temps)$/.test(plain)) return 'time';
  if (/key|tach|mark/.test(plain)) return 'keyphasor';
  return NOT_USED;
}

export class ColumnChooser {
  readonly root = el('div', { class: 'choosers' });
  private shown: readonly AskedFile[] = [];

  constructor(private readonly listener: ChooserListener) {}

  show(asked: readonly AskedFile[], stations: readonly string[]): void {
    this.root.hidden = asked.length === 0;
    if (asked === this.shown) return; // what the user has chosen stays
    this.shown = asked;
    this.root.replaceChildren(...asked.map((file) => this.form(file, stations)));
  }

  private form({ name, columns }: AskedFile, stations: readonly string[]): HTMLElement {
    const uses = [
      ...AXES.keys(),
      ...stations.flatMap((station) => ['x', 'y', 'x lag', 'y lag'].map((end) => `${station} ${end}`)),
    ];
    const rows = columns.map((column) => new ColumnRow(column, uses));
    const form = el(
      'form',
      { class: 'chooser', 'aria-label': `Columns of ${name}` },
      el('p', {}, el('span', {}, el('strong', {}, name), ': choose what its columns are')),
      el(
        'div',
        { class: 'chooser-rows' },
        el(
          'table',
          {},
          el('thead', {}, el('tr', {}, ...['column', 'numbers', 'is', 'unit'].map((text) => el('th', {}, text)))),
          el('tbody', {}, ...rows.map(({ root }) => root)),
        ),
      ),
      el(
        'p',
        {},
        el('button', { type: 'submit' }, 'Show'),
        button('Cancel', `Cancel the choice of the columns of ${name}`, () => this.listener.dismissed(name)),
      ),
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.listener.chosen(
        name,
        rows.flatMap(({ chosen }) => (chosen ? [chosen] : [])),
      );
    });
    return form;
  }
}
