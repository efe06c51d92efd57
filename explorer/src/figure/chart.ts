// A chart with two axes: uPlot draws axes, grid and lines; layers add clouds of points, bands and marks. The SVG has
// the same layers and ticks.
import uPlot from 'uplot';
import { el } from '../dom';
import { textSize, theme, watchSize, type Figure, type Picture } from './figure';
import { font, SvgPen, type Pen } from './pen';
import type { Theme } from './theme';
import { linearTicks, niceStep, tickText } from './ticks';

export type Range = readonly [number, number];

/// The plotting area: positions of values in the pen's pixels.
export interface Frame {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  /// Pixels of the pen for each CSS pixel.
  readonly ratio: number;
  readonly xRange: Range;
  readonly yRange: Range;
  x(value: number): number;
  y(value: number): number;
}

export type Layer = (pen: Pen, frame: Frame, colours: Theme) => void;

export interface Line {
  readonly label: string;
  readonly colour: (colours: Theme) => string;
  readonly width?: number;
  readonly dash?: readonly number[];
}

export interface ChartSpec {
  readonly title: string;
  readonly lines?: readonly Line[];
  /// Layers below and above grid and lines.
  readonly under?: Layer;
  readonly over?: Layer;
  /// Layer that is drawn last and not clipped: marks whose middles are in the frame (isInside).
  readonly marks?: Layer;
  /// True to omit labels of the horizontal axis, if a chart below has the same axis.
  readonly bareX?: boolean;
  /// Returns the text of a tick on the horizontal axis (in a full spectrum orders count in both directions).
  readonly xText?: (value: number, step: number) => string;
  /// Ticks of the vertical axis in place of round numbers, if at least two of them are visible.
  readonly yTicks?: readonly number[];
}

/// Returns true if a position is in the frame, to rounding.
export function isInside({ left, top, width, height }: Frame, x: number, y: number): boolean {
  const ROUNDING = 0.01;
  const [right, bottom] = [left + width, top + height].map((end) => end + ROUNDING) as [number, number];
  return x >= left - ROUNDING && x <= right && y >= top - ROUNDING && y <= bottom;
}

/// Draws with clipping at the frame.
export function drawClipped(pen: Pen, { left, top, width, height }: Frame, draw: () => void): void {
  pen.save();
  pen.beginPath();
  pen.rect(left, top, width, height);
  pen.clip();
  draw();
  pen.restore();
}

/// Draws a thin line at 0 from edge to edge.
export function drawZero(pen: Pen, frame: Frame, colour: string): void {
  pen.strokeStyle = colour;
  pen.lineWidth = frame.ratio;
  pen.beginPath();
  pen.moveTo(frame.left, frame.y(0));
  pen.lineTo(frame.left + frame.width, frame.y(0));
  pen.stroke();
}

interface Ticks {
  readonly at: readonly number[];
  readonly text: readonly string[];
}

const NO_TICKS: Ticks = { at: [], text: [] };

/// Least part of the vertical range that can be shown.
const MIN_PART = 1e-4;
const MAX_PART = 0.999;

export class Chart implements Figure {
  readonly root: HTMLElement;
  /// Element over the plotting area for cursors and handlers.
  readonly overlay = el('div', { class: 'overlay' });
  private plot: uPlot | undefined;
  private data: uPlot.AlignedData;
  private xRange: Range = [0, 1];
  /// The whole vertical range, and its visible part.
  private whole: Range = [0, 1];
  private part: Range | undefined;
  private xLabel = '';
  private yLabel = '';
  /// True for logarithmic axes.
  private logarithmic = { x: false, y: false };
  private ticks: { x: Ticks; y: Ticks } = { x: NO_TICKS, y: NO_TICKS };

  constructor(private readonly spec: ChartSpec) {
    this.data = [[0, 1], ...(spec.lines ?? []).map(() => [null, null])];
    this.root = el('div', { class: 'figure chart', role: 'img', 'aria-label': spec.title });
    watchSize(this.root, (width, height) => this.resize(width, height));
  }

  /// Sets labels, and which axes are logarithmic.
  setAxes(xLabel: string, yLabel: string, yLogarithmic = false, xLogarithmic = false): void {
    const { x, y } = this.logarithmic;
    if (xLabel === this.xLabel && yLabel === this.yLabel && xLogarithmic === x && yLogarithmic === y) return;
    [this.xLabel, this.yLabel] = [xLabel, yLabel];
    this.logarithmic = { x: xLogarithmic, y: yLogarithmic };
    this.rebuild();
  }

