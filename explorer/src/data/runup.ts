// A run-up over the time: rows, orbits and spectra of one run, stored or computed in the page.
import { findField, type RunResult, type StationInfo } from '../engine/protocol';
import { Diagram } from './diagram';
import { FIELD } from './fields';
import type { Run } from './run';

/// Orders of the speed whose amplitudes a run has.
export const RUN_ORDERS = 4;
const RADIAN = Math.PI / 180;
const NOTHING = new Float64Array(0);

export interface RunOrbit {
  /// Time (s) and speed (rad/s) of its turn; NaN before the first turn.
  readonly time: number;
  readonly speed: number;
  /// One turn from the mark on, without a last point that closes it, in length scales.
  readonly x: Float64Array;
  readonly y: Float64Array;
  /// True if these are samples; false: the sum of the mean and of orders 1 to 4.
  readonly sampled: boolean;
}

/// Samples at equal angles of a turn from the mark on, besides the motion.
export interface RunTurn {
  /// Time of its middle (s) and speed (rad/s).
  readonly time: number;
  readonly speed: number;
  /// Time of every instant since the beginning of the turn, s.
  readonly instants: Float64Array;
  /// Normal force (N) and gap (length scales; below 0: pressed in) of every contact.
  readonly forces: readonly Float64Array[];
  readonly gaps: readonly Float64Array[];
  /// Torques on a shaft that a drive turns, then those of motors, couplings and shafts that twist, N m.
  readonly torques: readonly { readonly name: string; readonly values: Float64Array }[];
  /// Torques on each shaft of a machine with several, N m; those that are missing or 0 throughout are left out.
  readonly shafts: readonly ShaftTurn[];
}

/// Torques on a shaft of a machine with several within a turn.
export interface ShaftTurn {
  /// "shaft of pinion to load"
  readonly name: string;
  readonly torques: readonly { readonly name: string; readonly values: Float64Array }[];
}

/// Torques on the shaft, by the columns of the fields runup/torque and runup/orbit_torque.
export const SHAFT_TORQUES = ['motor', 'load', 'friction', 'unbalance and weight', 'films and seals'] as const;

/// Torques on a shaft of a machine with several, by the columns of the field runup/orbit_shaft_torque.
const PARTS_OF_SHAFT = [...SHAFT_TORQUES, 'gears', 'inertia times acceleration'] as const;

/// A torque of a motor, or between two stations: its least and largest value in every row, N m. These rows are equal
/// parts of the run, with or without the end of a turn.
export interface RunTorque {
  /// "motor to fan", "induction motor at motor"
  readonly name: string;
  readonly least: Float64Array;
  readonly largest: Float64Array;
}

/// Kinds of torques in the field runup/torque_of; two stations join the first one, and those from MESH on.
const TORQUE_KINDS = [
  '',
  'induction motor',
  'synchronous start',
  'short circuit',
  'torque over time',
  'mesh',
  'rigid gear',
  'spring with play',
];
const MESH = 5;

/// A spectrum over the orders of the speed, in length scales.
export interface RunSpectrum {
  readonly time: number;
  readonly speed: number;
  readonly order: Float64Array;
  readonly forward: Float64Array;
  readonly backward: Float64Array;
}

/// Returns a column of a field: all of its rows for a station or contact.
type Read = (field: string, which: number, column: number) => Float64Array;

export class RunUp {
  private readonly known = new Map<string, Float64Array>();
  /// Time of every row, s; NaN for rows without a turn.
  readonly time: Float64Array;
  /// Speed of every row, rad/s.
  readonly speed: Float64Array;
  /// Rows with a turn, in the order of the time.
  readonly rows: readonly number[];

  private constructor(
    private readonly read: Read,
    /// Planned length of the run, s.
    readonly duration: number,
    readonly lengthScale: number,
    readonly stations: readonly StationInfo[],
    readonly contacts: readonly string[],
    /// True if `duration` is the time at which the run ended.
    private readonly ended: boolean,
  ) {
    this.time = this.column(FIELD.RUNUP_TIME);
    this.speed = this.column(FIELD.RUNUP_SPEED);
    this.rows = Array.from(this.time.keys()).filter((row) => Number.isFinite(this.time[row]));
  }

