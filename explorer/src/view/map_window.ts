// The visible part of a map, which contains the cursor's cell. The user changes it by wheel, keys and brush.
import type { MapAxis } from '../data/parameter_map';
import type { Range } from '../figure/chart';

/// Least number of visible cells along each axis.
const MIN_CELLS = 4;

/// One axis of the window, in SI.
export class MapSpan {
  private range: Range | undefined;

  constructor(private readonly axis: MapAxis) {}

  private get whole(): Range {
    return [this.axis.edges[0]!, this.axis.edges.at(-1)!];
  }

  get shown(): Range {
    return this.range ?? this.whole;
  }

  get zoomed(): boolean {
    return this.range !== undefined;
  }

  reset(): void {
    this.range = undefined;
  }

  /// Zooms by a factor about a value, which keeps its position. At least MIN_CELLS cells, and at most all cells, stay
  /// visible.
  zoom(by: number, about: number): void {
    const [low, high] = this.shown.map(this.to) as [number, number];
    const at = this.to(about);
    this.set(at - (at - low) * by, at + (high - at) * by);
  }

  /// Shows the range from one value to another.
  brush(from: number, to: number): void {
    const [a, b] = [this.to(Math.min(from, to)), this.to(Math.max(from, to))];
    this.set(a, b);
  }

  /// Moves the range so that it contains a cell.
  follow(cell: number): void {
    if (!this.range) return;
    const [low, high] = this.shown.map(this.to) as [number, number];
    const [left, right] = [this.to(this.axis.edges[cell]!), this.to(this.axis.edges[cell + 1]!)];
    const shift = left < low ? left - low : right > high ? right - high : 0;
    if (shift !== 0) this.set(low + shift, high + shift);
  }

  /// Converts a value to a measure in which the axis is linear.
  private readonly to = (value: number): number => (this.axis.logarithmic ? Math.log(value) : value);
  private readonly from = (value: number): number => (this.axis.logarithmic ? Math.exp(value) : value);

  private set(low: number, high: number): void {
    const [first, last] = this.whole.map(this.to) as [number, number];
    const least = ((last - first) * Math.min(MIN_CELLS, this.axis.values.length)) / this.axis.values.length;
    const size = Math.max(high - low, least);
    if (size >= last - first) {
      this.range = undefined;
      return;
    }
    const begin = Math.min(Math.max((low + high - size) / 2, first), last - size);
    this.range = [this.from(begin), this.from(begin + size)];
  }
}

/// The windows of both axes.
export class MapWindow {
  readonly x: MapSpan;
  readonly y: MapSpan;

  constructor(x: MapAxis, y: MapAxis) {
    this.x = new MapSpan(x);
    this.y = new MapSpan(y);
  }

  get zoomed(): boolean {
    return this.x.zoomed || this.y.zoomed;
  }

  reset(): void {
    this.x.reset();
    this.y.reset();
  }

  zoom(by: number, [x, y]: readonly [number, number]): void {
    this.x.zoom(by, x);
    this.y.zoom(by, y);
  }
}
