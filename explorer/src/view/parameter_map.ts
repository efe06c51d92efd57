// A map over two parameters: its cells in the colours of regimes or of a quantity, the cells of settings A and B, and
// the handling of pointer and keys.
import { ATTRACTOR, mapNumbersOf, partOf, REGIME, type MapNumbers } from '../data/map_quantities';
import type { MapGrid } from '../data/map_grid';
import { regimeKind, type Cell, type MapAxis, type MapPlanes, type ParameterMap } from '../data/parameter_map';
import type { Diagram } from '../data/diagram';
import { CLASS_NAMES } from '../data/regimes';
import { el } from '../dom';
import type { StationInfo } from '../engine/protocol';
import { Chart, type Frame, type Range } from '../figure/chart';
import { drawCells, type Sheet } from '../figure/cells';
import { ColourBar } from '../figure/colour_bar';
import { textSize, theme, type Picture } from '../figure/figure';
import { attractorColour, colourAt, mixed } from '../figure/palette';
import { SvgPen, type Pen } from '../figure/pen';
import { CONFIDENCE_NAMES, type Theme } from '../figure/theme';
import { cellsBetween, type MapPart } from '../model/map_refinement';
import { labelled, parameterMeasure, readable, shown, type Measure, type Scales, type Units } from '../model/units';
import { placeKeys, sketchKeys, type Key } from './rest_subject';
import { MapWindow } from './map_window';
import type { Table } from './panel';

export interface ParameterMapSubject {
  readonly map: ParameterMap;
  /// All planes of the map, with the same axes.
  readonly planes: MapPlanes;
  readonly quantity: string;
  /// True to draw borders between regimes, or attractors.
  readonly lines: boolean;
  readonly station: number;
  readonly stations: readonly StationInfo[];
  readonly units: Units;
  readonly scales: Scales;
  /// SI units of the two parameters.
  readonly unitsOfAxes: readonly [string, string];
  /// Finer cells computed in the page, coarse to fine.
  readonly live: readonly MapGrid[];
}

/// An entry of a map's legend.
export interface MapEntry {
  readonly text: string;
  /// Number or share of its points.
  readonly count: string;
  colour(colours: Theme): string;
}

export interface ParameterMapListener {
  /// Called after a cell with these values was chosen; `settled` after the pointer was released.
  cell(spot: Spot, settled: boolean): void;
  /// Called while the pointer hovers over a cell; undefined after it has left the map.
  hover(spot: Spot | undefined): void;
  /// Called to cut along the other parameter.
  turn(): void;
  /// Called after zooming; `part`: only a part of the map is visible.
  zoomed(part: boolean): void;
}

/// A layer of cells: the cells of the run, or finer cells.
type Grid = ParameterMap | MapGrid;

/// A cell in its layer.
interface Found {
  readonly grid: Grid;
  readonly cell: Cell;
  readonly live: boolean;
}

/// Difference, over the size of a cell, below which values count as equal, for the last digits of a text.
const SAME = 1e-6;

/// Returns true if a spot has the values of the cell's own point, which may be at a corner of finer cells.
function isOwn({ grid, cell }: Found, [x, y]: Spot): boolean {
  const meets = ({ values, edges }: MapAxis, i: number, value: number) =>
    Math.abs(value - values[i]!) <= SAME * (edges[i + 1]! - edges[i]!);
  return meets(grid.x, cell.column, x) && meets(grid.y, cell.row, y);
}

/// A point in the plane of the two parameters, in SI.
export type Spot = readonly [number, number];

/// Share of a regime's colour by confidence: low, fair, high.
const STRENGTH = [0.4, 0.8, 1];

/// Number of colours for numbers.
const SHADES = 256;

/// Factor of zooming by a key.
const ZOOM = 1.5;