  /// Returns true if a stored run is a run-up. Records of a data set are none.
  static isIn(run: Run | undefined): boolean {
    const has = (field: string) => run?.tables[0]?.fields.some(({ name }) => name === field) ?? false;
    return has(FIELD.RUNUP_END) && !has(FIELD.DATASET_RECORD);
  }

  /// Returns the stored run of a point.
  static stored(run: Run, diagram: Diagram, point: number): RunUp {
    const read: Read = (field, which, column) => {
      const found = diagram.column(field, which, column);
      return found ? Float64Array.from(found.data.subarray(point * found.rows, (point + 1) * found.rows)) : NOTHING;
    };
    const end = diagram.number(point, FIELD.RUNUP_END_TIME);
    return new RunUp(read, end, diagram.lengthScales[point] ?? run.length_scale, run.stations, run.contacts, true);
  }

  /// Returns a run of the engine, which may not be complete.
  static computed({ layout, block, duration, lengthScale, stations }: RunResult, contacts: readonly string[]): RunUp {
    const read: Read = (name, which, column) => {
      const field = findField(layout, name);
      if (!field || which >= field.repeat || column >= field.columns) return NOTHING;
      const first = field.offset + which * field.rows * field.columns + column;
      return Float64Array.from({ length: field.rows }, (_, row) => block[first + row * field.columns]!);
    };
    // Take the time reached as the length of a run whose length is unknown before it ends.
    const reached = read(FIELD.RUNUP_TIME, 0, 0).reduce((most, time) => (time > most ? time : most), 0);
    return new RunUp(read, duration > 0 ? duration : reached, lengthScale, stations, contacts, false);
  }

  /// Returns all rows of a column of a field; empty if the run has none.
  column(field: string, which = 0, column = 0): Float64Array {
    const key = `${field} ${which} ${column}`;
    const found = this.known.get(key) ?? this.read(field, which, column);
    this.known.set(key, found);
    return found;
  }

  /// Torques of motors, and of shafts, couplings and gears between stations that twist; none in other machines.
  get torques(): readonly RunTorque[] {
    const [kinds, first, second] = [0, 1, 2].map((column) => this.column(FIELD.RUNUP_TORQUE_OF, 0, column)) as [
      Float64Array,
      Float64Array,
      Float64Array,
    ];
    const rows = this.time.length;
    const part = (column: number, i: number) =>
      this.column(FIELD.RUNUP_TORQUE_COURSE, 0, column).subarray(i * rows, (i + 1) * rows);
    return Array.from(kinds, (kind, i) => ({
      name: this.torqueName(kind, [first[i]!, second[i]!]),
      least: part(0, i),
      largest: part(1, i),
    }));
  }

  /// Middle of every row of the torques, s. A stored run that ended early has rows without torques at its end, which
  /// give its planned length to half a row.
  get torqueTimes(): Float64Array {
    const rows = this.time.length;
    const values = this.column(FIELD.RUNUP_TORQUE_COURSE, 0, 1).subarray(0, rows);
    const last = values.reduce((found, value, row) => (Number.isFinite(value) ? row : found), 0);
    const planned = this.ended && last < rows - 1 ? (this.duration * rows) / (last + 0.5) : this.duration;
    return Float64Array.from({ length: rows }, (_, row) => ((row + 0.5) / rows) * planned);
  }

  private torqueName(kind: number, ends: readonly [number, number]): string {
    const [first, second] = ends.map((end) => this.stations[end]?.name);
    const words = TORQUE_KINDS[kind] ?? '';
    if (kind === 0) return `${first ?? 'between stations'} to ${second ?? 'between stations'}`;
    if (kind >= MESH) return `${words}, ${first ?? 'ground'} to ${second ?? 'ground'}`;
    return first === undefined ? words : `${words} at ${first}`;
  }

  number(field: string, which = 0, column = 0): number {
    return this.column(field, which, column)[0] ?? NaN;
  }

  /// Time of the last turn so far, s.
  get reached(): number {
    const row = this.rows.at(-1);
    return row === undefined ? 0 : this.time[row]!;
  }

