// The diagram: a quantity over the parameter, the exponent below on the same axis, and the cursors that ask for
// motions.
import type { Diagram } from '../data/diagram';
import { CLASS_NAMES } from '../data/regimes';
import { quantityOf, type ShownQuantity } from '../data/quantities';
import { el } from '../dom';
import type { StationInfo } from '../engine/protocol';
import { Chart, type Frame, type Range } from '../figure/chart';
import { drawCloud, type Cloud } from '../figure/cloud';
import { theme, textSize, type Picture } from '../figure/figure';
import { font, SvgPen, type Pen } from '../figure/pen';
import type { Theme } from '../figure/theme';
import { labelled, parameterMeasure, shown, type Scales, type Units } from '../model/units';
import type { Table } from './panel';

export type Mode = 'point' | 'range' | 'pan';

export interface MapSubject {
  readonly diagram: Diagram | undefined;
  readonly parameter: string;
  /// SI unit of the parameter.
  readonly unit: string;
  readonly quantity: string;
  readonly station: number;
  readonly stations: readonly StationInfo[];
  readonly units: Units;
  readonly scales: Scales;
  /// In SI.
  readonly range: Range;
  readonly hidden: ReadonlySet<number>;
}

export interface MapListener {
  /// A value was chosen, in SI; `settled` when the pointer let go.
  cursor(value: number, settled: boolean): void;
  /// A range was brushed, in SI.
  brushed(range: Range): void;
  /// The view was zoomed or moved, in SI.
  viewed(range: Range): void;
  back(): void;
}

/// The part of the height that the ribbons at the bottom take.
const RIBBON = 0.07;
const KEYBOARD_STEPS = 200;

export class MapView {
  readonly root: HTMLElement;
  mode: Mode = 'point';
  private subject: MapSubject | undefined;
  private quantity: ShownQuantity | undefined;
  private label = '';
  private shapes = false;
  private readonly main: Chart;
  private readonly exponent: Chart;
  private readonly cursors: readonly [CursorLine, CursorLine];
  private readonly brush = el('div', { class: 'brush', hidden: true });
  private readonly empty = el('p', { class: 'empty' });
  private order: readonly number[] = [];
  private value = NaN;

  constructor(private readonly listener: MapListener) {
    this.main = new Chart({
      title: 'Diagram',
      bareX: true,
      under: (pen, frame, colours) => this.drawContact(pen, frame, colours),
      over: (pen, frame, colours) => this.drawMain(pen, frame, colours),
    });
    this.exponent = new Chart({
      title: 'Largest Lyapunov exponent',
      under: (pen, frame, colours) => this.drawContact(pen, frame, colours),
      over: (pen, frame, colours) => this.drawExponent(pen, frame, colours),
    });
    this.cursors = [new CursorLine('a'), new CursorLine('b')];
    for (const cursor of this.cursors) {
      this.main.overlay.append(cursor.upper);
      this.exponent.overlay.append(cursor.lower);
    }
    this.main.overlay.append(this.brush);
    this.main.root.classList.add('map-main');
    this.exponent.root.classList.add('map-exponent');
    // They hold a slider, which a picture would hide from assistive programs.
    for (const chart of [this.main, this.exponent]) chart.root.setAttribute('role', 'group');
    this.root = el('div', { class: 'map' }, this.main.root, this.exponent.root, this.empty);
    this.listen(this.main.overlay);
    this.listen(this.exponent.overlay);
    this.main.overlay.tabIndex = 0;
    this.main.overlay.setAttribute('role', 'slider');
    this.main.overlay.addEventListener('keydown', (event) => this.key(event));
  }

  show(subject: MapSubject): void {
    if (subject.diagram !== this.subject?.diagram) this.order = [];
    this.subject = subject;
    const { diagram } = subject;
    if (diagram && this.order.length !== diagram.count)
      this.order = Array.from(diagram.values.keys()).sort((a, b) => diagram.values[a]! - diagram.values[b]!);
    this.refresh();
  }

  /// What is shown of the diagram: an awaited one has its columns, and their scale, once the first points come in.
  private showQuantity(subject: MapSubject): void {
    const { diagram } = subject;
    this.quantity =
      diagram &&
      quantityOf(diagram, subject.quantity, subject.station, subject.stations, subject.units, subject.scales.symbol);
    const xLabel = labelled(subject.parameter, parameterMeasure(subject.unit, subject.units).unit);
    if (this.quantity || diagram?.known) this.label = this.quantity?.label ?? '';
    this.main.setAxes(xLabel, this.label);
    this.exponent.setAxes(xLabel, 'exponent / rev.');
    this.empty.textContent = this.quantity || !diagram?.known ? '' : 'The run does not have this quantity.';
  }