  /// Shows lines [x, y1, y2, ...] in these ranges; of the vertical range only the chosen part.
  show(xRange: Range, yRange: Range, data?: uPlot.AlignedData): void {
    [this.xRange, this.whole] = [xRange, yRange];
    if (data) this.data = data;
    const plot = this.plot;
    if (!plot) return;
    const [low, high] = this.yRange;
    plot.batch(() => {
      if (data) plot.setData(data, false);
      plot.setScale('x', { min: xRange[0], max: xRange[1] });
      plot.setScale('y', { min: low, max: high });
    });
  }

  private get yRange(): Range {
    return this.part ?? this.whole;
  }

  /// Shows the vertical range between two positions, in CSS pixels from the top of the plotting area, but at most the
  /// whole range.
  enlarge(top: number, bottom: number): void {
    const [low, high] = [this.heightAt(bottom), this.heightAt(top)];
    const sizeOf = (range: Range) => (range[1] - range[0]) / (this.whole[1] - this.whole[0]);
    const size = sizeOf([low, high]);
    if (!(size >= Math.min(MIN_PART, sizeOf(this.yRange)))) return;
    this.part = size < MAX_PART ? [low, high] : undefined;
    this.show(this.xRange, this.whole);
  }

  /// Shows the whole vertical range.
  fit(): void {
    this.part = undefined;
    this.show(this.xRange, this.whole);
  }

  redraw(): void {
    this.plot?.redraw(false, true);
  }

  /// Returns the value at a position of the plotting area, in CSS pixels from its left.
  valueAt(left: number): number {
    return this.plot ? this.plot.posToVal(left, 'x') : NaN;
  }

  heightAt(top: number): number {
    return this.plot ? this.plot.posToVal(top, 'y') : NaN;
  }

  /// Returns the position of a value in the plotting area, in CSS pixels.
  placeOf(value: number): number {
    return this.plot ? this.plot.valToPos(value, 'x') : NaN;
  }

  heightOf(value: number): number {
    return this.plot ? this.plot.valToPos(value, 'y') : NaN;
  }

  /// Returns true if a value is in the visible range.
  isSeen(value: number, axis: 'x' | 'y'): boolean {
    const [low, high] = axis === 'x' ? this.xRange : this.yRange;
    return value >= low && value <= high;
  }

  /// Width and height of the plotting area in CSS pixels.
  get area(): { readonly width: number; readonly height: number } {
    return this.overlay.getBoundingClientRect();
  }

  picture(): Picture {
    const { width, height } = this.root.getBoundingClientRect();
    const size = { width: Math.max(1, Math.floor(width)), height: Math.max(1, Math.floor(height)) };
    const pen = new SvgPen(size.width, size.height, this.spec.title);
    this.sketch(pen, size.width, size.height);
    return { svg: pen.text(), ...size };
  }

  /// Draws the whole chart with a pen in CSS pixels, as for an SVG.
  sketch(pen: Pen, width: number, height: number): void {
    const colours = theme();
    pen.fillStyle = colours.paper;
    pen.beginPath();
    pen.rect(0, 0, width, height);
    pen.fill();
    if (!this.plot) return;
    const frame = this.frame(window.devicePixelRatio || 1);
    const { lines, under, over, marks } = this.spec;
    drawClipped(pen, frame, () => under?.(pen, frame, colours));
    this.sketchAxes(pen, frame, height, colours);
    drawClipped(pen, frame, () => lines?.forEach((line, i) => this.sketchLine(pen, frame, line, i + 1, colours)));
    drawClipped(pen, frame, () => over?.(pen, frame, colours));
    marks?.(pen, frame, colours);
  }

  /// Returns the frame; `divide`: pixels of the canvas for each pixel of the pen.
  private frame(divide: number): Frame {
    const plot = this.plot!;
    const box = plot.bbox;
    const ratio = (window.devicePixelRatio || 1) / divide;
    const place = (value: number, scale: string) => plot.valToPos(value, scale, true) / divide;
    return {
      left: box.left / divide,
      top: box.top / divide,
      width: box.width / divide,
      height: box.height / divide,
      ratio,
      xRange: this.xRange,
      yRange: this.yRange,
      x: (value) => place(value, 'x'),
      y: (value) => place(value, 'y'),
    };
  }

