// Two charts, one above the other, along one parameter: cursors through both, and the handling of pointer and keys.
import { el } from '../dom';
import type { Chart, Range } from '../figure/chart';
import { textSize, type Picture } from '../figure/figure';
import { SvgPen, type Pen } from '../figure/pen';
import { parameterMeasure, shown, type Units } from '../model/units';

export type Mode = 'point' | 'range' | 'pan';

/// The common axis of the charts.
export interface Along {
  /// Name of the machine.
  readonly name: string;
  readonly parameter: string;
  /// SI unit of the parameter.
  readonly unit: string;
  readonly units: Units;
  /// Range in SI.
  readonly range: Range;
}

/// A place in the plotting area of the upper chart, in CSS pixels from its left and top.
export interface Spot {
  readonly left: number;
  readonly top: number;
}

/// A spot with its value in SI.
interface Place extends Spot {
  readonly value: number;
}

export interface StackListener {
  /// Called after a value (SI) was chosen; `settled` after the pointer was released. `spot`: position of the pointer on
  /// the upper chart.
  cursor(value: number, settled: boolean, spot?: Spot): void;
  /// Called while the pointer hovers over the upper chart; undefined after it has left.
  hover?(spot: Spot | undefined): void;
  /// Called after a key press, `many` is 10 with Shift; returns true if the listener handled the key.
  key?(key: string, many: number): boolean;
  /// Called after a range (SI) was brushed.
  brushed(range: Range): void;
  /// Called after the view was zoomed or moved (SI).
  viewed(range: Range): void;
  /// Called after a change of a chart's vertical range.
  enlarged?(): void;
  back(): void;
}

const KEYBOARD_STEPS = 200;
/// Factor of zooming by keys.
const ZOOM = 0.7;
/// CSS pixels of vertical movement from which a drag selects a vertical range too.
const UPRIGHT = 24;
/// Distance of two fingers below which zooming does not change further.
const APART = 20;

/// Returns the horizontal and vertical range of a drag; undefined: all.
function enclosed(from: Spot, to: Spot): { readonly across: Range | undefined; readonly up: Range | undefined } {
  const sorted = (a: number, b: number): Range => [Math.min(a, b), Math.max(a, b)];
  const upright = Math.abs(to.top - from.top) >= UPRIGHT;
  const across = !upright || Math.abs(to.left - from.left) >= UPRIGHT;
  return {
    across: across ? sorted(from.left, to.left) : undefined,
    up: upright ? sorted(from.top, to.top) : undefined,
  };
}

/// Returns the mapping of positions by two fingers, which keeps the points under the fingers.
function pinched(before: readonly [number, number], now: readonly [number, number]): (at: number) => number {
  const apart = ([a, b]: readonly [number, number]) => Math.max(APART, Math.abs(a - b));
  const by = apart(before) / apart(now);
  return (at) => (before[0] + before[1]) / 2 + (at - (now[0] + now[1]) / 2) * by;
}

/// Returns the zoom factor of a turn of the wheel.
function turned(delta: number): number {
  return Math.exp(Math.max(-80, Math.min(80, delta)) / 300);
}

/// Moves a value by even steps over the range.
export function evenly(value: number, steps: number, [low, high]: Range): number {
  return value + ((high - low) / KEYBOARD_STEPS) * steps;
}

export class Stack {
  readonly root: HTMLElement;
  private dragging: Mode = 'point';
  private along: Along | undefined;
  /// Key of the quantities to which the present vertical range belongs.
  private heightsOf = '';
  private value = NaN;
  private words = '';
  private readonly cursors: readonly [CursorLine, CursorLine];
  private readonly brush = el('div', { class: 'brush', hidden: true });

