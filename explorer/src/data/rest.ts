// Stored results of machines at rest: modes of small motions, or the response to unbalance, over a parameter. This file
// computes only other forms of the stored numbers: ellipses, and their signals at a probe.
import type { StationInfo } from '../engine/protocol';
import { Diagram } from './diagram';
import type { StoredLines } from './contents';
import { float32Of, float64Of, type Run } from './run';
import { FIELD } from './fields';

/// A harmonic motion of a station: x = xc cos t + xs sin t, y = yc cos t + ys sin t.
export interface Sway {
  readonly xc: number;
  readonly xs: number;
  readonly yc: number;
  readonly ys: number;
}

export interface Mode {
  /// rad/s, damped.
  readonly frequency: number;
  /// 1/s, real part of the eigenvalue.
  readonly growth: number;
  readonly ratio: number;
  readonly decrement: number;
  /// 1: circular forward whirl, -1: circular backward whirl.
  readonly direction: number;
  /// Number of the line along which the mode was followed (NaN without one), and its name, "2F" or "".
  readonly line: number;
  readonly name: string;
}

/// A critical speed or threshold located between two points.
export interface Critical {
  readonly kind: 'critical' | 'onset' | 'recovery';
  readonly value: number;
  /// Speed of the shaft and frequency of the mode, rad/s.
  readonly speed: number;
  readonly frequency: number;
  readonly ratio: number;
  readonly direction: number;
}

export type Whirl = 'forward' | 'backward' | 'planar';

/// Returns the whirl by the limits that reports use.
export function whirlOf(direction: number): Whirl {
  return direction > 0.05 ? 'forward' : direction < -0.05 ? 'backward' : 'planar';
}

export const WHIRL_TEXT: Readonly<Record<Whirl, string>> = {
  forward: 'forward',
  backward: 'backward',
  planar: 'to and fro',
};

export const CRITICAL_TEXT: Readonly<Record<Critical['kind'], string>> = {
  critical: 'critical speed',
  onset: 'instability begins',
  recovery: 'instability ends',
};

const KINDS = [undefined, 'critical', 'onset', 'recovery'] as const;
/// Damping over the frequency below which it is a rounding error.
export const ROUNDING = 1e-10;
/// Damping ratio above which a mode is overdamped and on no curve (WHIRL_OVERDAMPED_RATIO).
export const OVERDAMPED = 0.9;
type Six = [number, number, number, number, number, number];
const RADIAN = Math.PI / 180;

/// Returns the largest number, at least `least`; ignores NaN.
export function largestOf(values: Iterable<number>, least = 0): number {
  let most = least;
  for (const value of values) if (value > most) most = value;
  return most;
}

export function swayAt({ xc, xs, yc, ys }: Sway, angle: number): readonly [number, number] {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [xc * c + xs * s, yc * c + ys * s];
}

/// Returns the sense of an ellipse: 1 a circle from x to y, -1 the opposite sense, 0 a line.
export function senseOf({ xc, xs, yc, ys }: Sway): number {
  const size = xc * xc + xs * xs + yc * yc + ys * ys;
  return size > 0 ? (2 * (xc * ys - xs * yc)) / size : 0;
}

/// Returns the largest distance of an ellipse from its middle.
export function reachOf({ xc, xs, yc, ys }: Sway): number {
  return (Math.hypot(xc + ys, yc - xs) + Math.hypot(xc - ys, yc + xs)) / 2;
}

/// Returns the signal of a probe at `angle` degrees from the x axis: its amplitude, and the lag of its peak behind the
/// mark in degrees.
export function seenBy({ xc, xs, yc, ys }: Sway, angle: number): { readonly amplitude: number; readonly lag: number } {
  const [c, s] = [Math.cos(angle * RADIAN), Math.sin(angle * RADIAN)];
  const [real, late] = [xc * c + yc * s, xs * c + ys * s];
  const amplitude = Math.hypot(real, late);
  return { amplitude, lag: amplitude > 0 ? (((Math.atan2(late, real) / RADIAN) % 360) + 360) % 360 : NaN };
}

