// The card of the diagram: choice of quantities, mode of dragging, and recomputation.
import { QUANTITIES, quantitiesOf } from '../data/quantities';
import { CLASS_NAMES } from '../data/regimes';
import { button, el, Segments, select, setChoices, type Choice } from '../dom';
import type { SweepProgress } from '../engine/protocol';
import type { Quality } from '../model/sights';
import { MapView, type MapListener, type MapSubject } from './map';
import { fileName, saveMenu } from './panel';
import type { Mode } from './stack';
import { FIELD } from '../data/fields';

export interface MapCardListener extends MapListener {
  quantity(id: string): void;
  station(index: number): void;
  parameter(name: string): void;
  hidden(classes: ReadonlySet<number>): void;
  reset(): void;
  recompute(): void;
  cancel(): void;
}

export interface MapCardSubject extends MapSubject {
  readonly parameters: readonly string[];
  /// Number of diagrams to go back to.
  readonly depth: number;
  readonly computes: boolean;
  /// A sentence that describes the diagram.
  readonly status: string;
  /// True if the diagram belongs to other parameters than the present ones.
  readonly stale: boolean;
}

const POINTS: readonly Choice[] = [64, 128, 256, 512, 1024].map((count) => ({
  value: String(count),
  text: `${count} points`,
}));
const QUALITIES: readonly Choice[] = [
  { value: 'draft', text: 'draft: 150 revolutions, no verdicts' },
  { value: 'quick', text: 'quick: 500 revolutions, then as the case' },
  { value: 'case', text: 'as the case' },
];

export class MapCard {
  readonly root: HTMLElement;
  readonly map: MapView;
  points = 256;
  quality: Quality = 'quick';
  private subject: MapCardSubject | undefined;
  private hidden = new Set<number>();
  private readonly title = el('h2', {}, 'Diagram');
  private readonly quantity: HTMLSelectElement;
  private readonly station: HTMLSelectElement;
  private readonly parameter: HTMLSelectElement;
  private readonly modes: Segments;
  private readonly back: HTMLButtonElement;
  private readonly reset: HTMLButtonElement;
  private readonly again: HTMLButtonElement;
  private readonly cancel: HTMLButtonElement;
  private readonly bar = el('progress', { max: 1, value: 0, 'aria-label': 'Progress of the diagram' });
  private readonly status = el('p', { class: 'status', role: 'status' });
  private readonly legend = el('div', {
    class: 'legend',
    role: 'group',
    'aria-label': 'Regimes; press to hide or show',
  });
  private readonly computing: HTMLElement;

  constructor(private readonly listener: MapCardListener) {
    this.map = new MapView(listener);
    this.quantity = select(
      'What the diagram shows',
      QUANTITIES.map(({ id, text }) => ({ value: id, text })),
      'x',
      (value) => listener.quantity(value),
    );
    this.station = select('Station', [], '', (value) => listener.station(Number(value)));
    this.parameter = select('Parameter along the diagram', [], '', (value) => listener.parameter(value));
    this.modes = new Segments(
      'What dragging does',
      [
        { value: 'point', text: 'Point', title: 'Drag: the motion at the value under the cursor' },
        { value: 'range', text: 'Range', title: 'Drag: compute that range anew, finer; up or down: enlarge' },
        { value: 'pan', text: 'Pan', title: 'Drag: move the view; the wheel zooms' },
      ],
      'point',
      (value) => (this.map.stack.mode = value as Mode),
    );
    this.back = button('Back', 'Back to the diagram before', () => this.map.stack.back());
    this.reset = button('Reset', 'The whole diagram of the case', () => {
      this.map.stack.fit();
      listener.reset();
    });
    this.again = button(
      'Recompute',
      'Recompute the diagram here, with the present parameters',
      () => listener.recompute(),
      { class: 'primary' },
    );
    this.cancel = button('Cancel', 'Stop computing', () => listener.cancel(), { hidden: true });
    this.bar.hidden = true;
    this.computing = el(
      'div',
      { class: 'tools' },
      this.again,
      select('Points of a new diagram', POINTS, String(this.points), (value) => (this.points = Number(value))),
      select(
        'How well a new diagram is computed',
        QUALITIES,
        this.quality,
        (value) => (this.quality = value as Quality),
      ),
      this.bar,
      this.cancel,
    );
    const name = () =>
      fileName('whirl', this.subject?.name ?? '', this.subject?.quantity ?? '', this.subject?.parameter ?? '');
    const figure = { root: this.map.root, redraw: () => this.map.refresh(), picture: () => this.map.picture() };
    this.root = el(
      'section',
      { class: 'card map-card', 'aria-label': 'Diagram' },
      el(
        'header',
        {},
        this.title,
        el(
          'div',
          { class: 'tools' },
          this.quantity,
          this.station,
          el('span', { class: 'over' }, 'over'),
          this.parameter,
          saveMenu(
            'Diagram',
            name,
            () => figure,
            () => this.map.table(),
          ),
        ),
      ),
      el('div', { class: 'tools' }, this.modes.root, this.back, this.reset),
      this.map.root,
      this.legend,
      this.computing,
      this.status,
    );
  }