  /// After points have come in, or colours have changed.
  refresh(): void {
    const subject = this.subject;
    if (!subject) return;
    this.showQuantity(subject);
    const measure = parameterMeasure(subject.unit, subject.units);
    const x: Range = [subject.range[0] * measure.factor, subject.range[1] * measure.factor];
    this.main.show(x, this.mainRange(subject));
    this.exponent.show(x, this.exponentRange(subject));
    this.main.redraw();
    this.exponent.redraw();
    this.placeCursors();
  }

  /// The values of settings A and B in SI; NaN hides a cursor.
  setCursors(a: number, b: number): void {
    this.value = a;
    this.cursors[0].value = a;
    this.cursors[1].value = b;
    this.placeCursors();
  }

  focus(): void {
    this.main.overlay.focus();
  }

  picture(): Picture {
    const boxes = [this.main, this.exponent].map((chart) => chart.root.getBoundingClientRect());
    const [width, upper, lower] = [
      Math.floor(boxes[0]!.width),
      Math.floor(boxes[0]!.height),
      Math.floor(boxes[1]!.height),
    ];
    const legend = Math.ceil(textSize() * 2);
    const pen = new SvgPen(width, upper + lower + legend, 'Bifurcation diagram');
    this.shapes = true;
    this.main.sketch(pen, width, upper);
    pen.save();
    pen.translate(0, upper);
    this.exponent.sketch(pen, width, lower);
    pen.restore();
    this.shapes = false;
    this.sketchLegend(pen, width, upper + lower, legend);
    return { svg: pen.text(), width, height: upper + lower + legend };
  }

  table(): Table {
    const subject = this.subject;
    const { diagram } = subject ?? {};
    if (!subject || !diagram) return { heading: ['point'], rows: [] };
    const measure = parameterMeasure(subject.unit, subject.units);
    const quantity = this.quantity;
    const rows = quantity?.column.rows ?? 0;
    const label = quantity?.label ?? '';
    return {
      heading: [
        labelled(subject.parameter, measure.unit),
        'branch',
        'verdict',
        'exponent per revolution',
        'its error',
        'contact share',
        ...Array.from({ length: rows }, (_, row) => (rows === 1 ? label : `${label} ${row + 1}`)),
      ],
      rows: this.order
        .filter((point) => diagram.done[point])
        .map((point) => {
          const exponent = diagram.exponent(point);
          const numbers = Array.from(
            quantity?.column.data.subarray(point * rows, (point + 1) * rows) ?? [],
            (value) => value * quantity!.factor,
          );
          return [
            diagram.values[point]! * measure.factor,
            diagram.branch[point]!,
            diagram.verdicts[point]![0],
            exponent.value,
            exponent.error,
            diagram.contact(point),
            ...numbers,
          ];
        }),
    };
  }

  // ---------------------------------------------------------------- ranges

  private visible(subject: MapSubject, visit: (point: number) => void): void {
    const { diagram, range, hidden } = subject;
    if (!diagram) return;
    for (let point = 0; point < diagram.count; point++) {
      const value = diagram.values[point]!;
      if (diagram.done[point] && value >= range[0] && value <= range[1] && !hidden.has(diagram.classes[point]!))
        visit(point);
    }
  }

  private mainRange(subject: MapSubject): Range {
    const quantity = this.quantity;
    let [low, high] = [Infinity, -Infinity];
    if (quantity)
      this.visible(subject, (point) => {
        const { rows, data } = quantity.column;
        for (let i = point * rows; i < (point + 1) * rows; i++) {
          const value = data[i]!;
          if (value < low) low = value;
          if (value > high) high = value;
        }
      });
    if (!(low <= high)) return [0, 1];
    const factor = quantity!.factor;
    const room = 0.04 * (high - low) * factor || Math.abs(high * factor) * 0.1 || 1;
    [low, high] = [low * factor - room, high * factor + room];
    return [low - RIBBON * 1.2 * (high - low), high];
  }

  /// The strongest decays are left out: they would press everything else against zero.
  private exponentRange(subject: MapSubject): Range {
    const values: number[] = [];
    this.visible(subject, (point) => {
      const { value } = subject.diagram!.exponent(point);
      if (Number.isFinite(value)) values.push(value);
    });
    if (!values.length) return [-1, 1];
    values.sort((a, b) => a - b);
    const low = Math.min(values[Math.floor(values.length * 0.02)]!, 0);
    const high = Math.max(values.at(-1)!, 0);
    const room = 0.12 * (high - low) || 0.1;
    return [low - room, high + room];
  }

