// Quasi-periodic motions past Neimark-Sacker points that a run has stored: over the diagram they are the bands in which
// their sections lie.
import { Diagram } from './diagram';
import type { Run } from './run';
import { FIELD } from './fields';

/// One branch of tori.
export interface Torus {
  readonly number: number;
  /// Of the table, in the order in which they were followed.
  readonly points: readonly number[];
  /// The point of the branches of orbits at which it begins, from 0.
  readonly origin: number;
  /// Closed curves of its section, one a revolution of its orbit.
  readonly curves: number;
}

/// Of torus/end: it shrinks to an orbit.
const SHRINKS = 2;

export class Tori {
  private constructor(
    readonly diagram: Diagram,
    readonly all: readonly Torus[],
  ) {}

  /// Those over a parameter; undefined where the run has none.
  static of(run: Run | undefined, parameter: string): Tori | undefined {
    const table = run?.tables.find(({ name }) => name === 'tori');
    if (!table || table.parameter !== parameter || !table.fields.some(({ name }) => name === FIELD.TORUS_ROTATION))
      return undefined;
    const diagram = Diagram.stored(table, run!.length_scale);
    const found = new Map<number, number[]>();
    for (const point of diagram.values.keys()) {
      if (Number.isNaN(diagram.number(point, FIELD.TORUS_ROTATION))) continue; // none begins there
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

  /// The value of the parameter at which the radius vanishes after a point; undefined where it does not.
  vanishesAt(point: number): number | undefined {
    return this.diagram.number(point, FIELD.TORUS_END) === SHRINKS
      ? this.diagram.number(point, FIELD.TORUS_LIMIT)
      : undefined;
  }

  /// Turns round the closed curve from one section to the next.
  rotation(point: number): number {
    return this.diagram.number(point, FIELD.TORUS_ROTATION);
  }
}