/// The shafts of a machine in a harmonic motion: places along them.
export interface ShaftLine {
  /// Number of each place's shaft, from 1, and its position along it, m.
  readonly shaft: readonly number[];
  readonly position: Float64Array;
  readonly sways: readonly Sway[];
}

/// Lines along which modes were followed: their names, and the line of each mode, [points][modes].
interface Lines {
  readonly names: readonly string[];
  readonly of: Float32Array;
}

export class AtRest {
  /// Points by rising value.
  readonly order: readonly number[];
  private found: readonly (readonly Place[])[] | undefined;
  private moved: Float32Array | undefined;

  private constructor(
    readonly kind: 'modes' | 'unbalance',
    readonly diagram: Diagram,
    readonly stations: readonly StationInfo[],
    readonly critical: readonly Critical[],
    /// Angle of the case's first probe, degrees from the x axis.
    readonly probe: number,
    private readonly lines: Lines | undefined,
    private readonly contacts: readonly string[],
    private readonly bent: StoredLines | undefined,
  ) {
    this.order = Array.from(diagram.values.keys())
      .filter((point) => diagram.done[point])
      .sort((a, b) => diagram.values[a]! - diagram.values[b]!);
  }

  /// Returns the kind of stored results; undefined for motions.
  static kindOf(run: Run | undefined): AtRest['kind'] | undefined {
    const has = (field: string) => run?.tables[0]?.fields.some(({ name }) => name === field);
    if (has(FIELD.MODES_FREQUENCY)) return 'modes';
    return has(FIELD.UNBALANCE_AMPLITUDE) ? 'unbalance' : undefined;
  }

  static of(run: Run | undefined): AtRest | undefined {
    const table = run?.tables[0];
    const kind = AtRest.kindOf(run);
    if (!run || !table || !kind) return undefined;
    const critical = (table.critical ?? []).flatMap((row): Critical[] => {
      const [number, value, speed, frequency, ratio, direction] = [0, 1, 2, 3, 4, 5].map((i) => row[i] ?? NaN) as Six;
      const name = KINDS[number];
      return name ? [{ kind: name, value, speed, frequency, ratio, direction }] : [];
    });
    const diagram = Diagram.stored(table, run.length_scale);
    const { mode_names: names, mode_lines: of } = table;
    const lines = names && of ? { names, of: float32Of(of) } : undefined;
    const probe = (table.probe_angle ?? 0) / RADIAN;
    // Skip the lines of a thinned table, whose points have other numbers.
    const bent = table.count === table.points ? run.lines?.find((each) => each.table === table.name) : undefined;
    return new AtRest(kind, diagram, run.stations, critical, probe, lines, run.contacts, bent);
  }

  /// Returns the point `steps` after the one at a value.
  neighbour(value: number, steps: number): number {
    const at = this.order.indexOf(this.diagram.nearest(value)) + steps;
    return this.order[Math.min(this.order.length - 1, Math.max(0, at))] ?? -1;
  }

  /// Speed of the shaft, rad/s.
  speed(point: number): number {
    return this.diagram.number(point, `${this.kind}/speed`);
  }

  /// Returns the contacts that are closed at rest.
  closedContacts(point: number): readonly string[] {
    return this.contacts.filter((_, contact) => this.diagram.number(point, FIELD.RANGES_HELD, contact) > 0);
  }

  /// Returns the shafts between stations in a mode (0 for a response); undefined if they are not known.
  shafts(point: number, mode = 0): ShaftLine | undefined {
    const { bent } = this;
    if (!bent || point < 0 || mode >= bent.modes) return undefined;
    this.moved ??= float32Of(bent.moved);
    const { shaft, modes } = bent;
    const first = 4 * shaft.length * (point * modes + mode);
    const number = (place: number, part: number) => this.moved![first + 4 * place + part]!;
    if (!Number.isFinite(number(0, 0))) return undefined;
    const sways = shaft.map((_, i) => ({ xc: number(i, 0), xs: number(i, 1), yc: number(i, 2), ys: number(i, 3) }));
    return { shaft, position: float64Of(bent.position), sways };
  }