  // ---------------------------------------------------------------- drawing

  private drawMain(pen: Pen, frame: Frame, colours: Theme): void {
    const cloud = this.cloud();
    if (!cloud) return;
    drawCloud(pen, cloud, frame, colours, this.shapes);
    this.drawRibbon(pen, frame, colours);
  }

  private cloud(): Cloud | undefined {
    const { subject, quantity } = this;
    if (!subject?.diagram || !quantity) return undefined;
    return {
      diagram: subject.diagram,
      column: quantity.column,
      factor: quantity.factor,
      valueFactor: parameterMeasure(subject.unit, subject.units).factor,
      hidden: subject.hidden,
    };
  }

  private drawExponent(pen: Pen, frame: Frame, colours: Theme): void {
    const { subject } = this;
    const column =
      subject?.diagram && (subject.diagram.column('lyapunov/largest') ?? subject.diagram.column('regime/exponent'));
    if (!subject?.diagram || !column) return;
    pen.strokeStyle = colours.muted;
    pen.lineWidth = frame.ratio;
    pen.beginPath();
    pen.moveTo(frame.left, frame.y(0));
    pen.lineTo(frame.left + frame.width, frame.y(0));
    pen.stroke();
    this.drawErrors(pen, frame, subject, colours);
    const valueFactor = parameterMeasure(subject.unit, subject.units).factor;
    drawCloud(
      pen,
      { diagram: subject.diagram, column, factor: 1, valueFactor, hidden: subject.hidden },
      frame,
      colours,
      this.shapes,
    );
  }

  /// Standard errors, where they are wide enough to be seen.
  private drawErrors(pen: Pen, frame: Frame, subject: MapSubject, colours: Theme): void {
    const factor = parameterMeasure(subject.unit, subject.units).factor;
    const diagram = subject.diagram!;
    pen.strokeStyle = colours.muted;
    pen.beginPath();
    this.visible(subject, (point) => {
      const { value, error } = diagram.exponent(point);
      const [top, bottom] = [frame.y(value + error), frame.y(value - error)];
      if (!(bottom - top > 3 * frame.ratio)) return;
      const x = frame.x(diagram.values[point]! * factor);
      pen.moveTo(x, top);
      pen.lineTo(x, bottom);
    });
    pen.stroke();
  }

  /// Calls `visit` for every point in view with the pixels that it stands for, half-way to its neighbours.
  private cells(frame: Frame, visitor: (point: number, left: number, right: number) => void): void {
    const { subject, order } = this;
    const { diagram } = subject ?? {};
    if (!subject || !diagram) return;
    const factor = parameterMeasure(subject.unit, subject.units).factor;
    for (const branch of [1, 0, -1]) {
      const mine = order.filter((point) => diagram.branch[point] === branch && diagram.done[point]);
      const place = (i: number) => frame.x(diagram.values[mine[i]!]! * factor);
      for (let i = 0; i < mine.length; i++) {
        const here = place(i);
        const left = i > 0 ? (place(i - 1) + here) / 2 : here - (mine.length > 1 ? place(1) - here : 4) / 2;
        const right =
          i + 1 < mine.length ? (place(i + 1) + here) / 2 : here + (mine.length > 1 ? here - place(i - 1) : 4) / 2;
        if (right >= frame.left && left <= frame.left + frame.width) visitor(mine[i]!, left, right);
      }
    }
  }

  private drawContact(pen: Pen, frame: Frame, colours: Theme): void {
    const diagram = this.subject?.diagram;
    if (!diagram?.column('rub/share')) return;
    pen.fillStyle = colours.contactShade;
    pen.beginPath();
    this.cells(frame, (point, left, right) => {
      if (diagram.branch[point]! >= 0 && diagram.contact(point) > 0)
        pen.rect(left, frame.top, right - left, frame.height);
    });
    pen.fill();
  }