export class ParameterMapView {
  readonly root: HTMLElement;
  private readonly chart: Chart;
  private readonly bar = new ColourBar();
  private readonly marks: Readonly<Record<'a' | 'b', CellMark>>;
  private subject: ParameterMapSubject | undefined;
  private numbers: MapNumbers | undefined;
  private drawn = '';
  /// Number of points in the finer cells that are drawn.
  private liveDrawn = 0;
  private window: MapWindow | undefined;
  private readonly brush = el('div', { class: 'map-brush', hidden: true });
  private spot: Spot = [NaN, NaN];

  constructor(private readonly listener: ParameterMapListener) {
    this.chart = new Chart({ title: 'Map', over: (pen, frame, colours) => this.draw(pen, frame, colours) });
    this.chart.root.classList.add('parameter-map');
    this.chart.root.setAttribute('role', 'group');
    this.root = el('div', { class: 'map' }, this.chart.root, this.bar.root);
    const { overlay } = this.chart;
    this.marks = { a: new CellMark('a', this.chart), b: new CellMark('b', this.chart) };
    new ResizeObserver(() => this.placeMarks()).observe(overlay);
    overlay.append(this.brush);
    overlay.tabIndex = 0;
    overlay.setAttribute('role', 'slider');
    overlay.addEventListener('keydown', (event) => this.key(event));
    this.listen(overlay);
  }

  show(subject: ParameterMapSubject): void {
    const changed = this.subject?.map !== subject.map;
    if (this.subject?.planes !== subject.planes) this.window = new MapWindow(subject.map.x, subject.map.y);
    this.subject = subject;
    const { quantity, lines, station, units, scales } = subject;
    const key = JSON.stringify([quantity, lines, station, units, scales.symbol]);
    const known = subject.live.reduce((sum, { diagram }) => sum + diagram.known, 0);
    const grown = known !== this.liveDrawn;
    this.liveDrawn = known;
    if (changed || key !== this.drawn) {
      this.drawn = key;
      this.refresh();
    } else if (grown) this.chart.redraw();
  }

  /// Redraws after a change of colours.
  refresh(): void {
    const { subject } = this;
    if (!subject) return;
    const { map } = subject;
    this.numbers = this.numbersOf(map.diagram);
    const [x, y] = this.measures();
    this.chart.setAxes(
      labelled(map.x.parameter, x.unit),
      labelled(map.y.parameter, y.unit),
      map.y.logarithmic,
      map.x.logarithmic,
    );
    this.bar.show(this.numbers);
    this.look();
  }

  /// Redraws after a change of the window.
  private look(): void {
    const [x, y] = this.measures();
    const range = ([low, high]: Range, { factor }: Measure): Range => [low * factor, high * factor];
    this.chart.show(range(this.window!.x.shown, x), range(this.window!.y.shown, y));
    this.chart.redraw();
    this.placeMarks();
    this.listener.zoomed(this.window!.zoomed);
  }

  /// Shows the whole map again.
  unzoom(): void {
    this.window?.reset();
    if (this.subject) this.look();
  }

  /// Sets the positions of settings A and B, and the parameter of the cut at the active setting ("": none).
  setCursors(a: Spot, b: Spot | undefined, active: 'a' | 'b', along: string): void {
    this.spot = active === 'b' && b ? b : a;
    this.marks.a.set(a, active === 'a' ? along : '');
    this.marks.b.set(b, active === 'b' ? along : '');
    this.placeMarks();
  }

  /// The visible cells of the map.
  get part(): MapPart {
    const { x, y } = this.subject!.map;
    return { across: cellsBetween(x, this.window!.x.shown), up: cellsBetween(y, this.window!.y.shown) };
  }

  /// Position of the active setting; undefined before there is one.
  get cursor(): Spot | undefined {
    return this.subject && Number.isFinite(this.spot[0] + this.spot[1]) ? this.spot : undefined;
  }

  /// The cell of the active setting.
  get cell(): Cell | undefined {
    const [x, y] = this.spot;
    return this.subject && Number.isFinite(x + y) ? this.subject.map.nearest(x, y) : undefined;
  }