  /// Instants of events that happened, s.
  get events(): readonly number[] {
    return [...this.column(FIELD.RUNUP_HAPPENED)].filter((time) => Number.isFinite(time));
  }

  /// Returns the row at a time; -1 without any.
  rowAt(time: number): number {
    return nearestOf(this.rows, (row) => Math.abs(this.time[row]! - time));
  }

  /// Returns the row at which the run passes a speed; if it does so several times, the row nearest to `time`.
  rowAtSpeed(speed: number, time: number): number {
    const { rows } = this;
    const away = (i: number) => (i in rows ? Math.abs(this.speed[rows[i]!]! - speed) : Infinity);
    const passages = rows.flatMap((row, i) => (away(i) <= away(i - 1) && away(i) <= away(i + 1) ? [row] : []));
    const distance = (row: number) => Math.abs(this.speed[row]! - speed);
    const best = Math.min(...passages.map(distance));
    const step = Math.max(0, ...rows.slice(1).map((row, i) => Math.abs(this.speed[row]! - this.speed[rows[i]!]!)));
    return nearestOf(
      passages.filter((row) => distance(row) <= best + step),
      (row) => Math.abs(this.time[row]! - time),
    );
  }

  /// Returns the number of the kept turn at a time; -1 if none is near.
  private orbitNear(time: number): number {
    const times = this.column(FIELD.RUNUP_ORBIT_TIME);
    const found = nearestOf(
      Array.from(times.keys()).filter((orbit) => Number.isFinite(times[orbit])),
      (orbit) => Math.abs(times[orbit]! - time),
    );
    const row = this.rowAt(time);
    // Use samples only of this time: those of another time are worse than the sum of a few orders.
    const apart = row < 0 ? 0 : Math.abs((times[found] ?? NaN) - this.time[row]!);
    return apart <= this.duration / Math.max(this.time.length, 1) ? found : -1;
  }

  /// Returns the orbit at a time: samples of the turn if the run has them, else a sum of orders.
  orbitAt(station: number, time: number): RunOrbit | undefined {
    const found = this.orbitNear(time);
    if (found >= 0) return this.sampledOrbit(station, found, this.column(FIELD.RUNUP_ORBIT_TIME)[found]!);
    const row = this.rowAt(time);
    return row < 0 ? undefined : this.summedOrbit(station, row);
  }

  /// Returns forces, gaps and torques within the turn at a time; undefined if the run kept no turn there.
  turnAt(time: number): RunTurn | undefined {
    const found = this.orbitNear(time);
    const times = this.column(FIELD.RUNUP_ORBIT_TIME);
    const all = this.column(FIELD.RUNUP_ORBIT_INSTANT);
    if (found < 0 || all.length === 0) return undefined;
    const samples = all.length / times.length;
    const part = (values: Float64Array, first = 0) =>
      values.subarray(first + found * samples, first + (found + 1) * samples);
    const ofContacts = (field: string) => this.contacts.map((_, i) => part(this.column(field, i)));
    const onShaft = SHAFT_TORQUES.map((name, i) => ({
      name,
      values: part(this.column(FIELD.RUNUP_ORBIT_TORQUE, 0, i)),
    }));
    const courses = this.column(FIELD.RUNUP_ORBIT_TORQUE_COURSE);
    const between = this.torques.map(({ name }, i) => ({ name, values: part(courses, i * all.length) }));
    return {
      time: times[found]!,
      speed: this.column(FIELD.RUNUP_ORBIT_SPEED)[found]!,
      instants: part(all),
      forces: ofContacts(FIELD.RUNUP_ORBIT_FORCE),
      gaps: ofContacts(FIELD.RUNUP_ORBIT_GAP),
      torques: [...onShaft, ...between].filter(({ values }) => Number.isFinite(values[0])),
      shafts: this.shaftNames.map((name, shaft) => ({
        name,
        torques: PARTS_OF_SHAFT.map((of, i) => ({
          name: of,
          values: part(this.column(FIELD.RUNUP_ORBIT_SHAFT_TORQUE, 0, i), shaft * all.length),
        })).filter(({ values }) => Number.isFinite(values[0]) && values.some((value) => value !== 0)),
      })),
    };
  }

