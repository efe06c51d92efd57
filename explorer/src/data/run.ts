// The runs that `whirl report` put into the page (src/report/explorer.c writes them).
import type { StoredContents } from './contents';
import type { Field, StationInfo, Verdict } from '../engine/protocol';

export interface StoredField extends Omit<Field, 'offset'> {
  /// float32, little-endian, base64: [repeat][columns][points][rows].
  readonly data: string;
}

/// What the table of a map has in place of values, whose cells lie row after row, along the parameter of the table, and
/// plane after plane.
export interface StoredMap {
  /// The second parameter, which changes from row to row.
  readonly second: string;
  /// The third one, which changes from plane to plane, and its values, as those below; absent where there is one plane.
  readonly third?: string;
  readonly z?: string;
  readonly columns: number;
  readonly rows: number;
  /// The values along both axes in SI, float64, little-endian, base64; NaN where no point is.
  readonly x: string;
  readonly y: string;
  /// The cell of every point, where that is not its number.
  readonly cells?: readonly number[];
  /// Of a refined map: how many cells along both axes, from its own on, every point stands for.
  readonly widths?: readonly number[];
}

/// A motion that several starts of a basin came to rest on.
export interface Attractor {
  /// Of its verdict: "P-5".
  readonly name: string;
  readonly starts: number;
  /// Of the starts that are done, and its standard error were these drawn at random.
  readonly share: number;
  readonly error: number;
}

export interface StoredTable {
  readonly name: string;
  readonly parameter: string;
  /// Points of the table, and how many of them are in the page.
  readonly points: number;
  readonly count: number;
  /// Of a table in which every attractor of a place stands once: starts of every place, and how many places there are.
  readonly starts?: number;
  readonly places?: number;
  readonly method: string;
  /// Whether `method: auto` took it.
  readonly method_chosen: boolean;
  readonly steps_per_revolution: number;
  readonly transient: number;
  readonly record: number;
  /// float64, little-endian, base64; not of maps, as the next two but one.
  readonly values?: string;
  /// float64 as well: metres per unit of length of every point, where the parameter changes them.
  readonly length_scales?: string;
  readonly map?: StoredMap;
  /// Of a basin; and of every point the number of its own, from 1, or 0 where none is told.
  readonly attractors?: readonly Attractor[];
  readonly attractor?: readonly number[];
  readonly branch?: readonly number[];
  readonly done?: readonly number[];
  /// Name and reason of every point's verdict; not of large maps.
  readonly verdicts?: readonly (readonly [string, string])[];
  /// Of machines at rest, what was located between points: kind, value, speed, frequency, damping ratio, direction.
  readonly critical?: readonly (readonly (number | null)[])[];
  /// Of modes, what the lines along which they were followed are called; and of every mode of every point the number of
  /// its line, float32, little-endian, base64, NaN where it has none.
  readonly mode_names?: readonly string[];
  readonly mode_lines?: string;
  /// rad, of the first probe of a response to unbalance, and the stations that have probes, "" of none or all.
  readonly probe_angle?: number;
  readonly probes_at?: string;
  readonly fields: readonly StoredField[];
  /// Of branches: segments of a revolution, or of an orbit with a time of its own; and of every `orbit_stride`-th point
  /// the period and the states at the beginnings of the segments, float64, little-endian, base64.
  readonly trace_segments?: number;
  readonly orbit_stride?: number;
  readonly orbits?: string;
}

/// The motion that the page opens with, as its run has stored it.
export interface StoredOpening {
  /// "", and null, of a run of one point.
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
  /// Of this one point.
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
  /// That the report was asked for, "um, rpm, Hz, p-p"; they go before the fact "units", which is the case's.
  readonly units: string;
  /// Absent where no point may be shown first.
  readonly opening?: StoredOpening;
  readonly tables: readonly StoredTable[];
}

export function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// The arrays are little-endian, as is every machine that a browser runs on today.
export function float32Of(base64: string): Float32Array {
  return new Float32Array(bytesOf(base64).buffer);
}

export function float64Of(base64: string): Float64Array {
  return new Float64Array(bytesOf(base64).buffer);
}

/// The runs in the page; none in a template that no report has filled.
export function readRuns(text: string): Run[] {
  try {
    const runs: unknown = JSON.parse(text);
    return Array.isArray(runs) ? (runs as Run[]) : [];
  } catch {
    return [];
  }
}
