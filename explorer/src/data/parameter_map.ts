// A stored map: points over two parameters, one cell for each. Cells are numbered along rising values.
import { Diagram } from './diagram';
import { OTHER_PERIODS } from './regimes';
import { float64Of, type Attractor, type Run, type StoredMap, type StoredTable } from './run';
import { FIELD } from './fields';

export interface MapAxis {
  readonly parameter: string;
  /// Rising values in SI.
  readonly values: Float64Array;
  /// [values + 1] edges of cells: half-way between values, by ratio if the values have equal ratios.
  readonly edges: Float64Array;
  readonly logarithmic: boolean;
}

export interface Cell {
  readonly column: number;
  readonly row: number;
}

/// Fills in the values of columns or rows without points, at even steps between known values or beyond them.
function fillGaps(values: Float64Array): void {
  const known = Array.from(values.keys()).filter((i) => Number.isFinite(values[i]));
  if (known.length < 2) {
    const [only = 0] = known;
    const start = known.length ? values[only]! : 0;
    values.forEach((_, i) => (values[i] = start + i - only));
    return;
  }
  values.forEach((value, i) => {
    if (Number.isFinite(value)) return;
    const next = known.findIndex((at) => at > i);
    const after = next < 0 ? known.length - 1 : Math.max(1, next);
    const [from, to] = [known[after - 1]!, known[after]!];
    values[i] = values[from]! + ((values[to]! - values[from]!) * (i - from)) / (to - from);
  });
}

function haveEqualRatios(values: Float64Array): boolean {
  const [first, last] = [values[0]!, values.at(-1)!];
  if (values.length < 3 || !(first > 0 && last > 0)) return false;
  const [ratio, step] = [values[1]! / first, values[1]! - first];
  const alike = values.every((value, i) => i === 0 || Math.abs(value / values[i - 1]! - ratio) < 1e-6 * ratio);
  return alike && Math.abs(last - values.at(-2)! - step) > 1e-3 * Math.abs(step);
}

function edgesOf(values: Float64Array, logarithmic: boolean): Float64Array {
  const count = values.length;
  const edges = new Float64Array(count + 1);
  const [first, last] = [values[0]!, values[count - 1]!];
  for (let i = 1; i < count; i++) {
    const [a, b] = [values[i - 1]!, values[i]!];
    edges[i] = logarithmic ? Math.sqrt(a * b) : (a + b) / 2;
  }
  const own = 0.05 * Math.abs(first) || 0.5;
  const beyond = (value: number, edge: number) => (logarithmic ? (value * value) / edge : 2 * value - edge);
  edges[0] = count > 1 ? beyond(first, edges[1]!) : first - own;
  edges[count] = count > 1 ? beyond(last, edges[count - 1]!) : last + own;
  return edges;
}

/// Returns the axis for values that rise or fall.
function axisOf(parameter: string, values: Float64Array): MapAxis {
  fillGaps(values);
  values.sort();
  const logarithmic = haveEqualRatios(values);
  return { parameter, values, edges: edgesOf(values, logarithmic), logarithmic };
}

/// Returns the cell of an axis nearest to a value.
export function nearestOn({ values, edges }: MapAxis, value: number): number {
  let [low, high] = [0, values.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (value > edges[middle + 1]!) low = middle + 1;
    else high = middle;
  }
  return low;
}

/// Returns a number that is equal for points of one regime and period; NaN without a verdict.
export function regimeKind(diagram: Diagram, point: number): number {
  if (point < 0) return NaN;
  const kind = diagram.classes[point]!;
  return kind <= OTHER_PERIODS ? diagram.number(point, FIELD.REGIME_PERIOD) : -kind;
}

/// A plane of a map with several.
export interface MapPlane {
  /// The third parameter, and its value in the plane.
  readonly parameter: string;
  readonly value: number;
}

export class ParameterMap {
  readonly x: MapAxis;
  readonly y: MapAxis;
  /// By cell, row by row: the point computed in the cell, and the point that represents the cell (another one in
  /// refined maps); -1 without a point.
  private readonly own: Int32Array;
  private readonly points: Int32Array;

  constructor(
    /// All points of all planes, along the first parameter.
    readonly diagram: Diagram,
    map: StoredMap,
    /// Number of the plane in the stored map, from 0, and its parameter value; undefined for a map with one plane.
    index: number,
    readonly plane: MapPlane | undefined,
    /// Attractors of a basin, those with most starts first; else none.
    readonly attractors: readonly Attractor[],
    /// Number of every point's attractor, from 1; 0: unknown.
    private readonly attractor: readonly number[],
  ) {
    const { columns, rows } = map;
    const [x, y] = [float64Of(map.x), float64Of(map.y)];
    const falls = (values: Float64Array) => {
      const known = values.filter(Number.isFinite);
      return known.length > 1 && known[0]! > known.at(-1)!;
    };
    const [back, down] = [falls(x), falls(y)];
    const at = (column: number, row: number) =>
      (down ? rows - 1 - row : row) * columns + (back ? columns - 1 - column : column);
    this.own = new Int32Array(columns * rows).fill(-1);
    this.points = new Int32Array(columns * rows).fill(-1);
    // A point of a refined map represents a square of cells (StoredMap.widths). The last column and row of the map
    // belong to the squares that end there.
    const end = (first: number, width: number, count: number) => (first + width + 1 < count ? first + width : count);
    for (let point = 0; point < diagram.count; point++) {
      const cell = (map.cells?.[point] ?? point) - index * columns * rows;
      if (cell < 0 || cell >= columns * rows) continue;
      const [column, row] = [cell % columns, Math.floor(cell / columns)];
      this.own[at(column, row)] = point;
      const width = map.widths?.[point] ?? 1;
      if (width === 1) continue;
      for (let y = row; y < end(row, width, rows); y++)
        for (let x = column; x < end(column, width, columns); x++) this.points[at(x, y)] = point;
    }
    this.own.forEach((point, cell) => {
      if (point >= 0) this.points[cell] = point;
    });
    this.x = axisOf(diagram.parameter, x);
    this.y = axisOf(map.second, y);
  }