  constructor(
    private readonly main: Chart,
    private readonly lower: Chart,
    private readonly listener: StackListener,
    /// Returns the value that is `steps` key presses from a value.
    private readonly walk: (value: number, steps: number, range: Range) => number = evenly,
  ) {
    this.cursors = [new CursorLine('a'), new CursorLine('b')];
    for (const cursor of this.cursors) {
      main.overlay.append(cursor.upper);
      lower.overlay.append(cursor.lower);
    }
    main.root.classList.add('map-main');
    lower.root.classList.add('map-exponent');
    // Make groups of the charts, which contain a slider: the role of a picture would hide it from assistive programs.
    for (const chart of [main, lower]) chart.root.setAttribute('role', 'group');
    this.root = el('div', { class: 'map' }, main.root, lower.root);
    for (const chart of [main, lower]) {
      this.listen(chart);
      chart.root.addEventListener('wheel', (event) => this.wheel(chart, event), { passive: false });
      chart.root.addEventListener('dblclick', () => this.fit(chart));
    }
    // Cursors follow changes of the charts' width.
    new ResizeObserver(() => this.placeCursors()).observe(main.overlay);
    main.overlay.tabIndex = 0;
    main.overlay.setAttribute('role', 'slider');
    main.overlay.addEventListener('keydown', (event) => this.key(event));
  }

  /// Sets the effect of dragging.
  set mode(mode: Mode) {
    this.dragging = this.root.dataset['mode'] = mode;
  }

  /// Shows the charts; `what` identifies the vertical quantities: after a change the whole vertical range is shown
  /// again.
  show(along: Along, ...what: readonly (string | number | boolean)[]): void {
    const of = JSON.stringify([along.name, along.parameter, along.units, what]);
    if (of !== this.heightsOf) this.fit();
    this.heightsOf = of;
    this.along = along;
  }

  /// Shows the whole vertical range of some charts, or of both.
  fit(...charts: readonly Chart[]): void {
    for (const chart of charts.length > 0 ? charts : [this.main, this.lower]) chart.fit();
    this.listener.enlarged?.();
  }

  back(): void {
    this.fit();
    this.listener.back();
  }

  /// The chosen value in SI.
  get chosenValue(): number {
    return this.value;
  }

  /// The range in shown units.
  get range(): Range {
    const { range, unit, units } = this.along!;
    const { factor } = parameterMeasure(unit, units);
    return [range[0] * factor, range[1] * factor];
  }

  redraw(): void {
    this.main.redraw();
    this.lower.redraw();
    this.placeCursors();
  }

  /// Sets the values of settings A and B in SI; NaN hides a cursor. `words`: text of the slider in addition to its
  /// value.
  setCursors(a: number, b: number, words = ''): void {
    this.value = a;
    this.words = words;
    this.cursors[0].value = a;
    this.cursors[1].value = b;
    this.placeCursors();
  }

  /// Returns the picture of both charts with a legend below.
  picture(
    title: string,
    legend: (pen: Pen, width: number, top: number, height: number) => void,
    lines: (width: number) => number = () => 1,
  ): Picture {
    const boxes = [this.main, this.lower].map((chart) => chart.root.getBoundingClientRect());
    const [width, upper, lower] = [
      Math.floor(boxes[0]!.width),
      Math.floor(boxes[0]!.height),
      Math.floor(boxes[1]!.height),
    ];
    const below = Math.ceil(textSize() * 2) * lines(width);
    const pen = new SvgPen(width, upper + lower + below, title);
    this.main.sketch(pen, width, upper);
    pen.save();
    pen.translate(0, upper);
    this.lower.sketch(pen, width, lower);
    pen.restore();
    legend(pen, width, upper + lower, below);
    return { svg: pen.text(), width, height: upper + lower + below };
  }

  // ---------------------------------------------------------------- cursors, zoom, keys

  private placeCursors(): void {
    const { along } = this;
    if (!along) return;
    const measure = parameterMeasure(along.unit, along.units);
    for (const cursor of this.cursors) {
      const inside = cursor.value >= along.range[0] && cursor.value <= along.range[1];
      cursor.place(inside ? this.main.placeOf(cursor.value * measure.factor) : NaN, this.main.area.width);
    }
    const slider = this.main.overlay;
    slider.setAttribute('aria-label', `Value of ${along.parameter}`);
    slider.setAttribute('aria-valuemin', String(along.range[0] * measure.factor));
    slider.setAttribute('aria-valuemax', String(along.range[1] * measure.factor));
    slider.setAttribute('aria-valuenow', String(this.value * measure.factor));
    slider.setAttribute(
      'aria-valuetext',
      [`${along.parameter} ${shown(this.value * measure.factor, 6)} ${measure.unit}`, this.words]
        .filter(Boolean)
        .join(', '),
    );
  }

