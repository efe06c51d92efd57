// A map over two parameters: its cells in the colours of regimes or of a quantity, the cells of settings A and B, and
// what hands and keys do on them.
import { ATTRACTOR, mapNumbersOf, partOf, REGIME, type MapNumbers } from '../data/map_quantities';
import { nearestOn, type Cell, type ParameterMap } from '../data/parameter_map';
import { CLASS_NAMES } from '../data/regimes';
import { el } from '../dom';
import type { StationInfo } from '../engine/protocol';
import { Chart, type Frame, type Range } from '../figure/chart';
import { ColourBar } from '../figure/colour_bar';
import { textSize, theme, type Picture } from '../figure/figure';
import { attractorColour, colourAt, mixed } from '../figure/palette';
import { SvgPen, type Pen } from '../figure/pen';
import { CONFIDENCE_NAMES, type Theme } from '../figure/theme';
import { labelled, parameterMeasure, readable, shown, type Measure, type Scales, type Units } from '../model/units';
import { placeKeys, sketchKeys, type Key } from './rest_subject';
import type { Table } from './panel';

export interface ParameterMapSubject {
  readonly map: ParameterMap;
  readonly quantity: string;
  /// Lines where regimes, or attractors, meet.
  readonly lines: boolean;
  readonly station: number;
  readonly stations: readonly StationInfo[];
  readonly units: Units;
  readonly scales: Scales;
  /// SI units of the two parameters.
  readonly unitsOfAxes: readonly [string, string];
}

/// What the legend of a map names.
export interface MapEntry {
  readonly text: string;
  /// How many points, or which share of them.
  readonly count: string;
  colour(colours: Theme): string;
}

export interface ParameterMapListener {
  /// A cell was chosen; `settled` when the pointer let go.
  cell(cell: Cell, settled: boolean): void;
  /// The pointer is over a cell and presses nothing, or has left the map.
  hover(cell: Cell | undefined): void;
  /// The cut is to run along the other parameter.
  turn(): void;
}

/// A place in the plane of the two parameters, in SI.
export type Spot = readonly [number, number];

/// How much of a regime's colour is left, by confidence: low, fair, high.
const STRENGTH = [0.4, 0.75, 1];

export class ParameterMapView {
  readonly root: HTMLElement;
  private readonly chart: Chart;
  private readonly bar = new ColourBar();
  private readonly marks: Readonly<Record<'a' | 'b', CellMark>>;
  private subject: ParameterMapSubject | undefined;
  private numbers: MapNumbers | undefined;
  private drawn = '';
  private spot: Spot = [NaN, NaN];

  constructor(private readonly listener: ParameterMapListener) {
    this.chart = new Chart({ title: 'Map', over: (pen, frame, colours) => this.draw(pen, frame, colours) });
    this.chart.root.classList.add('parameter-map');
    this.chart.root.setAttribute('role', 'group');
    this.root = el('div', { class: 'map' }, this.chart.root, this.bar.root);
    const { overlay } = this.chart;
    this.marks = { a: new CellMark('a', this.chart), b: new CellMark('b', this.chart) };
    new ResizeObserver(() => this.placeMarks()).observe(overlay);
    overlay.tabIndex = 0;
    overlay.setAttribute('role', 'slider');
    overlay.addEventListener('keydown', (event) => this.key(event));
    this.listen(overlay);
  }

  show(subject: ParameterMapSubject): void {
    const changed = this.subject?.map !== subject.map;
    this.subject = subject;
    const { quantity, lines, station, units, scales } = subject;
    const key = JSON.stringify([quantity, lines, station, units, scales.symbol]);
    if (!changed && key === this.drawn) return;
    this.drawn = key;
    this.refresh();
  }

