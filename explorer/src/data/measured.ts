// Measured numbers of one file, by channels: an orbit over the angle of the shaft or over the time, or vectors (parts
// of the motion at an order) over the speed or a parameter. The core has read them (explorer/core/measured.c).
import { MEASURED, type MeasuredTable } from '../engine/protocol';
import type { Pairs, Spectrum } from './motion';

/// A probe, or an order that it measured.
export interface Channel {
  readonly station: number;
  /// Degrees from the x axis towards y.
  readonly direction: number;
  /// Order of vectors; 0 for samples.
  readonly order: number;
  /// Displacements or amplitudes (0-p) in m.
  readonly values: readonly number[];
  /// Lags of vectors in degrees; absent if they were not measured.
  readonly lags?: readonly number[];
}

/// Vectors as a probe sees them.
export interface Seen {
  /// Speeds in rad/s, or values of the parameter in SI.
  readonly at: readonly number[];
  /// m, 0-p.
  readonly amplitudes: readonly number[];
  /// Degrees.
  readonly lags?: readonly number[];
}

/// A measured motion at a station, for pictures of a motion. Lengths are in length scales.
export interface MeasuredMotion {
  readonly name: string;
  /// Revolutions since a mark.
  readonly turns: Float64Array;
  readonly x?: Float64Array;
  readonly y?: Float64Array;
  /// Absent while it is being computed, and if it cannot be.
  readonly spectrum?: Spectrum;
}

const DEGREE = Math.PI / 180;
/// Directions within this part of a degree are the same.
const SAME = 1e-6;
/// Least sine of the angle between two probes from which both axes are computed.
const APART = 0.01;

const turned = (degrees: number) => ((degrees % 360) + 360) % 360;

export class MeasuredData {
  readonly channels: readonly Channel[];
  readonly kind: 'orbit' | 'waveform' | 'vectors';
  /// Revolutions since a mark, seconds, or for vectors values of the rows: rad/s, or the parameter in SI.
  readonly at: readonly number[];

  constructor(
    readonly name: string,
    private readonly table: MeasuredTable,
  ) {
    const { numbers } = table;
    const quantity = numbers[0]?.[3];
    this.kind = quantity === MEASURED.sample ? 'orbit' : quantity === MEASURED.waveform ? 'waveform' : 'vectors';
    this.channels = this.kind === 'vectors' ? vectorChannels(table) : sampleChannels(table);
    this.at = this.kind === 'vectors' ? table.motions.map((value) => value ?? NaN) : placesOf(table);
  }

  get title(): string {
    return this.table.title;
  }

  /// The parameter that varies from row to row of vectors; "" if the speed varies.
  get parameter(): string {
    return this.table.parameter;
  }

  /// Speed of the motion of samples in rad/s; NaN if the file does not know it.
  get speed(): number {
    return this.kind === 'vectors' ? NaN : (this.table.motions[0] ?? NaN);
  }

  /// Stations with a probe, the first one of the file first.
  get stations(): readonly number[] {
    return [...new Set(this.channels.map(({ station }) => station))];
  }

  /// Returns the instants of samples in revolutions at a speed in rad/s.
  turns(speed: number): Float64Array {
    const each = this.kind === 'waveform' ? speed / (2 * Math.PI) : 1;
    return Float64Array.from(this.at, (at) => at * each);
  }

  /// Returns displacements of a station in m; without the axis that no probe determines.
  displacements(station: number): Partial<Pairs> {
    const mine = this.channels.filter((channel) => channel.station === station && channel.order === 0);
    const axis = (direction: number) => {
      const seen = this.project(mine, direction, ({ values }) => values.map((value) => [value, 0]));
      return seen && Float64Array.from(seen, ([value]) => value);
    };
    const [x, y] = [axis(0), axis(90)];
    return { ...(x && { x }), ...(y && { y }) };
  }

  /// Returns vectors of an order as a probe of a station sees them; undefined if no probe determines them.
  seen(station: number, direction: number, order = 1): Seen | undefined {
    const mine = this.channels.filter((channel) => channel.station === station && channel.order === order);
    const alone = mine.find((channel) => !channel.lags && sameAxis(channel.direction, direction));
    if (alone) return { at: this.at, amplitudes: alone.values };
    const phased = mine.filter(({ lags }) => lags !== undefined);
    const parts = this.project(phased, direction, ({ values, lags }) =>
      values.map((value, i) => [value * Math.cos(lags![i]! * DEGREE), value * Math.sin(lags![i]! * DEGREE)]),
    );
    return (
      parts && {
        at: this.at,
        amplitudes: parts.map(([c, s]) => Math.hypot(c, s)),
        lags: parts.map(([c, s]) => turned(Math.atan2(s, c) / DEGREE)),
      }
    );
  }