  /// Finer cells that are drawn: all, unless the map shows attractors, which they do not have.
  private get live(): readonly MapGrid[] {
    const { live, quantity } = this.subject!;
    return quantity === ATTRACTOR.id ? [] : live;
  }

  /// Returns the cell with the values of a spot, else the finest cell drawn there.
  private find([x, y]: Spot): Found {
    const { map } = this.subject!;
    const all: Found[] = [{ grid: map, cell: map.nearest(x, y), live: false }];
    for (const grid of this.live) {
      const cell = grid.at(x, y);
      if (cell) all.push({ grid, cell, live: true });
    }
    return all.find((found) => isOwn(found, [x, y])) ?? all.at(-1)!;
  }

  /// Returns the values of the finest cell at a spot.
  private middleOf(spot: Spot): Spot {
    const { grid, cell } = this.find(spot);
    return [grid.x.values[cell.column]!, grid.y.values[cell.row]!];
  }

  /// Returns the text of a spot: "r_k 0.6, rho 0.08".
  placeText(spot: Spot): string {
    const { map } = this.subject!;
    const [x, y] = this.measures();
    const [atX, atY] = this.middleOf(spot);
    const text = (name: string, value: number, { factor, unit }: Measure) =>
      `${name} ${shown(value * factor, 6)} ${unit}`.trim();
    return `${text(map.x.parameter, atX, x)}, ${text(map.y.parameter, atY, y)}`;
  }

  /// Returns name and confidence of the verdict of the cell at a spot, the reason, and numbers.
  describe(spot: Spot): { readonly verdict: string; readonly kind: number; readonly rest: string } {
    const { map } = this.subject!;
    const { grid, cell, live } = this.find(spot);
    const { diagram } = grid;
    const point = grid.pointAt(cell.row * grid.columns + cell.column);
    if (point < 0) return { verdict: 'not computed', kind: -1, rest: '' };
    const [name, reason] = diagram.verdicts[point]!;
    const kind = diagram.classes[point]!;
    if (!live && !map.isComputed(cell))
      return { verdict: name, kind, rest: 'not computed; the corners of its square agree' };
    const confidence = CONFIDENCE_NAMES[diagram.confidence(point)];
    const exponent = diagram.exponent(point).value;
    const numbers = live ? this.numbersOf(diagram) : this.numbers;
    const number = numbers?.numbers[point];
    const { attractors } = map;
    const parts = [
      live && 'computed in this page',
      !live && attractors.length > 0 && `attractor ${map.attractorOf(point) || 'unknown'} of ${attractors.length}`,
      confidence && `confidence ${confidence}`,
      readable(reason),
      Number.isFinite(exponent) ? `exponent ${shown(exponent, 7)} per revolution` : '',
      number !== undefined && this.subject!.quantity !== 'exponent' ? `${numbers!.label}: ${shown(number, 7)}` : '',
    ];
    return { verdict: name, kind, rest: parts.filter((part) => part).join('; ') };
  }

  focus(): void {
    this.chart.overlay.focus();
  }