  /// After colours have changed.
  refresh(): void {
    const { subject } = this;
    if (!subject) return;
    const { map, quantity, station, stations, units, scales } = subject;
    this.numbers = mapNumbersOf(map.diagram, quantity, station, stations, units, scales.symbol);
    const [x, y] = this.measures();
    this.chart.setAxes(
      labelled(map.x.parameter, x.unit),
      labelled(map.y.parameter, y.unit),
      map.y.logarithmic,
      map.x.logarithmic,
    );
    const range = (edges: Float64Array, { factor }: Measure): Range => [edges[0]! * factor, edges.at(-1)! * factor];
    this.chart.show(range(map.x.edges, x), range(map.y.edges, y));
    this.chart.redraw();
    this.bar.show(this.numbers);
    this.placeMarks();
  }

  /// Where settings A and B are, and along which parameter the cut of the active one runs ("": along none).
  setCursors(a: Spot, b: Spot | undefined, active: 'a' | 'b', along: string): void {
    this.spot = active === 'b' && b ? b : a;
    this.marks.a.set(a, active === 'a' ? along : '');
    this.marks.b.set(b, active === 'b' ? along : '');
    this.placeMarks();
  }

  /// The cell of the active setting.
  get cell(): Cell | undefined {
    const [x, y] = this.spot;
    return this.subject && Number.isFinite(x + y) ? this.subject.map.nearest(x, y) : undefined;
  }

  /// "r_k 0.6, rho 0.08".
  placeText({ column, row }: Cell): string {
    const { map } = this.subject!;
    const [x, y] = this.measures();
    const text = (name: string, value: number, { factor, unit }: Measure) =>
      `${name} ${shown(value * factor, 6)} ${unit}`.trim();
    return `${text(map.x.parameter, map.x.values[column]!, x)}, ${text(map.y.parameter, map.y.values[row]!, y)}`;
  }

  /// Name and confidence of the verdict of a cell, the reason, and numbers.
  told(cell: Cell): { readonly verdict: string; readonly kind: number; readonly rest: string } {
    const { map } = this.subject!;
    const { diagram } = map;
    const point = map.point(cell);
    if (point < 0) return { verdict: 'not computed', kind: -1, rest: '' };
    const [name, reason] = diagram.verdicts[point]!;
    const confidence = CONFIDENCE_NAMES[diagram.confidence(point)];
    const exponent = diagram.exponent(point).value;
    const number = this.numbers?.numbers[point];
    const { attractors } = map;
    const parts = [
      attractors.length > 0 && `attractor ${map.attractorOf(point) || 'not told'} of ${attractors.length}`,
      confidence && `confidence ${confidence}`,
      readable(reason),
      Number.isFinite(exponent) ? `exponent ${shown(exponent, 7)} per revolution` : '',
      number !== undefined && this.subject!.quantity !== 'exponent'
        ? `${this.numbers!.label}: ${shown(number, 7)}`
        : '',
    ];
    return { verdict: name, kind: diagram.classes[point]!, rest: parts.filter((part) => part).join('; ') };
  }

  focus(): void {
    this.chart.overlay.focus();
  }

  /// The map, and below it the colours' legend: a bar, or the names of regimes.
  picture(): Picture {
    const box = this.chart.root.getBoundingClientRect();
    const [width, upper] = [Math.floor(box.width), Math.floor(box.height)];
    const keys = this.keys();
    const line = Math.ceil(textSize() * 2);
    const below = this.numbers ? ColourBar.height : line * (1 + (placeKeys(keys, width).at(-1)?.line ?? 0));
    const { map } = this.subject!;
    const pen = new SvgPen(width, upper + below, `Map over ${map.x.parameter} and ${map.y.parameter}`);
    this.chart.sketch(pen, width, upper);
    sketchKeys(this.numbers ? [] : keys, pen, width, upper, below, line);
    if (this.numbers) this.bar.sketch(pen, upper, width, theme());
    return { svg: pen.text(), width, height: upper + below };
  }