  private sketchLine(pen: Pen, frame: Frame, line: Line, index: number, colours: Theme): void {
    const [xs, ys] = [this.data[0], this.data[index]];
    if (!xs || !ys) return;
    pen.beginPath();
    let down = false;
    for (let i = 0; i < xs.length; i++) {
      const [x, y] = [xs[i], ys[i]];
      const there = x != null && y != null && Number.isFinite(y) && (!this.logarithmic.y || y > 0);
      if (there) (down ? pen.lineTo : pen.moveTo).call(pen, frame.x(x), frame.y(y));
      down = there;
    }
    pen.strokeStyle = line.colour(colours);
    pen.lineWidth = (line.width ?? 1.4) * frame.ratio;
    pen.lineJoin = 'round';
    pen.setLineDash(line.dash ?? []);
    pen.stroke();
    pen.setLineDash([]);
  }

  private sketchAxes(pen: Pen, frame: Frame, height: number, colours: Theme): void {
    const size = textSize();
    const bottom = frame.top + frame.height;
    pen.lineWidth = 1;
    pen.strokeStyle = colours.grid;
    pen.beginPath();
    for (const at of this.ticks.x.at) {
      pen.moveTo(frame.x(at), frame.top);
      pen.lineTo(frame.x(at), bottom);
    }
    for (const at of this.ticks.y.at) {
      pen.moveTo(frame.left, frame.y(at));
      pen.lineTo(frame.left + frame.width, frame.y(at));
    }
    pen.stroke();
    pen.fillStyle = colours.muted;
    pen.font = font(size);
    pen.textBaseline = 'top';
    pen.textAlign = 'center';
    if (!this.spec.bareX)
      this.ticks.x.at.forEach((at, i) => pen.fillText(this.ticks.x.text[i] ?? '', frame.x(at), bottom + 5));
    pen.textBaseline = 'middle';
    pen.textAlign = 'right';
    this.ticks.y.at.forEach((at, i) => pen.fillText(this.ticks.y.text[i] ?? '', frame.left - 6, frame.y(at)));
    pen.fillStyle = colours.ink;
    pen.textAlign = 'center';
    if (!this.spec.bareX) pen.fillText(this.xLabel, frame.left + frame.width / 2, height - size * 0.8);
    pen.save();
    pen.translate(size * 0.8, frame.top + frame.height / 2);
    pen.rotate(-Math.PI / 2);
    pen.fillText(this.yLabel, 0, 0);
    pen.restore();
  }

  private resize(width: number, height: number): void {
    if (this.plot) this.plot.setSize({ width, height });
    else this.rebuild();
  }

  /// Makes a new uPlot after a change of labels or of the kind of an axis.
  private rebuild(): void {
    const { width, height } = this.root.getBoundingClientRect();
    if (width < 40 || height < 40) return;
    this.plot?.destroy();
    this.plot = new uPlot(this.options(Math.floor(width), Math.floor(height)), this.data, this.root);
    this.plot.over.append(this.overlay);
    this.plot.redraw(false, true);
  }

  private options(width: number, height: number): uPlot.Options {
    const size = textSize();
    const hook = (layer: Layer | undefined) => (plot: uPlot) => {
      const frame = this.frame(1);
      if (layer && plot === this.plot) drawClipped(plot.ctx, frame, () => layer(plot.ctx, frame, theme()));
    };
    const { marks } = this.spec;
    const whole = (plot: uPlot) => {
      if (plot === this.plot) marks?.(plot.ctx, this.frame(1), theme());
    };
    return {
      width,
      height,
      legend: { show: false },
      cursor: { show: false },
      padding: [size * 0.6, size * 1.6, this.spec.bareX ? size * 0.5 : 0, 0],
      scales: {
        x: {
          time: false,
          auto: false,
          distr: this.logarithmic.x ? 3 : 1,
          range: () => [this.xRange[0], this.xRange[1]],
        },
        y: { auto: false, distr: this.logarithmic.y ? 3 : 1, range: () => [this.yRange[0], this.yRange[1]] },
      },
      axes: [this.axis(0, size), this.axis(1, size)],
      series: [{}, ...(this.spec.lines ?? []).map((line) => this.series(line))],
      hooks: { drawClear: [hook(this.spec.under)], draw: [hook(this.spec.over), whole] },
    };
  }

