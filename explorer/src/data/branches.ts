// Branches of periodic orbits that a run has stored: over the diagram they are lines, solid where orbits are stable,
// dashed where not, with marks where and why they change.
import { Diagram } from './diagram';
import type { Run } from './run';

/// Kinds of special points, by the number that results have for them.
export const SPECIALS = [undefined, 'fold', 'crossing', 'doubling', 'torus', 'Hopf', 'graze'] as const;

export type Special = NonNullable<(typeof SPECIALS)[number]>;

/// Neighbouring points of one branch, all stable or none.
export interface Piece {
  readonly stable: boolean;
  readonly points: readonly number[];
}

export interface Change {
  readonly point: number;
  readonly kind: Special;
}

export class Branches {
  private constructor(
    readonly diagram: Diagram,
    readonly pieces: readonly Piece[],
    readonly changes: readonly Change[],
  ) {}

  /// Those over a parameter; undefined where the run has none.
  static of(run: Run | undefined, parameter: string): Branches | undefined {
    const table = run?.tables.find(({ name }) => name === 'branch');
    if (!table || table.parameter !== parameter || !table.fields.some(({ name }) => name === 'trace/special'))
      return undefined;
    const diagram = Diagram.stored(table, run!.length_scale);
    const special = (point: number) => diagram.number(point, 'trace/special');
    const changes = Array.from(diagram.values.keys()).flatMap((point) => {
      const kind = SPECIALS[special(point)];
      return kind ? [{ point, kind }] : [];
    });
    return new Branches(diagram, piecesOf(diagram, special), changes);
  }

  /// A motion with a time of its own is shown by the bounds of its coordinates, not by a section.
  isFree(point: number): boolean {
    return this.diagram.number(point, 'trace/revolutions') === 0 && this.diagram.number(point, 'trace/period') > 0;
  }
}

/// Special points are on the verge: they belong to both sides.
function piecesOf(diagram: Diagram, special: (point: number) => number): Piece[] {
  const pieces: { stable: boolean; points: number[] }[] = [];
  for (let point = 1; point < diagram.count; point++) {
    const before = point - 1;
    if (diagram.number(point, 'trace/number') !== diagram.number(before, 'trace/number')) continue;
    const stable = diagram.number(special(before) > 0 ? point : before, 'trace/unstable') === 0;
    const last = pieces.at(-1);
    if (last?.stable === stable && last.points.at(-1) === before) last.points.push(point);
    else pieces.push({ stable, points: [before, point] });
  }
  return pieces;
}