  /// Returns the signal of a probe in a direction: that of the channel with the direction, or the combination of two
  /// channels.
  private project(
    channels: readonly Channel[],
    direction: number,
    signal: (channel: Channel) => readonly (readonly [number, number])[],
  ): readonly (readonly [number, number])[] | undefined {
    const combine = (parts: readonly (readonly [Channel, number])[]) => {
      const signals = parts.map(([channel, weight]) => ({ of: signal(channel), weight }));
      return signals[0]!.of.map((_, i): [number, number] => [
        signals.reduce((sum, { of, weight }) => sum + weight * of[i]![0], 0),
        signals.reduce((sum, { of, weight }) => sum + weight * of[i]![1], 0),
      ]);
    };
    const own = channels.find((channel) => sameAxis(channel.direction, direction));
    if (own) return combine([[own, Math.cos((direction - own.direction) * DEGREE) > 0 ? 1 : -1]]);
    const sine = (from: number, to: number) => Math.sin((to - from) * DEGREE);
    for (const [i, first] of channels.entries())
      for (const second of channels.slice(i + 1)) {
        const between = sine(first.direction, second.direction);
        if (Math.abs(between) < APART) continue;
        return combine([
          [first, sine(direction, second.direction) / between],
          [second, sine(first.direction, direction) / between],
        ]);
      }
    return undefined;
  }
}

function sameAxis(a: number, b: number): boolean {
  const between = turned(a - b) % 180;
  return Math.min(between, 180 - between) < SAME;
}

/// Returns the instants of samples: every channel has the same.
function placesOf({ numbers }: MeasuredTable): readonly number[] {
  const [, station, direction] = numbers[0] ?? [];
  return numbers.filter((each) => each[1] === station && each[2] === direction).map((each) => each[4]);
}

interface Growing {
  readonly station: number;
  readonly direction: number;
  readonly order: number;
  readonly values: number[];
  readonly lags?: number[];
}

function channelOf(all: Map<string, Growing>, station: number, direction: number, order: number, lag: boolean) {
  const key = `${station} ${direction} ${order} ${lag}`;
  const known = all.get(key);
  if (known) return known;
  const made = { station, direction: turned(direction / DEGREE), order, values: [], ...(lag && { lags: [] }) };
  all.set(key, made);
  return made;
}

function sampleChannels({ numbers }: MeasuredTable): readonly Channel[] {
  const all = new Map<string, Growing>();
  for (const [, station, direction, , , value] of numbers)
    channelOf(all, station, direction, 0, false).values.push(value);
  return [...all.values()];
}

function vectorChannels({ numbers }: MeasuredTable): readonly Channel[] {
  const all = new Map<string, Growing>();
  numbers.forEach(([, station, direction, quantity, order, value], i) => {
    if (quantity === MEASURED.sin) return; // belongs to the cosine before it
    const lag = quantity === MEASURED.cos;
    const sine = lag ? numbers[i + 1]![5] : 0;
    const channel = channelOf(all, station, direction, order, lag);
    channel.values.push(lag ? Math.hypot(value, sine) : value);
    channel.lags?.push(turned(Math.atan2(sine, value) / DEGREE));
  });
  return [...all.values()];
}

/// Returns the whole revolutions, below `period`, by which a measured motion is moved so that it differs least from a
/// computed one, and the root mean square of their difference there; NaN without a common axis. `wave` ends at a mark
/// and repeats itself after `period` revolutions of `per` samples.
export function alignment(
  { turns, x, y }: MeasuredMotion,
  wave: Pairs,
  per: number,
  period: number,
): { readonly moved: number; readonly rms: number } {
  const size = period * per;
  const first = wave.x.length - size;
  const at = (values: Float64Array, turn: number) => {
    // Sample i is at the angle (i + 1)/per.
    const place = turn * per - 1;
    const [before, part] = [Math.floor(place), place - Math.floor(place)];
    const sample = (i: number) => values[first + (((i % size) + size) % size)]!;
    return (1 - part) * sample(before) + part * sample(before + 1);
  };
  let best = { moved: 0, rms: NaN };
  for (let moved = 0; moved < period; moved++) {
    let [sum, count] = [0, 0];
    for (const [measured, computed] of [[x, wave.x] as const, [y, wave.y] as const])
      measured?.forEach((value, i) => {
        sum += (value - at(computed, turns[i]! + moved)) ** 2;
        count++;
      });
    const rms = Math.sqrt(sum / count);
    if (!(rms >= best.rms)) best = { moved, rms };
  }
  return best;
}