  private series(line: Line): uPlot.Series {
    const made: uPlot.Series = {
      label: line.label,
      stroke: () => line.colour(theme()),
      width: line.width ?? 1.4,
      points: { show: false },
      spanGaps: false,
    };
    if (line.dash) made.dash = [...line.dash];
    return made;
  }

  private axis(index: 0 | 1, size: number): uPlot.Axis {
    const horizontal = index === 0;
    const bare = horizontal && this.spec.bareX === true;
    const face = font(Math.round(size)); // uPlot reads whole pixels only
    return {
      stroke: () => theme().muted,
      font: face,
      label: bare ? '' : horizontal ? this.xLabel : this.yLabel,
      labelFont: face,
      labelSize: bare ? 0 : size * 1.5,
      labelGap: 0,
      size: horizontal ? (bare ? 0 : size * 1.9) : size * 4.6,
      gap: 5,
      grid: { stroke: () => theme().grid, width: 1 },
      ticks: { show: false },
      border: { show: true, stroke: () => theme().frame, width: 1 },
      splits: (_plot, _axis, low, high) => this.splits(horizontal, low, high, size),
      values: () => (bare ? [] : [...(horizontal ? this.ticks.x : this.ticks.y).text]),
    };
  }

  private splits(horizontal: boolean, low: number, high: number, size: number): number[] {
    const plot = this.plot;
    const box = this.root.getBoundingClientRect();
    const length = horizontal ? (plot?.bbox.width ?? 0) / (window.devicePixelRatio || 1) || box.width : box.height;
    const wanted = horizontal ? length / (size * 6.5) : length / (size * 3.2);
    const yTicks = this.spec.yTicks?.filter((at) => at >= low && at <= high) ?? [];
    const made =
      !horizontal && yTicks.length > 1
        ? { at: yTicks, text: yTicks.map(String) }
        : this.logarithmic[horizontal ? 'x' : 'y']
          ? decades(low, high, wanted)
          : linear(low, high, wanted, horizontal ? this.spec.xText : undefined);
    if (horizontal) this.ticks.x = made;
    else this.ticks.y = made;
    return [...made.at];
  }
}

function linear(
  low: number,
  high: number,
  wanted: number,
  text: (value: number, step: number) => string = tickText,
): Ticks {
  const at = linearTicks(low, high, wanted);
  const step = niceStep(high - low, wanted);
  return { at, text: at.map((value) => text(value, step)) };
}

const SUPERSCRIPT: Record<string, string> = {
  '-': '\u207b',
  '0': '\u2070',
  '1': '\u00b9',
  '2': '\u00b2',
  '3': '\u00b3',
  '4': '\u2074',
  '5': '\u2075',
  '6': '\u2076',
  '7': '\u2077',
  '8': '\u2078',
  '9': '\u2079',
};

/// Returns ticks at powers of ten; also at 2 and 5 times these if there would be too few.
function within(low: number, high: number): number[] {
  const at: number[] = [];
  for (let power = Math.floor(Math.log10(low)); 10 ** power <= high; power++)
    for (const part of [1, 2, 5]) at.push(Number((part * 10 ** power).toPrecision(3)));
  return at.filter((value) => value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9));
}

function decades(low: number, high: number, wanted: number): Ticks {
  const [first, last] = [Math.ceil(Math.log10(low) - 1e-9), Math.floor(Math.log10(high) + 1e-9)];
  if (last - first < 2 && wanted >= 3) {
    const few = within(low, high);
    // Use linear ticks for a range below a decade.
    return few.length > 1
      ? { at: few, text: few.map((value) => tickText(value, 10 ** Math.floor(Math.log10(value)))) }
      : linear(low, high, wanted);
  }
  const every = Math.max(1, Math.ceil((last - first) / Math.max(1, wanted)));
  const powers: number[] = [];
  for (let power = first; power <= last; power += every) powers.push(power);
  return {
    at: powers.map((power) => 10 ** power),
    text: powers.map((power) =>
      power >= -3 && power <= 4
        ? String(10 ** power)
        : `10${[...String(power)].map((digit) => SUPERSCRIPT[digit]).join('')}`,
    ),
  };
}