  show(subject: MapCardSubject): void {
    this.subject = subject;
    setChoices(
      this.station,
      subject.stations.map(({ name }, i) => ({ value: String(i), text: name })),
      String(subject.station),
    );
    this.station.hidden =
      !(quantitiesOf(subject.diagram).find(({ id }) => id === subject.quantity)?.perStation ?? true) ||
      subject.stations.length < 2;
    setChoices(
      this.parameter,
      subject.parameters.map((name) => ({ value: name, text: name })),
      subject.parameter,
    );
    this.parameter.disabled = subject.parameters.length < 2;
    this.showQuantities();
    this.back.disabled = subject.depth === 0;
    this.computing.hidden = !subject.computes;
    this.status.textContent = subject.status;
    this.root.classList.toggle('stale', subject.stale);
    this.map.show(subject);
    this.showLegend();
  }

  /// Shows points that have arrived.
  grow(): void {
    this.showQuantities();
    this.map.refresh();
    this.showLegend();
  }

  /// Shows the progress; undefined: nothing is being computed.
  progress(now: SweepProgress | undefined): void {
    this.bar.hidden = this.cancel.hidden = now === undefined;
    if (now) this.bar.value = now.revolutionsTotal > 0 ? now.revolutionsDone / now.revolutionsTotal : 0;
  }

  /// Lists the quantities of the diagram, which are known with its first points.
  private showQuantities(): void {
    const choices = quantitiesOf(this.subject?.diagram).map(({ id, text }) => ({ value: id, text }));
    const now = this.subject?.quantity ?? 'x';
    const same = choices.every(({ value }, i) => value === this.quantity.options[i]?.value);
    if (same && choices.length === this.quantity.options.length) this.quantity.value = now;
    else setChoices(this.quantity, choices, now);
  }

  private showLegend(): void {
    const diagram = this.subject?.diagram;
    const counts = CLASS_NAMES.map(() => 0);
    if (diagram?.judged) diagram.classes.forEach((kind, point) => (counts[kind]! += diagram.done[point]!));
    const entries = counts.flatMap((count, kind) => (count > 0 ? [this.legendEntry(kind, count)] : []));
    const rub = diagram?.values.some((_, point) => diagram.done[point] === 1 && diagram.contact(point) > 0);
    if (rub) entries.push(el('span', { class: 'legend-note key-contact' }, 'contact'));
    if (diagram?.column(FIELD.REGIME_CONFIDENCE))
      entries.push(el('span', { class: 'legend-note key-confidence' }, 'confidence (faint: low)'));
    if (this.subject?.branches) entries.push(el('span', { class: 'legend-note' }, 'orbits: solid stable, dashed not'));
    const { band } = this.subject ?? {};
    if (band)
      entries.push(
        el(
          'span',
          { class: 'legend-note key-band' },
          `tolerances: 5 to 95 %, 25 to 75 % and median of ${band.samples} samples`,
        ),
      );
    for (const { name } of this.subject?.measured ?? [])
      entries.push(el('span', { class: 'legend-note key-measured' }, `measured: ${name}`));
    if (this.subject?.tori) entries.push(el('span', { class: 'legend-note' }, 'tori: bands, edges likewise'));
    // Rebuild only after a change, so that the focus stays.
    const text = entries.map((entry) => entry.textContent).join();
    if (this.legend.dataset['text'] === text) return;
    this.legend.dataset['text'] = text;
    this.legend.replaceChildren(...entries);
  }

  private legendEntry(kind: number, count: number): HTMLElement {
    const entry = button(
      `${CLASS_NAMES[kind]} `,
      `${CLASS_NAMES[kind]}: ${count} points; hide or show`,
      () => {
        if (!this.hidden.delete(kind)) this.hidden.add(kind);
        entry.setAttribute('aria-pressed', String(!this.hidden.has(kind)));
        this.listener.hidden(new Set(this.hidden));
      },
      { class: `legend-entry class-${kind}`, 'aria-pressed': String(!this.hidden.has(kind)) },
    );
    entry.append(el('span', { class: 'count' }, String(count)));
    return entry;
  }
}