  table(): Table {
    const { subject } = this;
    if (!subject) return { heading: ['point'], rows: [] };
    const { map, quantity } = subject;
    const { diagram } = map;
    const [x, y] = this.measures();
    const more = this.numbers && quantity !== 'exponent' ? [this.numbers.label] : [];
    const rows: (number | string)[][] = [];
    for (let row = 0; row < map.rows; row++)
      for (let column = 0; column < map.columns; column++) {
        const point = map.point({ column, row });
        if (point < 0) continue;
        const { value, error } = diagram.exponent(point);
        rows.push([
          map.x.values[column]! * x.factor,
          map.y.values[row]! * y.factor,
          diagram.verdicts[point]![0],
          CONFIDENCE_NAMES[diagram.confidence(point)] ?? '',
          value,
          error,
          ...more.map(() => this.numbers!.numbers[point]!),
        ]);
      }
    return {
      heading: [
        labelled(map.x.parameter, x.unit),
        labelled(map.y.parameter, y.unit),
        ...['verdict', 'confidence', 'exponent per revolution', 'its error'],
        ...more,
      ],
      rows,
    };
  }

  // ---------------------------------------------------------------- drawing

  private measures(): readonly [Measure, Measure] {
    const { unitsOfAxes, units } = this.subject!;
    return [parameterMeasure(unitsOfAxes[0], units), parameterMeasure(unitsOfAxes[1], units)];
  }

  /// The colour of a point; undefined leaves its cell blank.
  private colourOf(point: number, colours: Theme): string | undefined {
    const { diagram } = this.subject!.map;
    const { numbers } = this;
    if (numbers) {
      const number = numbers.numbers[point]!;
      return Number.isNaN(number) ? undefined : colourAt(numbers.palette, partOf(numbers, number), colours);
    }
    if (this.subject!.quantity === ATTRACTOR.id) return attractorColour(this.subject!.map.attractorOf(point), colours);
    if (this.subject!.quantity !== REGIME.id) return undefined;
    const strength = STRENGTH[diagram.confidence(point)] ?? 1;
    return mixed(colours.paper, colours.classes[diagram.classes[point]!]!, strength);
  }

  private draw(pen: Pen, frame: Frame, colours: Theme): void {
    if (!this.subject) return;
    const { map, lines } = this.subject;
    const [mx, my] = this.measures();
    const x = Array.from(map.x.edges, (edge) => frame.x(edge * mx.factor));
    const y = Array.from(map.y.edges, (edge) => frame.y(edge * my.factor));
    this.drawCells(pen, x, y, frame.ratio, colours);
    if (!lines) return;
    pen.strokeStyle = colours.ink;
    pen.lineWidth = frame.ratio;
    drawBoundaries(pen, map, x, y);
  }

  /// Neighbours of one colour in a row make one piece, which reaches a little under the next: no seam is seen.
  private drawCells(pen: Pen, x: readonly number[], y: readonly number[], seam: number, colours: Theme): void {
    const { map } = this.subject!;
    for (let row = 0; row < map.rows; row++)
      for (let column = 0, next; column < map.columns; column = next) {
        const colour = this.colourAt(column, row, colours);
        for (next = column + 1; next < map.columns && this.colourAt(next, row, colours) === colour;) next++;
        if (!colour) continue;
        const [under, above] = [next < map.columns ? seam : 0, row + 1 < map.rows ? seam : 0];
        pen.fillStyle = colour;
        pen.beginPath();
        pen.rect(x[column]!, y[row + 1]! - above, x[next]! - x[column]! + under, y[row]! - y[row + 1]! + above);
        pen.fill();
      }
  }

  private colourAt(column: number, row: number, colours: Theme): string | undefined {
    const point = this.subject!.map.point({ column, row });
    return point < 0 ? undefined : this.colourOf(point, colours);
  }

  /// How many points have a regime.
  counts(): readonly number[] {
    const counts = CLASS_NAMES.map(() => 0);
    const { diagram } = this.subject!.map;
    diagram.classes.forEach((kind, point) => (counts[kind]! += diagram.done[point]!));
    return counts;
  }