  /// Regimes in a ribbon along the bottom, and confidence above it where the run states one.
  private drawRibbon(pen: Pen, frame: Frame, colours: Theme): void {
    const diagram = this.subject!.diagram!;
    const thick = 6 * frame.ratio;
    const both = diagram.branch.includes(-1) && diagram.branch.includes(1);
    const bottom = frame.top + frame.height;
    this.cells(frame, (point, left, right) => {
      const height = both ? thick / 2 : thick;
      const top = bottom - thick + (both && diagram.branch[point]! < 0 ? height : 0);
      pen.fillStyle = colours.classes[diagram.classes[point]!]!;
      pen.beginPath();
      pen.rect(left, top, right - left + 0.5, height);
      pen.fill();
      const confidence = diagram.confidence(point);
      if (!(confidence >= 0)) return;
      pen.globalAlpha = [0.12, 0.45, 1][confidence] ?? 0.12;
      pen.fillStyle = colours.ink;
      pen.beginPath();
      pen.rect(left, bottom - thick - 5 * frame.ratio, right - left + 0.5, 3 * frame.ratio);
      pen.fill();
      pen.globalAlpha = 1;
    });
  }

  private sketchLegend(pen: Pen, width: number, top: number, height: number): void {
    const colours = theme();
    const size = textSize();
    pen.fillStyle = colours.paper;
    pen.beginPath();
    pen.rect(0, top, width, height);
    pen.fill();
    pen.font = font(size);
    pen.textAlign = 'left';
    pen.textBaseline = 'middle';
    let x = 5 * size;
    for (const { name, kind } of this.legend()) {
      pen.fillStyle = colours.classes[kind]!;
      pen.beginPath();
      pen.rect(x, top + height / 2 - 4, 8, 8);
      pen.fill();
      pen.fillStyle = colours.ink;
      pen.fillText(name, x + 12, top + height / 2);
      x += 24 + name.length * size * 0.56;
    }
  }

  private legend(): { name: string; kind: number }[] {
    const diagram = this.subject?.diagram;
    if (!diagram) return [];
    const there = new Set(Array.from(diagram.classes).filter((_, point) => diagram.done[point]));
    return CLASS_ENTRIES.filter(({ kind }) => there.has(kind));
  }

  // ---------------------------------------------------------------- cursors, zoom, keys

  private placeCursors(): void {
    const subject = this.subject;
    if (!subject) return;
    const measure = parameterMeasure(subject.unit, subject.units);
    for (const cursor of this.cursors) {
      const inside = cursor.value >= subject.range[0] && cursor.value <= subject.range[1];
      cursor.place(inside ? this.main.placeOf(cursor.value * measure.factor) : NaN, this.main.area.width);
    }
    const slider = this.main.overlay;
    slider.setAttribute('aria-label', `Value of ${subject.parameter}`);
    slider.setAttribute('aria-valuemin', String(subject.range[0] * measure.factor));
    slider.setAttribute('aria-valuemax', String(subject.range[1] * measure.factor));
    slider.setAttribute('aria-valuenow', String(this.value * measure.factor));
    slider.setAttribute(
      'aria-valuetext',
      `${subject.parameter} ${shown(this.value * measure.factor, 6)} ${measure.unit}`,
    );
  }

  private valueAt(overlay: HTMLElement, clientX: number): number {
    const subject = this.subject!;
    const box = overlay.getBoundingClientRect();
    const part = Math.min(1, Math.max(0, (clientX - box.left) / box.width));
    return subject.range[0] + part * (subject.range[1] - subject.range[0]);
  }

