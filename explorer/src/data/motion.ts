// One motion computed by the engine, with the data that panels use. Lengths are in length scales.
import { fieldNumbers, findField, type MotionResult, type StationInfo } from '../engine/protocol';
import type { OrbitOfBranch } from './orbit';
import { FIELD } from './fields';

export interface Pairs {
  readonly x: Float64Array;
  readonly y: Float64Array;
}

export interface SectionPoints extends Pairs {
  readonly vx: Float64Array;
  readonly vy: Float64Array;
}

/// Amplitudes zero to peak over orders.
export interface Spectrum extends Pairs {
  readonly order: Float64Array;
  readonly forward: Float64Array;
  readonly backward: Float64Array;
}

/// Distance, over the size of a motion, below which an orbit counts as closed: less than a pixel of a picture.
const CLOSED = 1e-3;

export class Motion {
  constructor(
    readonly result: MotionResult,
    /// The orbit of a branch that this motion follows, stable or not.
    readonly orbit: OrbitOfBranch | undefined = undefined,
  ) {}

  get stations(): readonly StationInfo[] {
    return this.result.stations;
  }

  get diverged(): boolean {
    return this.result.verdict?.regime === 'diverged';
  }

  /// Waveform of the last revolutions; its last sample is at the once-per-revolution mark.
  waveform(station: number): Pairs {
    const [x, y] = this.columns(FIELD.WAVEFORM_SAMPLES, station, 2);
    return { x: x!, y: y! };
  }

  get samplesPerRevolution(): number {
    return this.result.samplesPerRevolution;
  }

  section(station: number): SectionPoints {
    const [x, y, vx, vy] = this.columns(FIELD.POINCARE_SECTION, station, 4);
    return { x: x!, y: y!, vx: vx!, vy: vy! };
  }

  spectrum(station: number): Spectrum {
    return this.spectral(FIELD.SPECTRUM_AMPLITUDE, station);
  }

  /// Peaks, largest first.
  lines(station: number): Spectrum {
    return this.spectral(FIELD.SPECTRUM_LINES, station);
  }

  number(field: string, which = 0, column = 0): number {
    return fieldNumbers(this.result.layout, this.result.block, field, which)[column] ?? NaN;
  }

  /// Largest share of the time in contact; NaN without contacts.
  get contact(): number {
    const field = findField(this.result.layout, FIELD.RUB_SHARE);
    if (!field || field.repeat === 0) return NaN;
    let most = 0;
    for (let which = 0; which < field.repeat; which++) most = Math.max(most, this.number(FIELD.RUB_SHARE, which) || 0);
    return most;
  }

  /// Returns true if the strongest line of the spectrum whirls forward; undefined without lines.
  forwardWhirl(station: number): boolean | undefined {
    const { forward, backward } = this.lines(station);
    return forward.length ? forward[0]! >= backward[0]! : undefined;
  }

  /// Revolutions after which a picture of the motion repeats; 0 if it does not. A preview has pictures before it has a
  /// verdict.
  get period(): number {
    const { verdict } = this.result;
    // The period of an autonomous orbit need not be a whole number of revolutions.
    if (this.orbit || !verdict) return (this.orbit?.period ?? 0) / (2 * Math.PI);
    const returns = this.number(FIELD.REGIME_RECURRENCE) < CLOSED ? this.number(FIELD.REGIME_RECURRENCE_PERIOD) : 0;
    return verdict.period || (verdict.provisional ? returns : 0);
  }

  private spectral(field: string, station: number): Spectrum {
    const [order, x, y, forward, backward] = this.columns(field, station, 5);
    return { order: order!, x: x!, y: y!, forward: forward!, backward: backward! };
  }

  /// Returns the columns of a field, up to the first missing row.
  private columns(name: string, which: number, wanted: number): Float64Array[] {
    const columns = findField(this.result.layout, name)?.columns ?? wanted;
    const numbers = fieldNumbers(this.result.layout, this.result.block, name, which);
    let rows = 0;
    while (rows * columns < numbers.length && !Number.isNaN(numbers[rows * columns])) rows++;
    return Array.from({ length: wanted }, (_, column) =>
      Float64Array.from({ length: rows }, (_row, row) => numbers[row * columns + column] ?? NaN),
    );
  }
}