  /// Names of what there is, with how many points it has, and their colours: attractors, or regimes.
  entries(): readonly MapEntry[] {
    const { map, quantity } = this.subject!;
    if (quantity !== ATTRACTOR.id)
      return this.counts().flatMap((count, kind) =>
        count === 0
          ? []
          : [{ text: CLASS_NAMES[kind]!, count: String(count), colour: (colours: Theme) => colours.classes[kind]! }],
      );
    const percent = (share: number) => `${(100 * share).toFixed(1)} %`;
    const told = map.attractors.reduce((sum, { starts }) => sum + starts, 0);
    const others = map.diagram.known - told;
    return [
      ...map.attractors.map(({ name, share, error }, i) => ({
        text: name,
        count: `${percent(share)} \u00b1 ${percent(error)}`,
        colour: (colours: Theme) => attractorColour(i + 1, colours),
      })),
      ...(others > 0
        ? [{ text: 'not told', count: String(others), colour: (colours: Theme) => attractorColour(0, colours) }]
        : []),
    ];
  }

  private keys(): readonly Key[] {
    const shares = this.subject!.quantity === ATTRACTOR.id;
    return this.entries().map(({ text, count, colour }) => ({
      ...{ sign: '\u25a0', kind: '', text: shares ? `${text} (${count})` : text },
      draw: (pen: Pen, x: number, y: number, size: number, colours: Theme) => {
        pen.fillStyle = colour(colours);
        pen.beginPath();
        pen.rect(x - 0.5 * size, y - 0.5 * size, size, size);
        pen.fill();
      },
    }));
  }

  private placeMarks(): void {
    if (!this.subject) return;
    const { map } = this.subject;
    const measures = this.measures();
    for (const mark of Object.values(this.marks)) mark.place(map, measures);
    const slider = this.chart.overlay;
    const { cell } = this;
    slider.setAttribute('aria-label', `Cell of the map over ${map.x.parameter} and ${map.y.parameter}`);
    slider.setAttribute('aria-valuemin', '1');
    slider.setAttribute('aria-valuemax', String(map.columns * map.rows));
    slider.setAttribute('aria-valuenow', String(cell ? cell.row * map.columns + cell.column + 1 : 1));
    slider.setAttribute('aria-valuetext', cell ? `${this.placeText(cell)}: ${this.told(cell).verdict}` : '');
  }

  // ---------------------------------------------------------------- hands and keys

  private cellAt(event: PointerEvent): Cell {
    const { map } = this.subject!;
    const box = this.chart.overlay.getBoundingClientRect();
    const [x, y] = this.measures();
    return {
      column: nearestOn(map.x, this.chart.valueAt(event.clientX - box.left) / x.factor),
      row: nearestOn(map.y, this.chart.heightAt(event.clientY - box.top) / y.factor),
    };
  }

  private listen(overlay: HTMLElement): void {
    let last: Cell | undefined;
    overlay.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || !this.subject || !event.isPrimary) return;
      overlay.setPointerCapture(event.pointerId);
      overlay.focus({ preventScroll: true });
      event.preventDefault();
      last = this.cellAt(event);
      this.go(last, false);
    });
    overlay.addEventListener('pointermove', (event) => {
      if (!this.subject || !event.isPrimary) return;
      const cell = this.cellAt(event);
      if (!last) this.listener.hover(event.buttons === 0 ? cell : undefined);
      else if (cell.column !== last.column || cell.row !== last.row) this.go((last = cell), false);
    });
    const end = (event: PointerEvent) => {
      if (!last || !event.isPrimary) return;
      const cell = last;
      last = undefined;
      this.go(cell, true);
    };
    overlay.addEventListener('pointerup', end);
    overlay.addEventListener('pointercancel', end);
    overlay.addEventListener('pointerleave', () => this.listener.hover(undefined));
  }

  /// Keys may come faster than frames: the next one goes on from here.
  private go(cell: Cell, settled: boolean): void {
    const { map } = this.subject!;
    this.spot = [map.x.values[cell.column]!, map.y.values[cell.row]!];
    this.listener.hover(undefined);
    this.listener.cell(cell, settled);
  }

  private key(event: KeyboardEvent): void {
    const { cell } = this;
    if (!this.subject || !cell || event.ctrlKey || event.metaKey || event.altKey) return;
    const { columns, rows } = this.subject.map;
    const many = event.shiftKey ? 10 : 1;
    const to = (column: number, row: number) =>
      this.go({ column: Math.min(columns - 1, Math.max(0, column)), row: Math.min(rows - 1, Math.max(0, row)) }, true);
    const actions: Record<string, () => void> = {
      ArrowLeft: () => to(cell.column - many, cell.row),
      ArrowRight: () => to(cell.column + many, cell.row),
      ArrowDown: () => to(cell.column, cell.row - many),
      ArrowUp: () => to(cell.column, cell.row + many),
      PageDown: () => to(cell.column, 0),
      PageUp: () => to(cell.column, rows - 1),
      Home: () => to(0, cell.row),
      End: () => to(columns - 1, cell.row),
      c: () => this.listener.turn(),
    };
    const action = actions[event.key] ?? actions[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  }
}

