// Two charts, one over the other, along one parameter: cursors through both, and what hands and keys do on them.
import { el } from '../dom';
import type { Chart, Range } from '../figure/chart';
import { textSize, type Picture } from '../figure/figure';
import { SvgPen, type Pen } from '../figure/pen';
import { parameterMeasure, shown, type Units } from '../model/units';

export type Mode = 'point' | 'range' | 'pan';

/// Along what the charts run.
export interface Along {
  readonly parameter: string;
  /// SI unit of the parameter.
  readonly unit: string;
  readonly units: Units;
  /// In SI.
  readonly range: Range;
}

/// A place in the plotting area of the upper chart, in CSS pixels from its left and top.
export interface Spot {
  readonly left: number;
  readonly top: number;
}

export interface StackListener {
  /// A value was chosen, in SI; `settled` when the pointer let go. `spot`: where on the upper chart the pointer is.
  cursor(value: number, settled: boolean, spot?: Spot): void;
  /// The pointer is over the upper chart and presses nothing, or has left it.
  hover?(spot: Spot | undefined): void;
  /// A key was pressed, with Shift for ten times as far; whether it was meant for the listener.
  key?(key: string, many: number): boolean;
  /// A range was brushed, in SI.
  brushed(range: Range): void;
  /// The view was zoomed or moved, in SI.
  viewed(range: Range): void;
  back(): void;
}

const KEYBOARD_STEPS = 200;

/// Even steps over the range.
export function evenly(value: number, steps: number, [low, high]: Range): number {
  return value + ((high - low) / KEYBOARD_STEPS) * steps;
}

export class Stack {
  readonly root: HTMLElement;
  mode: Mode = 'point';
  private along: Along | undefined;
  private value = NaN;
  private words = '';
  private readonly cursors: readonly [CursorLine, CursorLine];
  private readonly brush = el('div', { class: 'brush', hidden: true });

  constructor(
    private readonly main: Chart,
    private readonly lower: Chart,
    private readonly listener: StackListener,
    /// Where `steps` of the keys lead from a value.
    private readonly walk: (value: number, steps: number, range: Range) => number = evenly,
  ) {
    this.cursors = [new CursorLine('a'), new CursorLine('b')];
    for (const cursor of this.cursors) {
      main.overlay.append(cursor.upper);
      lower.overlay.append(cursor.lower);
    }
    main.overlay.append(this.brush);
    main.root.classList.add('map-main');
    lower.root.classList.add('map-exponent');
    // They hold a slider, which a picture would hide from assistive programs.
    for (const chart of [main, lower]) chart.root.setAttribute('role', 'group');
    this.root = el('div', { class: 'map' }, main.root, lower.root);
    this.listen(main.overlay);
    this.listen(lower.overlay);
    // Cursors stand where their values are, however wide the charts become.
    new ResizeObserver(() => this.placeCursors()).observe(main.overlay);
    main.overlay.tabIndex = 0;
    main.overlay.setAttribute('role', 'slider');
    main.overlay.addEventListener('keydown', (event) => this.key(event));
  }

  show(along: Along): void {
    this.along = along;
  }

  /// In SI.
  get chosenValue(): number {
    return this.value;
  }

  /// In the unit that is shown.
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

  /// The values of settings A and B in SI; NaN hides a cursor.
  /// `words`: what the slider says besides its value.
  setCursors(a: number, b: number, words = ''): void {
    this.value = a;
    this.words = words;
    this.cursors[0].value = a;
    this.cursors[1].value = b;
    this.placeCursors();
  }

  /// Both charts, and below them a legend of so many lines in the height that it is given.
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

  private valueAt(overlay: HTMLElement, clientX: number): number {
    const along = this.along!;
    const box = overlay.getBoundingClientRect();
    const part = Math.min(1, Math.max(0, (clientX - box.left) / box.width));
    return along.range[0] + part * (along.range[1] - along.range[0]);
  }

