// A diagram: points along one parameter with their results, from a stored run or from the engine.
import type { Field, Layout, SweepPoints, Verdict } from '../engine/protocol';
import { regimeClass, regimeName, UNDETERMINED } from './regimes';
import { float32Of, float64Of, type StoredMap, type StoredTable } from './run';
import { FIELD } from './fields';

/// Numbers of every point: [points][rows].
export interface Column {
  readonly rows: number;
  readonly data: Float32Array;
}

/// Description of a field.
export type FieldInfo = Omit<Field, 'offset'>;

const SECTION = FIELD.POINCARE_SECTION;

function columnKey(field: string, which: number, column: number): string {
  return `${field} ${which} ${column}`;
}

const NO_VERDICT = ['', ''] as const;

/// Returns the values of a map's points along its rows.
function valuesOfCells({ columns, x, cells }: StoredMap, count: number): Float64Array {
  const values = float64Of(x);
  return Float64Array.from({ length: count }, (_, point) => values[(cells?.[point] ?? point) % columns]!);
}

export class Diagram {
  readonly classes: Uint8Array;
  readonly done: Uint8Array;
  /// 1 for points with a preview only: a longer run decides the verdict.
  readonly provisional: Uint8Array;
  /// m per length scale of the machine at each point; NaN for points that are not computed.
  readonly lengthScales: Float64Array;
  /// Name and reason of the verdicts; empty texts if unknown.
  readonly verdicts: (readonly [string, string])[];
  /// Fields by their names.
  readonly fields = new Map<string, FieldInfo>();
  private readonly columns = new Map<string, Column>();
  private layout: Layout | undefined;

  private constructor(
    readonly parameter: string,
    /// [count] values in SI, also of points that are not computed.
    readonly values: Float64Array,
    /// [count] +1: carried from the first value on, -1: from the last, 0: not carried; with several attractors the
    /// number of the attractor.
    readonly branch: Int8Array,
  ) {
    this.classes = new Uint8Array(values.length).fill(UNDETERMINED);
    this.done = new Uint8Array(values.length);
    this.provisional = new Uint8Array(values.length);
    this.lengthScales = new Float64Array(values.length).fill(NaN);
    this.verdicts = new Array<typeof NO_VERDICT>(values.length).fill(NO_VERDICT);
  }

  get count(): number {
    return this.values.length;
  }

  /// Number of computed points.
  get known(): number {
    let sum = 0;
    for (const done of this.done) sum += done;
    return sum;
  }

  /// Makes the diagram of a stored table. Its lengths are in units of `lengthScale` [m], unless points have their own.
  static stored(table: StoredTable, lengthScale: number): Diagram {
    const values = table.map ? valuesOfCells(table.map, table.count) : float64Of(table.values ?? '');
    const made = new Diagram(table.parameter, values, Int8Array.from(table.branch ?? { length: table.count }));
    if (table.done) made.done.set(table.done);
    else made.done.fill(1);
    if (table.length_scales) made.lengthScales.set(float64Of(table.length_scales));
    else made.lengthScales.fill(lengthScale);
    for (const stored of table.fields) {
      // Give the section of orbits along branches the name of the section of motions.
      const field = stored.name === FIELD.TRACE_SECTION ? { ...stored, name: SECTION } : stored;
      made.fields.set(field.name, field);
      const all = float32Of(field.data);
      const size = table.count * field.rows;
      for (let which = 0, at = 0; which < field.repeat; which++)
        for (let column = 0; column < field.columns; column++, at += size)
          made.columns.set(columnKey(field.name, which, column), {
            rows: field.rows,
            data: all.subarray(at, at + size),
          });
    }
    table.verdicts?.forEach((verdict, point) => (made.verdicts[point] = verdict));
    for (let point = 0; point < made.count; point++) made.classify(point);
    if (!table.verdicts && table.map) made.nameVerdicts();
    return made;
  }

  /// Makes a diagram whose points are not computed yet.
  static awaited(parameter: string, values: Float64Array, branch: Int8Array): Diagram {
    return new Diagram(parameter, values, branch);
  }

  /// Returns a diagram of the points selected by `keep`, followed by points that are not computed yet.
  joined(keep: (point: number) => boolean, values: Float64Array, branch: Int8Array): Diagram {
    const old = Array.from(this.values.keys()).filter(keep);
    const all = <T extends Float64Array | Int8Array>(made: T, kept: T, added: T) => (
      old.forEach((point, i) => (made[i] = kept[point]!)),
      made.set(added, old.length),
      made
    );
    const count = old.length + values.length;
    const made = new Diagram(
      this.parameter,
      all(new Float64Array(count), this.values, values),
      all(new Int8Array(count), this.branch, branch),
    );
    made.adopt(this, old);
    return made;
  }

  /// Returns a diagram of some of the points, along another parameter.
  part(points: readonly number[], parameter: string, values: Float64Array): Diagram {
    const made = new Diagram(parameter, values, new Int8Array(values.length));
    made.adopt(this, points);
    return made;
  }

  /// Copies some points of another diagram to the first points of this one.
  private adopt(from: Diagram, points: readonly number[]): void {
    points.forEach((point, i) => {
      for (const key of ['classes', 'done', 'provisional', 'lengthScales'] as const) this[key][i] = from[key][point]!;
      this.verdicts[i] = from.verdicts[point]!;
    });
    for (const [name, field] of from.fields) this.fields.set(name, field);
    for (const [key, { rows, data }] of from.columns) {
      const wide = new Float32Array(this.count * rows).fill(NaN);
      points.forEach((point, i) => wide.set(data.subarray(point * rows, (point + 1) * rows), i * rows));
      this.columns.set(key, { rows, data: wide });
    }
  }