  private listen(overlay: HTMLElement): void {
    let doing: Mode | undefined;
    let from = NaN;
    let last = NaN;
    const fingers = new Map<number, number>();
    overlay.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || !this.subject) return;
      overlay.setPointerCapture(event.pointerId);
      this.main.overlay.focus({ preventScroll: true });
      event.preventDefault();
      fingers.set(event.pointerId, event.clientX);
      if (fingers.size > 1) {
        doing = undefined;
        this.brush.hidden = true;
        return;
      }
      doing = event.shiftKey ? 'range' : this.mode;
      from = last = this.valueAt(overlay, event.clientX);
      if (doing === 'point') this.listener.cursor(from, false);
    });
    overlay.addEventListener('pointermove', (event) => {
      if (!this.subject) return;
      if (fingers.size === 2 && fingers.has(event.pointerId)) this.pinch(overlay, fingers, event);
      if (!doing) return;
      const value = this.valueAt(overlay, event.clientX);
      if (doing === 'point' && value !== last) this.listener.cursor(value, false);
      if (doing === 'range') this.showBrush(from, value);
      if (doing === 'pan') this.pan(from - value);
      last = value;
    });
    const end = (event: PointerEvent, cancelled: boolean) => {
      fingers.delete(event.pointerId);
      if (!doing || !this.subject) return;
      const value = this.valueAt(overlay, event.clientX);
      if (doing === 'point') this.listener.cursor(cancelled ? last : value, true);
      if (doing === 'range') this.endBrush(from, value, cancelled);
      doing = undefined;
    };
    overlay.addEventListener('pointerup', (event) => end(event, false));
    overlay.addEventListener('pointercancel', (event) => end(event, true));
    overlay.addEventListener('wheel', (event) => this.wheel(overlay, event), { passive: false });
  }

  /// Two fingers zoom and move: what is under them stays under them.
  private pinch(overlay: HTMLElement, fingers: Map<number, number>, event: PointerEvent): void {
    const before = [...fingers.values()];
    fingers.set(event.pointerId, event.clientX);
    const now = [...fingers.values()];
    const apart = (places: readonly number[]) => Math.max(20, Math.abs(places[0]! - places[1]!));
    const middle = (places: readonly number[]) => this.valueAt(overlay, (places[0]! + places[1]!) / 2);
    const by = apart(before) / apart(now);
    const [low, high] = this.subject!.range;
    const [about, to] = [middle(before), middle(now)];
    const shift = (about - to) * by;
    this.listener.viewed([about - (about - low) * by + shift, about + (high - about) * by + shift]);
  }

  private wheel(overlay: HTMLElement, event: WheelEvent): void {
    // The page scrolls until the diagram is in use.
    if (!this.subject || document.activeElement !== this.main.overlay) return;
    event.preventDefault();
    if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      this.pan(((this.subject.range[1] - this.subject.range[0]) * event.deltaX) / 800);
      return;
    }
    this.zoom(Math.exp(Math.max(-80, Math.min(80, event.deltaY)) / 300), this.valueAt(overlay, event.clientX));
  }

  private zoom(by: number, about: number): void {
    const [low, high] = this.subject!.range;
    this.listener.viewed([about - (about - low) * by, about + (high - about) * by]);
  }

  private pan(by: number): void {
    const [low, high] = this.subject!.range;
    this.listener.viewed([low + by, high + by]);
  }

  private showBrush(from: number, to: number): void {
    const factor = parameterMeasure(this.subject!.unit, this.subject!.units).factor;
    const [left, right] = [
      this.main.placeOf(Math.min(from, to) * factor),
      this.main.placeOf(Math.max(from, to) * factor),
    ];
    this.brush.hidden = false;
    this.brush.style.left = `${left}px`;
    this.brush.style.width = `${right - left}px`;
  }

  private endBrush(from: number, to: number, cancelled: boolean): void {
    this.brush.hidden = true;
    const [low, high] = [Math.min(from, to), Math.max(from, to)];
    const span = this.subject!.range[1] - this.subject!.range[0];
    if (!cancelled && high - low > span * 0.004) this.listener.brushed([low, high]);
  }

  private key(event: KeyboardEvent): void {
    const subject = this.subject;
    if (!subject || event.ctrlKey || event.metaKey || event.altKey) return;
    const [low, high] = subject.range;
    const step = ((high - low) / KEYBOARD_STEPS) * (event.shiftKey ? 10 : 1);
    const now = Number.isFinite(this.value) ? this.value : (low + high) / 2;
    // Keys may come faster than frames: the next one goes on from here.
    const go = (value: number) => {
      this.value = Math.min(high, Math.max(low, value));
      this.listener.cursor(this.value, true);
    };
    const actions: Record<string, () => void> = {
      ArrowLeft: () => go(now - step),
      ArrowRight: () => go(now + step),
      ArrowDown: () => go(now - step),
      ArrowUp: () => go(now + step),
      PageDown: () => go(now - (high - low) / 20),
      PageUp: () => go(now + (high - low) / 20),
      Home: () => go(low),
      End: () => go(high),
      '+': () => this.zoom(0.7, now),
      '-': () => this.zoom(1 / 0.7, now),
      Backspace: () => this.listener.back(),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }
}

const CLASS_ENTRIES = CLASS_NAMES.map((name, kind) => ({ name, kind }));

/// A cursor over both charts.
class CursorLine {
  readonly upper: HTMLElement;
  readonly lower: HTMLElement;
  value = NaN;

  constructor(side: 'a' | 'b') {
    this.upper = el('div', { class: `cursor cursor-${side}`, hidden: true });
    this.lower = el('div', { class: `cursor cursor-${side}`, hidden: true });
  }

  place(left: number, width: number): void {
    for (const line of [this.upper, this.lower]) {
      line.hidden = !(left >= 0 && left <= width);
      if (!line.hidden) line.style.transform = `translateX(${left}px)`;
    }
  }
}
