// Data of the views of a run-up.
import type { StoredBand } from '../data/bands';
import type { MeasuredData } from '../data/measured';
import type { RunUp } from '../data/runup';
import type { StationInfo } from '../engine/protocol';
import type { Frame } from '../figure/chart';
import type { Pen } from '../figure/pen';
import { amplitudeOf, lengthMeasure, type Measure, type Scales, type Units } from '../model/units';

/// Returns the measures of a station's displacements and amplitudes: lengths, or angles of a station that only twists.
export function motionMeasures(
  { twists }: StationInfo,
  units: Units,
  scales: Scales,
): { readonly length: Measure; readonly amplitude: Measure } {
  // Convert twists, which are displacements of a point 1 m from the axis, so that a metre is a radian.
  const length = twists ? { factor: (scales.length * 180) / Math.PI, unit: '\u00b0' } : lengthMeasure(units, scales);
  return { length, amplitude: amplitudeOf(length, units) };
}

export interface RunSubject {
  readonly run: RunUp;
  /// The cursor: time in s, and the row at it; -1 without any row.
  readonly time: number;
  readonly row: number;
  readonly station: number;
  readonly info: StationInfo;
  readonly units: Units;
  readonly scales: Scales;
  readonly measured: readonly MeasuredData[];
  readonly bands: readonly StoredBand[] | undefined;
  /// Name of the machine.
  readonly name: string;
  /// Label for files and titles: "12.4 s".
  readonly label: string;
}

/// Draws a line through rows; it has gaps where a number is missing, and where it falls or rises by more than `jump`.
export function drawRows(
  pen: Pen,
  frame: Frame,
  xs: ArrayLike<number>,
  ys: ArrayLike<number>,
  rows: readonly number[],
  style: { readonly colour: string; readonly dash?: readonly number[]; readonly width?: number },
  jump = Infinity,
): void {
  pen.strokeStyle = style.colour;
  pen.lineWidth = (style.width ?? 1.5) * frame.ratio;
  pen.lineJoin = 'round';
  pen.setLineDash((style.dash ?? []).map((length) => length * frame.ratio));
  pen.beginPath();
  let before = NaN;
  for (const row of rows) {
    const [x, y] = [xs[row]!, ys[row]!];
    const there = Number.isFinite(x) && Number.isFinite(y);
    if (there) (Math.abs(y - before) <= jump ? pen.lineTo : pen.moveTo).call(pen, frame.x(x), frame.y(y));
    before = there ? y : NaN;
  }
  pen.stroke();
  pen.setLineDash([]);
}

export function scaled(values: Float64Array, factor: number): Float64Array {
  return values.map((value) => value * factor);
}

/// Returns the least and the largest of numbers, with a margin; ignores NaN.
export function spanOf(lists: readonly ArrayLike<number>[], fromZero = true): readonly [number, number] {
  let [low, high] = fromZero ? [0, 0] : [Infinity, -Infinity];
  for (const values of lists)
    for (let i = 0; i < values.length; i++) {
      const value = values[i]!;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  if (!(high > low)) return [low - 1, low + 1];
  const room = 0.06 * (high - low);
  return [low < 0 || !fromZero ? low - room : 0, high + room];
}
