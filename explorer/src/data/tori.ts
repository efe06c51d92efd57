// Stored quasi-periodic motions past Neimark-Sacker points. In the diagram they are the bands that contain their
// sections.
import { Diagram } from './diagram';
import type { Run } from './run';
import { FIELD } from './fields';

/// One branch of tori.
export interface Torus {
  readonly number: number;
  /// Points of the table, in the order in which they were followed.
  readonly points: readonly number[];
  /// The branch point at which the branch of tori begins, from 0.
  readonly origin: number;
  /// Number of closed curves of its section, one for each revolution of its orbit.
  readonly curves: number;
}

/// Value of torus/end for a branch that shrinks to an orbit.
const SHRINKS = 2;

export class Tori {
  private constructor(
    readonly diagram: Diagram,
    readonly all: readonly Torus[],
  ) {}

  /// Returns the tori over a parameter; undefined if the run has none.
  static of(run: Run | undefined, parameter: string): Tori | undefined {
    const table = run?.tables.find(({ fields }) => fields.some(({ name }) => name === FIELD.TORUS_ROTATION));
    if (!table || table.parameter !== parameter) return undefined;
    const diagram = Diagram.stored(table, run!.length_scale);
    const found = new Map<number, number[]>();
    for (const point of diagram.values.keys()) {
      if (Number.isNaN(diagram.number(point, FIELD.TORUS_ROTATION))) continue; // no torus at this point
      const number = diagram.number(point, FIELD.TORUS_NUMBER);
      found.set(number, [...(found.get(number) ?? []), point]);
    }
    const all = Array.from(found, ([number, points]) => ({
      number,
      points,
      origin: diagram.number(points[0]!, FIELD.TORUS_POINT) - 1,
      curves: diagram.number(points[0]!, FIELD.TORUS_REVOLUTIONS),
    }));
    return new Tori(diagram, all);
  }

  isStable(point: number): boolean {
    return this.diagram.number(point, FIELD.TORUS_UNSTABLE) === 0;
  }

  /// Returns the parameter value at which the radius vanishes after a point; undefined if it does not vanish.
  vanishesAt(point: number): number | undefined {
    return this.diagram.number(point, FIELD.TORUS_END) === SHRINKS
      ? this.diagram.number(point, FIELD.TORUS_LIMIT)
      : undefined;
  }

  /// Returns the rotation number: turns around the closed curve from one section to the next.
  rotation(point: number): number {
    return this.diagram.number(point, FIELD.TORUS_ROTATION);
  }
}