  /// Makes room for the engine's points; existing numbers stay.
  expect(layout: Layout): void {
    this.layout = layout;
    for (const field of layout.fields) {
      this.fields.set(field.name, field);
      const columns = field.rows === 1 ? field.columns : field.name === SECTION ? 2 : 0;
      for (let which = 0; which < field.repeat; which++)
        for (let column = 0; column < columns; column++) this.widen(columnKey(field.name, which, column), field.rows);
    }
  }

  /// Widens a column to at least `rows` rows.
  private widen(key: string, rows: number): void {
    const before = this.columns.get(key);
    if (before && before.rows >= rows) return;
    const data = new Float32Array(this.count * rows).fill(NaN);
    if (before)
      for (let point = 0; point < this.count; point++)
        data.set(before.data.subarray(point * before.rows, (point + 1) * before.rows), point * rows);
    this.columns.set(key, { rows, data });
  }

  /// Stores points of a sweep; `place` gives the point of the diagram for a slot.
  take(points: SweepPoints, place: (slot: number) => number): void {
    const layout = this.layout;
    if (!layout) return;
    points.slots.forEach((slot, i) => {
      const point = place(slot);
      const base = i * layout.size;
      for (const field of layout.fields)
        for (let which = 0; which < field.repeat; which++)
          for (let column = 0; column < field.columns; column++) {
            const to = this.columns.get(columnKey(field.name, which, column));
            if (!to) break;
            const from = base + field.offset + which * field.rows * field.columns + column;
            for (let row = 0; row < to.rows; row++)
              to.data[point * to.rows + row] =
                row < field.rows ? (points.blocks[from + row * field.columns] ?? NaN) : NaN;
          }
      const verdict: Verdict | undefined = points.verdicts[i];
      if (verdict) this.verdicts[point] = [verdict.name, verdict.reason];
      this.provisional[point] = verdict?.provisional ? 1 : 0;
      this.lengthScales[point] = points.lengthScales[i] ?? NaN;
      this.done[point] = 1;
      this.classify(point);
    });
  }

  /// Returns a column of a field for a station or contact; undefined if the run lacks it.
  column(field: string, which = 0, column = 0): Column | undefined {
    return this.columns.get(columnKey(field, which, column));
  }

  /// Returns one number of a point; NaN if there is none.
  number(point: number, field: string, which = 0, column = 0): number {
    const found = this.column(field, which, column);
    return found && found.rows === 1 ? (found.data[point] ?? NaN) : NaN;
  }

  /// Returns the largest share of the time in contact, over all contacts.
  contact(point: number): number {
    return this.largest(point, FIELD.RUB_SHARE, 0) || 0;
  }

  /// Returns the largest value of a number over all stations or contacts; NaN if none is known.
  largest(point: number, field: string, column: number): number {
    let most = NaN;
    for (let which = 0; ; which++) {
      const found = this.column(field, which, column);
      if (!found) return most;
      const own = found.data[point] ?? NaN;
      if (!(own <= most) && !Number.isNaN(own)) most = own;
    }
  }

  exponent(point: number): { readonly value: number; readonly error: number } {
    const from = this.column(FIELD.LYAPUNOV_LARGEST)
      ? [FIELD.LYAPUNOV_LARGEST, FIELD.LYAPUNOV_ERROR]
      : [FIELD.REGIME_EXPONENT, FIELD.REGIME_EXPONENT_ERROR];
    return { value: this.number(point, from[0]!), error: this.number(point, from[1]!) };
  }

  /// m per length scale if it is the same at all computed points, else NaN.
  get lengthScale(): number {
    let common = NaN;
    for (let point = 0; point < this.count; point++) {
      const scale = this.lengthScales[point]!;
      if (!this.done[point]) continue;
      if (Number.isNaN(common)) common = scale;
      else if (scale !== common) return NaN;
    }
    return common;
  }

  /// True if points have verdicts; points of branches have none. An awaited diagram will have them.
  get judged(): boolean {
    return !this.columns.has(columnKey(FIELD.TRACE_SPECIAL, 0, 0));
  }

  /// Returns the confidence: 0 low, 1 fair, 2 high; NaN if the run gives none.
  confidence(point: number): number {
    return this.number(point, FIELD.REGIME_CONFIDENCE);
  }

  /// Smallest and largest value, in SI.
  get span(): readonly [number, number] {
    let low = Infinity;
    let high = -Infinity;
    for (const value of this.values) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    return low <= high ? [low, high] : [0, 1];
  }

  /// Returns the computed point whose value is nearest; -1 without any.
  nearest(value: number): number {
    let best = -1;
    let distance = Infinity;
    for (let point = 0; point < this.count; point++) {
      const away = Math.abs((this.values[point] ?? NaN) - value);
      if (this.done[point] && away < distance) {
        best = point;
        distance = away;
      }
    }
    return best;
  }

  /// Names verdicts by regime and period; equal verdicts share a text.
  private nameVerdicts(): void {
    const names = new Map<number, readonly [string, string]>();
    for (let point = 0; point < this.count; point++) {
      const [code, period] = [this.number(point, FIELD.REGIME_CODE), this.number(point, FIELD.REGIME_PERIOD)];
      const key = 8 * period + code;
      if (!names.has(key)) names.set(key, [regimeName(code, period), '']);
      this.verdicts[point] = names.get(key)!;
    }
  }

  private classify(point: number): void {
    this.classes[point] = this.done[point]
      ? regimeClass(this.number(point, FIELD.REGIME_CODE), this.number(point, FIELD.REGIME_PERIOD))
      : UNDETERMINED;
  }
}
