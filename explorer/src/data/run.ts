// Runs stored in the page by `whirl report` (src/report/explorer.c writes them).
import type { StoredBand } from './bands';
import type { StoredContents } from './contents';
import type { Field, StationInfo, Verdict } from '../engine/protocol';
import type { ShownUnits } from '../model/units';

export interface StoredField extends Omit<Field, 'offset'> {
  /// float32, little-endian, base64: [repeat][columns][points][rows].
  readonly data: string;
}

/// Axes of a map, in place of a table's values. Cells are stored row by row along the table's parameter, and plane by
/// plane.
export interface StoredMap {
  /// The second parameter, which changes from row to row.
  readonly second: string;
  /// The third parameter, which changes from plane to plane, and its values in the same form; absent for one plane.
  readonly third?: string;
  readonly z?: string;
  readonly columns: number;
  readonly rows: number;
  /// Values along both axes in SI, float64, little-endian, base64; NaN for columns and rows without points.
  readonly x: string;
  readonly y: string;
  /// Cell of every point; absent if it equals the point's number.
  readonly cells?: readonly number[];
  /// For a refined map: each point represents a square of cells, which begins at its own cell; number of cells along a
  /// side of the square.
  readonly widths?: readonly number[];
}

/// An attractor that several starts of a basin reached.
export interface Attractor {
  /// Name of its verdict: "P-5".
  readonly name: string;
  readonly starts: number;
  /// Share of the computed starts, and its standard error for random starts.
  readonly share: number;
  readonly error: number;
}

export interface StoredTable {
  readonly name: string;
  readonly parameter: string;
  /// Number of points of the table, and of those in the page.
  readonly points: number;
  readonly count: number;
  /// For a table with one row for each attractor of a place: number of starts at each place, and number of places.
  readonly starts?: number;
  readonly places?: number;
  readonly method: string;
  /// True if `method: auto` chose the method.
  readonly method_chosen: boolean;
  readonly steps_per_revolution: number;
  readonly transient: number;
  readonly record: number;
  /// Values of the points, float64, little-endian, base64; absent for maps.
  readonly values?: string;
  /// Length scale at every point in m, float64, if the parameter changes it.
  readonly length_scales?: string;
  readonly map?: StoredMap;
  /// Attractors of a basin; and the number of each point's attractor, from 1 (0: unknown).
  readonly attractors?: readonly Attractor[];
  readonly attractor?: readonly number[];
  readonly branch?: readonly number[];
  readonly done?: readonly number[];
  /// Name and reason of every point's verdict; absent for large maps.
  readonly verdicts?: readonly (readonly [string, string])[];
  /// For machines at rest, critical speeds and thresholds located between points: kind, value, speed, frequency,
  /// damping ratio, direction.
  readonly critical?: readonly (readonly (number | null)[])[];
  /// For modes, the names of the lines along which they were followed; and the line of every mode of every point,
  /// float32, little-endian, base64, NaN without a line.
  readonly mode_names?: readonly string[];
  readonly mode_lines?: string;
  /// Angle of the first probe of an unbalance response in rad, and the stations with probes ("": none given).
  readonly probe_angle?: number;
  readonly probes_at?: string;
  readonly fields: readonly StoredField[];
  /// For branches: segments of a revolution (or of an autonomous orbit); and for every `orbit_stride`-th point the
  /// period and the states at the beginnings of the segments, float64, little-endian, base64.
  readonly trace_segments?: number;
  readonly orbit_stride?: number;
  readonly orbits?: string;
}

/// The stored motion with which the page opens.
export interface StoredOpening {
  /// Parameter and value; "" and null for a run of one point.
  readonly parameter: string;
  readonly value: number | null;
  readonly speed: number;
  readonly length_scale: number;
  readonly keyphasor: string;
  readonly method: string;
  readonly method_chosen: boolean;
  readonly steps_per_revolution: number;
  readonly transient: number;
  readonly record: number;
  readonly watch: number;
  readonly waveform_revolutions: number;
  readonly verdict: Omit<Verdict, 'provisional' | 'divergedAt'>;
  /// Fields of this point.
  readonly fields: readonly StoredField[];
}

export interface StoredParameter {
  readonly name: string;
  readonly unit: string;
  readonly text: string;
  readonly value: number | null;
}

export interface Run extends StoredContents {
  readonly name: string;
  readonly title: string;
  readonly case_name: string;
  readonly case_text: string;
  readonly speed: number;
  readonly length_scale: number;
  readonly force_scale: number;
  readonly parameters: readonly StoredParameter[];
  readonly stations: readonly StationInfo[];
  readonly contacts: readonly string[];
  readonly facts: readonly { readonly name: string; readonly value: string }[];
  /// Units that the report or the case chose.
  readonly shown: ShownUnits;
  /// Bands of tolerances; absent without any.
  readonly bands?: readonly StoredBand[];
  /// Absent if no point can be shown first.
  readonly opening?: StoredOpening;
  readonly tables: readonly StoredTable[];
}

export function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// Returns an array of float32. Stored arrays are little-endian, as is every machine with a current browser.
export function float32Of(base64: string): Float32Array {
  return new Float32Array(bytesOf(base64).buffer);
}

export function float64Of(base64: string): Float64Array {
  return new Float64Array(bytesOf(base64).buffer);
}

/// Returns the runs in the page; none in an unfilled template.
export function readRuns(text: string): Run[] {
  try {
    const runs: unknown = JSON.parse(text);
    return Array.isArray(runs) ? (runs as Run[]) : [];
  } catch {
    return [];
  }
}