  /// Returns the number of a point's attractor; 0: unknown.
  attractorOf(point: number): number {
    return this.attractor[point] ?? 0;
  }

  /// Returns the region id of a point, used to draw borders: equal for points of one attractor or, without attractors,
  /// of one regime and period.
  kindOf(point: number): number {
    if (point < 0) return NaN;
    if (this.attractors.length > 0) return this.attractorOf(point);
    return regimeKind(this.diagram, point);
  }

  get columns(): number {
    return this.x.values.length;
  }

  get rows(): number {
    return this.y.values.length;
  }

  /// Returns the axis of a parameter; undefined if the map has no such axis.
  axis(parameter: string): MapAxis | undefined {
    return [this.x, this.y].find((axis) => axis.parameter === parameter);
  }

  /// Returns the axis that is not that of a parameter.
  across(parameter: string): MapAxis {
    return parameter === this.y.parameter ? this.x : this.y;
  }

  /// Returns true if a point was computed in the cell itself.
  isComputed({ column, row }: Cell): boolean {
    return this.own[row * this.columns + column]! >= 0;
  }

  /// The points that were computed.
  get computed(): readonly number[] {
    return Array.from(this.own).filter((point) => point >= 0 && this.diagram.done[point]);
  }

  /// Returns the point that represents a cell, which in refined maps may have been computed in another cell; -1 without
  /// a finished one.
  point({ column, row }: Cell): number {
    return this.pointAt(row * this.columns + column);
  }

  /// Does the same by the cell's number, counted row by row.
  pointAt(cell: number): number {
    const point = this.points[cell] ?? -1;
    return point >= 0 && this.diagram.done[point] ? point : -1;
  }

  nearest(x: number, y: number): Cell {
    return { column: nearestOn(this.x, x), row: nearestOn(this.y, y) };
  }

  /// Returns a row along the first parameter, or a column along the second, as a diagram.
  cut(along: string, index: number): Diagram {
    const [columns, rows] = [this.columns, this.rows];
    const isRow = along !== this.y.parameter;
    const cells = isRow
      ? Array.from({ length: columns }, (_, column) => ({ column, row: index }))
      : Array.from({ length: rows }, (_, row) => ({ column: index, row }));
    const axis = isRow ? this.x : this.y;
    const there = cells.map((cell, i) => ({
      point: this.isComputed(cell) ? this.point(cell) : -1,
      value: axis.values[i]!,
    }));
    const known = there.filter(({ point }) => point >= 0);
    return this.diagram.part(
      known.map(({ point }) => point),
      along,
      Float64Array.from(known, ({ value }) => value),
    );
  }
}

/// The planes of a map over three parameters, or the only one of a map over two.
export class MapPlanes {
  private readonly made = new Map<number, ParameterMap>();

  private constructor(
    private readonly diagram: Diagram,
    private readonly table: StoredTable,
    private readonly map: StoredMap,
    /// The third parameter ("" without one), and its rising values.
    readonly parameter: string,
    readonly values: Float64Array,
    /// Index of each value's plane among the stored planes.
    private readonly places: readonly number[],
  ) {}

  /// Returns the map of a run; undefined without one.
  static of(run: Run | undefined): MapPlanes | undefined {
    const table: StoredTable | undefined = run?.tables.find(({ map, count }) => map !== undefined && count > 0);
    if (!table?.map) return undefined;
    const { map } = table;
    const stored = map.z === undefined ? Float64Array.of(NaN) : float64Of(map.z);
    if (map.z !== undefined) fillGaps(stored);
    const places = Array.from(stored.keys()).sort((one, other) => stored[one]! - stored[other]!);
    const values = Float64Array.from(places, (place) => stored[place]!);
    return new MapPlanes(Diagram.stored(table, run!.length_scale), table, map, map.third ?? '', values, places);
  }

  get count(): number {
    return this.values.length;
  }

  /// Returns the plane with the nearest value.
  nearest(value: number): number {
    let best = 0;
    this.values.forEach((each, i) => {
      if (Math.abs(each - value) < Math.abs(this.values[best]! - value)) best = i;
    });
    return best;
  }

  at(index: number): ParameterMap {
    const { table, parameter, values } = this;
    const plane = parameter ? { parameter, value: values[index]! } : undefined;
    const known =
      this.made.get(index) ??
      new ParameterMap(
        this.diagram,
        this.map,
        this.places[index]!,
        plane,
        table.attractors ?? [],
        table.attractor ?? [],
      );
    this.made.set(index, known);
    return known;
  }
}