  // ---------------------------------------------------------------- modes

  /// Returns the largest real part of all eigenvalues, 1/s.
  stability(point: number): number {
    return this.diagram.number(point, FIELD.MODES_STABILITY);
  }

  /// Returns 1 if a mode grows, -1 if all decay, 0 if the largest growth is a rounding error.
  growing(point: number): number {
    return Math.sign(this.stability(point));
  }

  /// Returns the frequency in rad/s modulo which frequencies are known; NaN if they are known exactly.
  modulo(point: number): number {
    return this.diagram.number(point, FIELD.MODES_MODULO);
  }

  /// Returns the modes of a point by rising frequency.
  modes(point: number): Mode[] {
    const all = (field: string) => {
      const { rows = 0, data } = this.diagram.column(`modes/${field}`) ?? {};
      return data?.subarray(point * rows, (point + 1) * rows) ?? new Float32Array(0);
    };
    const [growth, ratio, decrement, direction] = [
      all('growth'),
      all('damping_ratio'),
      all('decrement'),
      all('direction'),
    ];
    const frequencies = all('frequency');
    return Array.from(frequencies, (frequency, i) => {
      const line = this.lines?.of[point * frequencies.length + i] ?? NaN;
      return {
        frequency,
        growth: growth[i]!,
        ratio: ratio[i]!,
        decrement: decrement[i]!,
        direction: direction[i]!,
        line,
        name: this.lines?.names[line] ?? '',
      };
    }).filter(({ frequency }) => Number.isFinite(frequency));
  }

  /// Returns the shape of a mode at all stations, with 1 as the largest displacement.
  shape(point: number, mode: number): Sway[] {
    return this.stations.map((_, station) => {
      const number = (column: number) => {
        const found = this.diagram.column(FIELD.MODES_SHAPE, station, column);
        return found?.data[point * found.rows + mode] ?? NaN;
      };
      return { xc: number(0), xs: number(1), yc: number(2), ys: number(3) };
    });
  }

  /// Curves of modes followed from point to point; a mode that was not followed is a curve of its own.
  get curves(): readonly (readonly Place[])[] {
    return (this.found ??= this.findCurves());
  }

  private findCurves(): readonly (readonly Place[])[] {
    const curves = new Map<number | Place, Place[]>();
    for (const point of this.order)
      this.modes(point).forEach((mode, index) => {
        if (mode.ratio > OVERDAMPED) return;
        const place = { point, index, mode };
        const key = Number.isNaN(mode.line) ? place : mode.line;
        const curve = curves.get(key);
        if (curve) curve.push(place);
        else curves.set(key, [place]);
      });
    return [...curves.values()];
  }

  // ---------------------------------------------------------------- unbalance

  /// Returns the response of a station in length scales of the point's machine.
  response(point: number, station: number): Sway {
    const number = (field: string, column: number) => this.diagram.number(point, `unbalance/${field}`, station, column);
    const part = (column: number) => {
      const amplitude = number('amplitude', column);
      const lag = (number('lag', column) || 0) * RADIAN;
      return [amplitude * Math.cos(lag), amplitude * Math.sin(lag)] as const;
    };
    const [[xc, xs], [yc, ys]] = [part(0), part(1)];
    return { xc, xs, yc, ys };
  }

  rest(point: number, station: number): readonly [number, number] {
    const number = (column: number) => this.diagram.number(point, `${this.kind}/rest`, station, column);
    return [number(0), number(1)];
  }
}

/// A mode of a point.
export interface Place {
  readonly point: number;
  readonly index: number;
  readonly mode: Mode;
}