  private spotOf(overlay: HTMLElement, event: PointerEvent): Spot | undefined {
    if (overlay !== this.main.overlay) return undefined;
    const box = overlay.getBoundingClientRect();
    return { left: event.clientX - box.left, top: event.clientY - box.top };
  }

  private listen(overlay: HTMLElement): void {
    let doing: Mode | undefined;
    let from = NaN;
    let last = NaN;
    let height = NaN;
    const fingers = new Map<number, number>();
    overlay.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || !this.along) return;
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
      height = event.clientY;
      if (doing === 'point') this.listener.cursor(from, false, this.spotOf(overlay, event));
    });
    overlay.addEventListener('pointermove', (event) => {
      if (!this.along) return;
      if (fingers.size === 2 && fingers.has(event.pointerId)) this.pinch(overlay, fingers, event);
      if (!doing) {
        if (event.buttons === 0 && this.mode === 'point') this.listener.hover?.(this.spotOf(overlay, event));
        return;
      }
      const value = this.valueAt(overlay, event.clientX);
      if (doing === 'point' && (value !== last || event.clientY !== height))
        this.listener.cursor(value, false, this.spotOf(overlay, event));
      if (doing === 'range') this.showBrush(from, value);
      if (doing === 'pan') this.pan(from - value);
      last = value;
      height = event.clientY;
    });
    const end = (event: PointerEvent, cancelled: boolean) => {
      fingers.delete(event.pointerId);
      if (!doing || !this.along) return;
      const value = this.valueAt(overlay, event.clientX);
      if (doing === 'point')
        this.listener.cursor(cancelled ? last : value, true, cancelled ? undefined : this.spotOf(overlay, event));
      if (doing === 'range') this.endBrush(from, value, cancelled);
      doing = undefined;
    };
    overlay.addEventListener('pointerup', (event) => end(event, false));
    overlay.addEventListener('pointercancel', (event) => end(event, true));
    overlay.addEventListener('pointerleave', () => this.listener.hover?.(undefined));
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
    const [low, high] = this.along!.range;
    const [about, to] = [middle(before), middle(now)];
    const shift = (about - to) * by;
    this.listener.viewed([about - (about - low) * by + shift, about + (high - about) * by + shift]);
  }

  private wheel(overlay: HTMLElement, event: WheelEvent): void {
    // The page scrolls until the diagram is in use.
    if (!this.along || document.activeElement !== this.main.overlay) return;
    event.preventDefault();
    if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      this.pan(((this.along.range[1] - this.along.range[0]) * event.deltaX) / 800);
      return;
    }
    this.zoom(Math.exp(Math.max(-80, Math.min(80, event.deltaY)) / 300), this.valueAt(overlay, event.clientX));
  }

  private zoom(by: number, about: number): void {
    const [low, high] = this.along!.range;
    this.listener.viewed([about - (about - low) * by, about + (high - about) * by]);
  }

  private pan(by: number): void {
    const [low, high] = this.along!.range;
    this.listener.viewed([low + by, high + by]);
  }

  private showBrush(from: number, to: number): void {
    const factor = parameterMeasure(this.along!.unit, this.along!.units).factor;
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
    const span = this.along!.range[1] - this.along!.range[0];
    if (!cancelled && high - low > span * 0.004) this.listener.brushed([low, high]);
  }

  private key(event: KeyboardEvent): void {
    const { along } = this;
    if (!along || event.ctrlKey || event.metaKey || event.altKey) return;
    const [low, high] = along.range;
    const many = event.shiftKey ? 10 : 1;
    if (this.listener.key?.(event.key, many)) {
      event.preventDefault();
      return;
    }
    const step = (steps: number) => go(this.walk(now, steps * many, along.range));
    const now = Number.isFinite(this.value) ? this.value : (low + high) / 2;
    // Keys may come faster than frames: the next one goes on from here.
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