  /// Returns the picture: the map, and below it a colour bar or the names of regimes.
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
        if (point < 0 || !map.isComputed({ column, row })) continue;
        const { value, error } = diagram.exponent(point);
        rows.push([
          map.x.values[column]! * x.factor,
          map.y.values[row]! * y.factor,
          ...(map.plane ? [map.plane.value] : []),
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
        ...(map.plane ? [`${map.plane.parameter} (SI)`] : []),
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

  /// Returns the numbers that the map shows; undefined for regimes and attractors.
  private numbersOf(diagram: Diagram): MapNumbers | undefined {
    const { quantity, station, stations, units, scales } = this.subject!;
    return mapNumbersOf(diagram, quantity, station, stations, units, scales.symbol);
  }

  /// Returns a function for the colour of a point; undefined leaves its cell blank. Numbers have one of SHADES colours,
  /// also in finer cells by the colour scale of the map.
  private colouring(grid: Grid, colours: Theme): (point: number) => string | undefined {
    const { map, quantity } = this.subject!;
    const { diagram } = grid;
    const { numbers: bar } = this;
    if (bar) {
      const numbers = grid === map ? bar.numbers : this.numbersOf(diagram)?.numbers;
      const palette = Array.from({ length: SHADES }, (_, i) => colourAt(bar.palette, i / (SHADES - 1), colours));
      return (point) => {
        const part = Math.min(1, Math.max(0, partOf(bar, numbers?.[point] ?? NaN)));
        return palette[Math.round(part * (SHADES - 1))]; // undefined for NaN
      };
    }
    if (quantity === ATTRACTOR.id) return (point) => attractorColour(map.attractorOf(point), colours);
    if (quantity !== REGIME.id) return () => undefined;
    const strong = colours.classes.map((colour) => STRENGTH.map((part) => mixed(colours.paper, colour, part)));
    return (point) =>
      strong[diagram.classes[point]!]![diagram.confidence(point)] ?? colours.classes[diagram.classes[point]!];
  }

  private draw(pen: Pen, frame: Frame, colours: Theme): void {
    if (!this.subject) return;
    const { map } = this.subject;
    this.drawGrid(map, pen, frame, colours);
    const { live } = this;
    for (const grid of live) this.drawGrid(grid, pen, frame, colours);
    if (live[0]) this.outlineLive(live[0], pen, frame, colours);
  }

  private drawGrid(grid: Grid, pen: Pen, frame: Frame, colours: Theme): void {
    const { map, lines } = this.subject!;
    const [mx, my] = this.measures();
    const colourOf = this.colouring(grid, colours);
    // Draw blank finer cells, which hide the cells below them.
    const blank = grid === map ? undefined : colours.paper;
    const kindOf = (point: number) => (grid === map ? map.kindOf(point) : regimeKind(grid.diagram, point));
    const sheet: Sheet = {
      columns: grid.columns,
      rows: grid.rows,
      x: Array.from(grid.x.edges, (edge) => frame.x(edge * mx.factor)),
      y: Array.from(grid.y.edges, (edge) => frame.y(edge * my.factor)),
      colour: (cell) => {
        const point = grid.pointAt(cell);
        return point < 0 ? undefined : (colourOf(point) ?? blank);
      },
      kind: lines ? (cell) => kindOf(grid.pointAt(cell)) : undefined,
      ink: colours.ink,
    };
    drawCells(pen, sheet, frame);
  }

  /// Draws a dashed outline around the visible finer cells, which are not stored in the result.
  private outlineLive({ x, y }: MapGrid, pen: Pen, frame: Frame, colours: Theme): void {
    const [mx, my] = this.measures();
    const seen = (value: number, first: number, size: number) =>
      Math.min(first + size - frame.ratio, Math.max(first + frame.ratio, value));
    const across = (edge: number) => seen(frame.x(edge * mx.factor), frame.left, frame.width);
    const up = (edge: number) => seen(frame.y(edge * my.factor), frame.top, frame.height);
    const [left, right, bottom, top] = [
      across(x.edges[0]!),
      across(x.edges.at(-1)!),
      up(y.edges[0]!),
      up(y.edges.at(-1)!),
    ];
    pen.save();
    pen.strokeStyle = colours.ink;
    pen.lineWidth = 2 * frame.ratio;
    pen.setLineDash([6 * frame.ratio, 4 * frame.ratio]);
    pen.beginPath();
    pen.rect(left, top, right - left, bottom - top);
    pen.stroke();
    pen.restore();
  }

  /// Returns the number of the plane's points for each class of regimes.
  counts(): readonly number[] {
    const counts = CLASS_NAMES.map(() => 0);
    const { map } = this.subject!;
    for (const point of map.computed) counts[map.diagram.classes[point]!]!++;
    return counts;
  }

  /// Returns the entries of the legend: attractors or regimes with their points and colours.
  entries(): readonly MapEntry[] {
    const { map, quantity } = this.subject!;
    const finer = new Set(this.live.flatMap(({ diagram }) => [...diagram.classes.filter((_, i) => diagram.done[i])]));
    if (quantity !== ATTRACTOR.id)
      return this.counts().flatMap((count, kind) =>
        count === 0 && !finer.has(kind)
          ? []
          : [{ text: CLASS_NAMES[kind]!, count: String(count), colour: (colours: Theme) => colours.classes[kind]! }],
      );
    const percent = (share: number) => `${(100 * share).toFixed(1)} %`;
    const counted = map.attractors.reduce((sum, { starts }) => sum + starts, 0);
    const others = map.diagram.known - counted;
    return [
      ...map.attractors.map(({ name, share, error }, i) => ({
        text: name,
        count: `${percent(share)} \u00b1 ${percent(error)}`,
        colour: (colours: Theme) => attractorColour(i + 1, colours),
      })),
      ...(others > 0
        ? [{ text: 'unknown', count: String(others), colour: (colours: Theme) => attractorColour(0, colours) }]
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
    for (const mark of Object.values(this.marks)) mark.place(map, (spot) => this.find(spot), measures);
    const slider = this.chart.overlay;
    const { cell } = this;
    slider.setAttribute('aria-label', `Cell of the map over ${map.x.parameter} and ${map.y.parameter}`);
    slider.setAttribute('aria-valuemin', '1');
    slider.setAttribute('aria-valuemax', String(map.columns * map.rows));
    slider.setAttribute('aria-valuenow', String(cell ? cell.row * map.columns + cell.column + 1 : 1));
    slider.setAttribute(
      'aria-valuetext',
      this.cursor ? `${this.placeText(this.cursor)}: ${this.describe(this.cursor).verdict}` : '',
    );
  }

  // ---------------------------------------------------------------- pointer and keys

  /// Returns both values under the pointer.
  private spotAt(event: MouseEvent): Spot {
    const box = this.chart.overlay.getBoundingClientRect();
    const [x, y] = this.measures();
    return [
      this.chart.valueAt(event.clientX - box.left) / x.factor,
      this.chart.heightAt(event.clientY - box.top) / y.factor,
    ];
  }

  /// Returns the values of the cell under the pointer.
  private cellAt(event: MouseEvent): Spot {
    return this.middleOf(this.spotAt(event));
  }

  private showBrush(from: Spot, to: Spot): void {
    const [mx, my] = this.measures();
    const across = [from[0], to[0]].map((value) => this.chart.placeOf(value * mx.factor)).sort((a, b) => a - b);
    const up = [from[1], to[1]].map((value) => this.chart.heightOf(value * my.factor)).sort((a, b) => a - b);
    this.brush.hidden = false;
    outline(this.brush, across as [number, number], up as [number, number]);
  }

  private zoom(by: number, spot: Spot): void {
    this.window!.zoom(by, spot);
    this.look();
  }

  private listen(overlay: HTMLElement): void {
    let last: Spot | undefined;
    let brushed: Spot | undefined;
    overlay.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    overlay.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || !this.subject || !event.isPrimary) return;
      overlay.setPointerCapture(event.pointerId);
      overlay.focus({ preventScroll: true });
      event.preventDefault();
      if (event.shiftKey) {
        brushed = this.spotAt(event);
        return;
      }
      last = this.cellAt(event);
      this.go(last, false);
    });
    overlay.addEventListener('pointermove', (event) => {
      if (!this.subject || !event.isPrimary) return;
      if (brushed) {
        this.showBrush(brushed, this.spotAt(event));
        return;
      }
      const cell = this.cellAt(event);
      if (!last) this.listener.hover(event.buttons === 0 ? cell : undefined);
      else if (cell[0] !== last[0] || cell[1] !== last[1]) this.go((last = cell), false);
    });
    const end = (event: PointerEvent) => {
      if (brushed && event.type === 'pointerup') this.seeBrushed(brushed, this.spotAt(event));
      brushed = undefined;
      this.brush.hidden = true;
      if (!last || !event.isPrimary) return;
      const cell = last;
      last = undefined;
      this.go(cell, true);
    };
    overlay.addEventListener('pointerup', end);
    overlay.addEventListener('pointercancel', end);
    overlay.addEventListener('pointerleave', () => this.listener.hover(undefined));
  }

  private seeBrushed(from: Spot, to: Spot): void {
    this.window!.x.brush(from[0], to[0]);
    this.window!.y.brush(from[1], to[1]);
    this.look();
  }

  private wheel(event: WheelEvent): void {
    // The wheel scrolls the page unless the map has the focus.
    if (!this.subject || document.activeElement !== this.chart.overlay) return;
    event.preventDefault();
    this.zoom(Math.exp(Math.max(-80, Math.min(80, event.deltaY)) / 300), this.spotAt(event));
  }

  /// Moves the cursor at once: keys may come faster than frames, and the next key starts from the new spot.
  private go(spot: Spot, settled: boolean): void {
    this.spot = spot;
    if (this.window!.zoomed) {
      const { column, row } = this.subject!.map.nearest(...spot);
      this.window!.x.follow(column);
      this.window!.y.follow(row);
      this.look();
    }
    this.listener.hover(undefined);
    this.listener.cell(spot, settled);
  }

  private key(event: KeyboardEvent): void {
    const { cell } = this;
    if (!this.subject || !cell || event.ctrlKey || event.metaKey || event.altKey) return;
    const { columns, rows, x, y } = this.subject.map;
    const within = (i: number, count: number) => Math.min(count - 1, Math.max(0, i));
    const many = event.shiftKey ? 10 : 1;
    const to = (column: number, row: number) =>
      this.go([x.values[within(column, columns)]!, y.values[within(row, rows)]!], true);
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
      '+': () => this.zoom(1 / ZOOM, this.spot),
      '=': () => this.zoom(1 / ZOOM, this.spot),
      '-': () => this.zoom(ZOOM, this.spot),
    };
    const action = actions[event.key] ?? actions[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action();
  }
}

/// The frame around the cell of a setting, and the line of its cut.
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