  /// Names of the shafts whose torques within a turn are told apart, by their first and last stations; none in a
  /// machine with one shaft.
  get shaftNames(): readonly string[] {
    const instants = this.column(FIELD.RUNUP_ORBIT_INSTANT).length;
    const count = instants > 0 ? this.column(FIELD.RUNUP_ORBIT_SHAFT_SPEED).length / instants : 0;
    return Array.from({ length: count }, (_, shaft) => {
      const on = this.stations.filter((_, s) => this.column(FIELD.RUNUP_ORBIT_SHAFT, s)[0] === shaft);
      const first = on[0]?.name ?? `${shaft + 1}`;
      const last = on[on.length - 1]?.name ?? first;
      return first === last ? `shaft of ${first}` : `shaft of ${first} to ${last}`;
    });
  }

  /// True if torques turn the shaft; false at a given speed or rate.
  get driven(): boolean {
    return this.column(FIELD.RUNUP_TORQUE).some((motor) => Number.isFinite(motor));
  }

  private sampledOrbit(station: number, orbit: number, time: number): RunOrbit {
    const [x, y] = [0, 1].map((axis) => this.column(FIELD.RUNUP_ORBIT, station, axis)) as [Float64Array, Float64Array];
    const samples = x.length / this.column(FIELD.RUNUP_ORBIT_TIME).length;
    const part = (values: Float64Array) => values.subarray(orbit * samples, (orbit + 1) * samples);
    const speed = this.column(FIELD.RUNUP_ORBIT_SPEED)[orbit]!;
    return { time, speed, x: part(x), y: part(y), sampled: true };
  }

  private summedOrbit(station: number, row: number): RunOrbit {
    const SAMPLES = 128;
    const axis = (which: number) => {
      const mean = this.column(FIELD.RUNUP_CENTRE, station, which)[row] ?? NaN;
      const parts = Array.from({ length: RUN_ORDERS }, (_, k) => [
        this.column(FIELD.RUNUP_AMPLITUDE, station, 2 * k + which)[row] ?? NaN,
        (this.column(FIELD.RUNUP_LAG, station, 2 * k + which)[row] || 0) * RADIAN,
      ]);
      return Float64Array.from({ length: SAMPLES }, (_, i) =>
        parts.reduce(
          (sum, [size, lag], k) => sum + size! * Math.cos(((k + 1) * 2 * Math.PI * i) / SAMPLES - lag!),
          mean,
        ),
      );
    };
    return { time: this.time[row]!, speed: this.speed[row]!, x: axis(0), y: axis(1), sampled: false };
  }

  /// Time of every spectrum, s; NaN if there is none.
  get spectrumTimes(): Float64Array {
    return this.column(FIELD.RUNUP_SPECTRUM_TIME);
  }

  /// Returns the number of the spectrum nearest to a time; -1 without any.
  spectrumNear(time: number): number {
    const times = this.spectrumTimes;
    return nearestOf(
      Array.from(times.keys()).filter((i) => Number.isFinite(times[i])),
      (i) => Math.abs(times[i]! - time),
    );
  }

  spectrum(station: number, index: number): RunSpectrum {
    const order = this.column(FIELD.RUNUP_SPECTRUM_ORDER);
    const part = (way: number) =>
      this.column(FIELD.RUNUP_SPECTRUM, station, way).subarray(index * order.length, (index + 1) * order.length);
    return {
      time: this.spectrumTimes[index] ?? NaN,
      speed: this.column(FIELD.RUNUP_SPECTRUM_SPEED)[index] ?? NaN,
      order,
      forward: part(0),
      backward: part(1),
    };
  }

  /// Largest amplitude of all spectra of a station.
  largestInSpectra(station: number): number {
    let most = 0;
    for (const way of [0, 1])
      for (const value of this.column(FIELD.RUNUP_SPECTRUM, station, way)) if (value > most) most = value;
    return most;
  }
}

/// Returns the item with the least distance; -1 without any.
function nearestOf(items: readonly number[], distance: (item: number) => number): number {
  let [best, least] = [-1, Infinity];
  for (const item of items) {
    const away = distance(item);
    if (away < least) [best, least] = [item, away];
  }
  return best;
}
