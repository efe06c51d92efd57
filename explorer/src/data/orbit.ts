// The stored orbit of one point of a branch, stable or not.
import { shown } from '../model/units';
import type { Diagram } from './diagram';
import { FIELD } from './fields';

export interface Multiplier {
  readonly real: number;
  readonly imaginary: number;
  /// True for the multiplier 1 of an autonomous orbit, which belongs to shifts along the orbit.
  readonly own: boolean;
}

export class OrbitOfBranch {
  constructor(
    private readonly diagram: Diagram,
    readonly point: number,
    /// Kind of special point; undefined for ordinary points.
    readonly special: string | undefined,
    /// Period in radians of the rotor's clock; 0: an equilibrium.
    readonly period: number,
    /// States at the beginnings of the orbit's segments.
    readonly nodes: Float64Array,
  ) {}

  get value(): number {
    return this.diagram.values[this.point]!;
  }

  private number(field: string): number {
    return this.diagram.number(this.point, `trace/${field}`);
  }

  get branch(): number {
    return this.number('number');
  }

  /// Revolutions after which the orbit closes; 0: an autonomous orbit.
  get revolutions(): number {
    return this.number('revolutions');
  }

  get rests(): boolean {
    return this.period === 0;
  }

  /// Number of multipliers outside the unit circle, or of growing eigenvalues.
  get unstable(): number {
    return this.number('unstable');
  }

  get stable(): boolean {
    return this.unstable === 0;
  }

  /// Largest modulus of a multiplier; for equilibria the growth per radian.
  get largest(): number {
    return this.number('largest');
  }

  get residual(): number {
    return this.number('residual');
  }

  /// "P-2"
  get name(): string {
    return this.rests ? 'equilibrium' : this.revolutions > 0 ? `P-${this.revolutions}` : 'limit cycle';
  }

  /// "P-2, unstable"
  get verdict(): string {
    return `${this.name}, ${this.stable ? 'stable' : 'unstable'}`;
  }

  /// "2 multipliers outside, largest 1.83"
  get evidence(): string {
    const size = shown(this.largest, 3);
    const several = this.unstable === 1 ? '' : 's';
    if (this.rests)
      return this.stable
        ? `largest growth ${size} per rad`
        : `${this.unstable} eigenvalue${several} to the right, growth ${size} per rad`;
    return this.stable
      ? `largest multiplier ${size}`
      : `${this.unstable} multiplier${several} outside, largest ${size}`;
  }

  /// "branch 3: P-2, unstable (2 multipliers outside, largest 1.83)"
  get label(): string {
    const here = this.special ? `, at a ${this.special}` : '';
    return `branch ${this.branch}: ${this.verdict} (${this.evidence})${here}`;
  }

  /// Multipliers, the largest modulus first; for equilibria eigenvalues, the largest real part first.
  get multipliers(): readonly Multiplier[] {
    const [real, imaginary] = [0, 1].map((column) => this.diagram.column(FIELD.TRACE_MULTIPLIERS, 0, column));
    if (!real || !imaginary) return [];
    const first = this.point * real.rows;
    const all = Array.from({ length: real.rows }, (_, i) => ({
      real: real.data[first + i]!,
      imaginary: imaginary.data[first + i]!,
      own: false,
    })).filter((each) => !Number.isNaN(each.real));
    if (this.revolutions > 0 || this.rests) return all;
    const away = all.map((each) => Math.hypot(each.real - 1, each.imaginary));
    const own = away.indexOf(Math.min(...away));
    return all.map((each, i) => ({ ...each, own: i === own }));
  }
}