  place(map: ParameterMap, find: (spot: Spot) => Found, [mx, my]: readonly [Measure, Measure]): void {
    const [x, y] = this.spot ?? [NaN, NaN];
    const inside = x >= map.x.edges[0]! && x <= map.x.edges.at(-1)! && y >= map.y.edges[0]! && y <= map.y.edges.at(-1)!;
    const [seenX, seenY] = [this.chart.isSeen(x * mx.factor, 'x'), this.chart.isSeen(y * my.factor, 'y')];
    this.frame.hidden = !inside || !seenX || !seenY;
    const axis = map.axis(this.along);
    this.line.hidden = !inside || !axis || !(axis === map.x ? seenY : seenX);
    if (!inside) return;
    const { grid, cell } = find([x, y]);
    const { column, row } = cell;
    const across = [column, column + 1].map((i) => this.chart.placeOf(grid.x.edges[i]! * mx.factor)) as [
      number,
      number,
    ];
    const up = [row + 1, row].map((i) => this.chart.heightOf(grid.y.edges[i]! * my.factor)) as [number, number];
    const { width, height } = this.chart.overlay.getBoundingClientRect();
    const within = ([low, high]: readonly [number, number], size: number): [number, number] => [
      Math.max(0, low),
      Math.min(size, high),
    ];
    outline(this.frame, within(across, width), within(up, height)); // a cell at the edge may be partly visible
    if (axis) outline(this.line, axis === map.x ? [0, width] : across, axis === map.x ? up : [0, height]);
  }
}

function outline(box: HTMLElement, [left, right]: readonly [number, number], [top, bottom]: readonly [number, number]) {
  box.style.transform = `translate(${left}px, ${top}px)`;
  box.style.width = `${right - left}px`;
  box.style.height = `${bottom - top}px`;
}