/// Lines where cells of two kinds meet.
function drawBoundaries(pen: Pen, map: ParameterMap, x: readonly number[], y: readonly number[]): void {
  const kinds = Float64Array.from({ length: map.columns * map.rows }, (_, i) =>
    map.kindOf(map.point({ column: i % map.columns, row: Math.floor(i / map.columns) })),
  );
  // Where nothing is known there is no boundary.
  const differ = (one: number, other: number) => kinds[one]! < kinds[other]! || kinds[one]! > kinds[other]!;
  const line = (fromX: number, fromY: number, toX: number, toY: number) => {
    pen.moveTo(fromX, fromY);
    pen.lineTo(toX, toY);
  };
  pen.beginPath();
  for (let row = 0; row < map.rows; row++)
    for (let column = 0; column < map.columns; column++) {
      const cell = row * map.columns + column;
      const [left, right, low, high] = [x[column]!, x[column + 1]!, y[row]!, y[row + 1]!];
      if (column + 1 < map.columns && differ(cell, cell + 1)) line(right, low, right, high);
      if (row + 1 < map.rows && differ(cell, cell + map.columns)) line(left, high, right, high);
    }
  pen.stroke();
}

/// The frame around the cell of a setting, and the line that its cut runs along.
class CellMark {
  private readonly frame: HTMLElement;
  private readonly line: HTMLElement;
  private spot: Spot | undefined;
  private along = '';

  constructor(
    side: 'a' | 'b',
    private readonly chart: Chart,
  ) {
    this.frame = el('div', { class: `cell-mark side-${side}`, hidden: true });
    this.line = el('div', { class: `cell-cut side-${side}`, hidden: true });
    chart.overlay.append(this.line, this.frame);
  }

  set(spot: Spot | undefined, along: string): void {
    this.spot = spot;
    this.along = along;
  }

  place(map: ParameterMap, [mx, my]: readonly [Measure, Measure]): void {
    const [x, y] = this.spot ?? [NaN, NaN];
    const inside = x >= map.x.edges[0]! && x <= map.x.edges.at(-1)! && y >= map.y.edges[0]! && y <= map.y.edges.at(-1)!;
    this.frame.hidden = !inside;
    const axis = map.axis(this.along);
    this.line.hidden = !inside || !axis;
    if (!inside) return;
    const { column, row } = map.nearest(x, y);
    const across = [column, column + 1].map((i) => this.chart.placeOf(map.x.edges[i]! * mx.factor)) as [number, number];
    const up = [row + 1, row].map((i) => this.chart.heightOf(map.y.edges[i]! * my.factor)) as [number, number];
    outline(this.frame, across, up);
    const { width, height } = this.chart.overlay.getBoundingClientRect();
    if (axis) outline(this.line, axis === map.x ? [0, width] : across, axis === map.x ? up : [0, height]);
  }
}

function outline(box: HTMLElement, [left, right]: readonly [number, number], [top, bottom]: readonly [number, number]) {
  box.style.transform = `translate(${left}px, ${top}px)`;
  box.style.width = `${right - left}px`;
  box.style.height = `${bottom - top}px`;
}