  private placeAt(chart: Chart, event: MouseEvent): Place {
    const box = chart.overlay.getBoundingClientRect();
    const within = (at: number, size: number) => Math.min(size, Math.max(0, at));
    const left = within(event.clientX - box.left, box.width);
    const [low, high] = this.along!.range;
    return {
      ...{ left, top: within(event.clientY - box.top, box.height) },
      value: low + (left / box.width) * (high - low),
    };
  }

  private spotOf(chart: Chart, place: Place): Spot | undefined {
    return chart === this.main ? place : undefined;
  }

  private listen(chart: Chart): void {
    const { overlay } = chart;
    let doing: Mode | undefined;
    let from: Place;
    let last: Place;
    const fingers = new Map<number, Spot>();
    overlay.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || !this.along) return;
      overlay.setPointerCapture(event.pointerId);
      this.main.overlay.focus({ preventScroll: true });
      event.preventDefault();
      from = last = this.placeAt(chart, event);
      fingers.set(event.pointerId, from);
      if (fingers.size > 1) {
        doing = undefined;
        this.brush.hidden = true;
        return;
      }
      doing = event.shiftKey ? 'range' : this.dragging;
      if (doing === 'point') this.listener.cursor(from.value, false, this.spotOf(chart, from));
    });
    overlay.addEventListener('pointermove', (event) => {
      if (!this.along) return;
      const place = this.placeAt(chart, event);
      if (fingers.size === 2 && fingers.has(event.pointerId)) this.pinch(chart, fingers, event.pointerId, place);
      if (!doing) {
        if (event.buttons === 0 && this.dragging === 'point') this.listener.hover?.(this.spotOf(chart, place));
        return;
      }
      if (doing === 'point' && (place.left !== last.left || place.top !== last.top))
        this.listener.cursor(place.value, false, this.spotOf(chart, place));
      if (doing === 'range') this.showBrush(chart, from, place);
      if (doing === 'pan') {
        this.pan(from.value - place.value);
        this.enlarge(chart, (top) => top + last.top - place.top);
      }
      last = place;
    });
    const end = (event: PointerEvent, cancelled: boolean) => {
      fingers.delete(event.pointerId);
      if (!doing || !this.along) return;
      const place = cancelled ? last : this.placeAt(chart, event);
      if (doing === 'point') this.listener.cursor(place.value, true, cancelled ? undefined : this.spotOf(chart, place));
      if (doing === 'range') this.endBrush(chart, from, place, cancelled);
      doing = undefined;
    };
    overlay.addEventListener('pointerup', (event) => end(event, false));
    overlay.addEventListener('pointercancel', (event) => end(event, true));
    overlay.addEventListener('pointerleave', () => this.listener.hover?.(undefined));
  }

  /// Zooms by two fingers along the line between them, on both axes if it is oblique.
  private pinch(chart: Chart, fingers: Map<number, Spot>, id: number, place: Spot): void {
    const [a, b] = [...fingers.values()] as [Spot, Spot];
    fingers.set(id, place);
    const [c, d] = [...fingers.values()] as [Spot, Spot];
    const [wide, high] = [Math.abs(a.left - b.left), Math.abs(a.top - b.top)];
    if (2 * wide >= high) {
      const to = pinched([a.left, b.left], [c.left, d.left]);
      const [low, span] = [this.along!.range[0], this.along!.range[1] - this.along!.range[0]];
      const { width } = chart.area;
      this.listener.viewed([low + (to(0) / width) * span, low + (to(width) / width) * span]);
    }
    if (2 * high >= wide) this.enlarge(chart, pinched([a.top, b.top], [c.top, d.top]));
  }

  private wheel(chart: Chart, event: WheelEvent): void {
    // The wheel scrolls the page unless the diagram has the focus.
    if (!this.along || document.activeElement !== this.main.overlay) return;
    const onAxis = event.clientX < chart.overlay.getBoundingClientRect().left;
    if (!onAxis && !chart.overlay.contains(event.target as Node)) return;
    event.preventDefault();
    const { top, value } = this.placeAt(chart, event);
    if (event.shiftKey || onAxis) {
      const by = turned(event.deltaY || event.deltaX); // with Shift browsers report deltaX
      this.enlarge(chart, (edge) => top + (edge - top) * by);
    } else if (Math.abs(event.deltaX) > Math.abs(event.deltaY))
      this.pan(((this.along.range[1] - this.along.range[0]) * event.deltaX) / 800);
    else this.zoom(turned(event.deltaY), value);
  }

  /// Changes the vertical range by new positions of the plotting area's top and bottom.
  private enlarge(chart: Chart, to: (top: number) => number): void {
    chart.enlarge(to(0), to(chart.area.height));
    this.listener.enlarged?.();
  }

  private zoom(by: number, about: number): void {
    const [low, high] = this.along!.range;
    this.listener.viewed([about - (about - low) * by, about + (high - about) * by]);
  }

  private pan(by: number): void {
    const [low, high] = this.along!.range;
    this.listener.viewed([low + by, high + by]);
  }

  private showBrush(chart: Chart, from: Place, to: Place): void {
    const { width, height } = chart.area;
    const { across = [0, width], up = [0, height] } = enclosed(from, to);
    chart.overlay.append(this.brush);
    this.brush.hidden = false;
    this.brush.style.left = `${across[0]}px`;
    this.brush.style.width = `${across[1] - across[0]}px`;
    this.brush.style.top = `${up[0]}px`;
    this.brush.style.height = `${up[1] - up[0]}px`;
  }

  private endBrush(chart: Chart, from: Place, to: Place, cancelled: boolean): void {
    this.brush.hidden = true;
    if (cancelled) return;
    const { across, up } = enclosed(from, to);
    const { height } = chart.area;
    if (up) this.enlarge(chart, (top) => up[0] + (top / height) * (up[1] - up[0]));
    const [low, high] = [Math.min(from.value, to.value), Math.max(from.value, to.value)];
    const span = this.along!.range[1] - this.along!.range[0];
    if (across && high - low > span * 0.004) this.listener.brushed([low, high]);
  }

  private key(event: KeyboardEvent): void {
    const { along, main } = this;
    if (!along || event.ctrlKey || event.metaKey) return;
    const [low, high] = along.range;
    const { height } = main.area;
    const many = event.shiftKey ? 10 : 1;
    if (!event.altKey && this.listener.key?.(event.key, many)) {
      event.preventDefault();
      return;
    }
    const step = (steps: number) => go(this.walk(now, steps * many, along.range));
    const now = Number.isFinite(this.value) ? this.value : (low + high) / 2;
    // Move the cursor at once: keys may come faster than frames, and the next key starts from the new value.
    const go = (value: number) => {
      this.value = Math.min(high, Math.max(low, value));
      this.listener.cursor(this.value, true);
    };
    const actions: Record<string, () => void> = {
      ArrowLeft: () => step(-1),
      ArrowRight: () => step(1),
      ArrowDown: () => step(-1),
      ArrowUp: () => step(1),
      PageDown: () => go(now - (high - low) / 20),
      PageUp: () => go(now + (high - low) / 20),
      Home: () => go(low),
      End: () => go(high),
      '+': () => this.zoom(ZOOM, now),
      '-': () => this.zoom(1 / ZOOM, now),
      v: () => this.enlarge(main, (top) => height / 2 + (top - height / 2) * ZOOM),
      V: () => this.enlarge(main, (top) => height / 2 + (top - height / 2) / ZOOM),
      'Alt+ArrowUp': () => this.enlarge(main, (top) => top - height / 10),
      'Alt+ArrowDown': () => this.enlarge(main, (top) => top + height / 10),
      Backspace: () => this.back(),
    };
    const action = actions[event.altKey ? `Alt+${event.key}` : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }
}

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
