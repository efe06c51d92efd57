// One motion as the engine found it, by what the panels ask for. Lengths in length scales, as the engine gives them.
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

/// Over the size of a motion: less is no pixel of a picture.
const CLOSED = 1e-3;

export class Motion {
  constructor(
    readonly result: MotionResult,
    /// That it stays on, whether or not it is stable.
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

  /// Largest share of the time in contact, NaN where nothing can touch.
  get contact(): number {
    const field = findField(this.result.layout, FIELD.RUB_SHARE);
    if (!field || field.repeat === 0) return NaN;
    let most = 0;
    for (let which = 0; which < field.repeat; which++) most = Math.max(most, this.number(FIELD.RUB_SHARE, which) || 0);
    return most;
  }

  /// Whether the strongest line of the spectrum turns with the rotation; undefined without lines.
  forwardWhirl(station: number): boolean | undefined {
    const { forward, backward } = this.lines(station);
    return forward.length ? forward[0]! >= backward[0]! : undefined;
  }

  /// Revolutions after which a picture of the motion repeats; 0 where it does not. A first look has pictures before it
  /// has a verdict.
  get period(): number {
    const { verdict } = this.result;
    // That of an orbit with a time of its own is no whole number.
    if (this.orbit || !verdict) return (this.orbit?.period ?? 0) / (2 * Math.PI);
    const returns = this.number(FIELD.REGIME_RECURRENCE) < CLOSED ? this.number(FIELD.REGIME_RECURRENCE_PERIOD) : 0;
    return verdict.period || (verdict.provisional ? returns : 0);
  }

  private spectral(field: string, station: number): Spectrum {
    const [order, x, y, forward, backward] = this.columns(field, station, 5);
    return { order: order!, x: x!, y: y!, forward: forward!, backward: backward! };
  }

  /// The columns of a field's rows, up to the first row that is missing.
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
