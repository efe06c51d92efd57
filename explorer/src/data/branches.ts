// Branches of periodic orbits stored by a run. In the diagram they are lines, solid for stable orbits and dashed for
// unstable ones, with marks at special points.
import { Diagram } from './diagram';
import { float64Of, type Run, type StoredTable } from './run';
import { OrbitOfBranch } from './orbit';
import { FIELD } from './fields';

/// Kinds of special points, by their number in results.
export const SPECIALS = [undefined, 'fold', 'crossing', 'doubling', 'torus', 'Hopf', 'graze'] as const;

export type Special = NonNullable<(typeof SPECIALS)[number]>;

/// Neighbouring points of one branch, all stable or all unstable.
export interface Piece {
  readonly stable: boolean;
  readonly points: readonly number[];
}

export interface Change {
  readonly point: number;
  readonly kind: Special;
}

/// Periods and nodes of orbits, one orbit after the other, and the index at which each begins; -1: the page lacks it.
interface Nodes {
  readonly numbers: Float64Array;
  readonly begins: Int32Array;
}

export class Branches {
  private constructor(
    readonly diagram: Diagram,
    readonly pieces: readonly Piece[],
    readonly changes: readonly Change[],
    private readonly nodes: Nodes,
    private readonly segments: number,
  ) {}

  /// Returns the branches over a parameter; undefined if the run has none.
  static of(run: Run | undefined, parameter: string): Branches | undefined {
    const table = run?.tables.find(({ name }) => name === 'branch');
    if (!table || table.parameter !== parameter || !table.fields.some(({ name }) => name === FIELD.TRACE_SPECIAL))
      return undefined;
    const diagram = Diagram.stored(table, run!.length_scale);
    const special = (point: number) => diagram.number(point, FIELD.TRACE_SPECIAL);
    const changes = Array.from(diagram.values.keys()).flatMap((point) => {
      const kind = SPECIALS[special(point)];
      return kind ? [{ point, kind }] : [];
    });
    const segments = table.trace_segments ?? 1;
    return new Branches(diagram, piecesOf(diagram, special), changes, nodesOf(table, diagram, segments), segments);
  }

  /// Returns true for an orbit with a period of its own (autonomous): it is shown by the bounds of its coordinates, not
  /// by a section.
  isFree(point: number): boolean {
    return (
      this.diagram.number(point, FIELD.TRACE_REVOLUTIONS) === 0 && this.diagram.number(point, FIELD.TRACE_PERIOD) > 0
    );
  }

  /// Returns the number of a point's branch, from 1.
  numberOf(point: number): number {
    return this.diagram.number(point, FIELD.TRACE_NUMBER);
  }

  /// Returns the orbit of a point; undefined without such a point, or if the page lacks its nodes.
  orbit(point: number): OrbitOfBranch | undefined {
    const at = this.nodes.begins[point] ?? -1;
    if (at < 0) return undefined;
    const count = nodeNumbers(this.diagram, point, this.segments);
    const [period, nodes] = [this.nodes.numbers[at]!, this.nodes.numbers.subarray(at + 1, at + 1 + count)];
    return new OrbitOfBranch(
      this.diagram,
      point,
      SPECIALS[this.diagram.number(point, FIELD.TRACE_SPECIAL)],
      period,
      nodes,
    );
  }

  /// Returns the point of a branch `steps` orbits further, or the last point if the branch ends before. The direction
  /// is from the end at lower values to the end at higher values, through folds.
  along(point: number, steps: number): number {
    const mine = this.stored((other) => this.numberOf(other) === this.numberOf(point));
    const { values } = this.diagram;
    const rising = values[mine.at(-1)!]! >= values[mine[0]!]!;
    const to = mine.indexOf(point) + (rising ? steps : -steps);
    return mine[Math.min(Math.max(to, 0), mine.length - 1)] ?? point;
  }

  /// Returns the orbits next to a value, one for each passage of a branch.
  at(value: number): number[] {
    const { values } = this.diagram;
    const found = new Set<number>();
    for (let point = 1; point < this.diagram.count; point++) {
      const [from, to] = [values[point - 1]!, values[point]!];
      if (this.numberOf(point) !== this.numberOf(point - 1) || from <= value === to < value) continue;
      const near = this.nearestStored(Math.abs(from - value) <= Math.abs(to - value) ? point - 1 : point);
      if (near >= 0) found.add(near);
    }
    return [...found];
  }

  /// Returns the point of the same branch nearest to a point among those whose orbits are in the page; -1 without any.
  nearestStored(point: number): number {
    const { begins } = this.nodes;
    for (let away = 0; away < begins.length; away++)
      for (const other of [point - away, point + away])
        if ((begins[other] ?? -1) >= 0 && this.numberOf(other) === this.numberOf(point)) return other;
    return -1;
  }

  private stored(wanted: (point: number) => boolean): number[] {
    return Array.from(this.diagram.values.keys()).filter((point) => this.nodes.begins[point]! >= 0 && wanted(point));
  }
}

/// Divides branches into stable and unstable pieces. Special points belong to both sides.
function piecesOf(diagram: Diagram, special: (point: number) => number): Piece[] {
  const pieces: { stable: boolean; points: number[] }[] = [];
  for (let point = 1; point < diagram.count; point++) {
    const before = point - 1;
    if (diagram.number(point, FIELD.TRACE_NUMBER) !== diagram.number(before, FIELD.TRACE_NUMBER)) continue;
    const stable = diagram.number(special(before) > 0 ? point : before, FIELD.TRACE_UNSTABLE) === 0;
    const last = pieces.at(-1);
    if (last?.stable === stable && last.points.at(-1) === before) last.points.push(point);
    else pieces.push({ stable, points: [before, point] });
  }
  return pieces;
}

/// Returns how many numbers the nodes of a point have.
function nodeNumbers(diagram: Diagram, point: number, segments: number): number {
  const dimension = diagram.column(FIELD.TRACE_MULTIPLIERS)?.rows ?? 0;
  const round = Math.max(1, diagram.number(point, FIELD.TRACE_REVOLUTIONS));
  return dimension * round * (diagram.number(point, FIELD.TRACE_PERIOD) > 0 ? segments : 1);
}

function nodesOf(table: StoredTable, diagram: Diagram, segments: number): Nodes {
  const numbers = float64Of(table.orbits ?? '');
  const begins = new Int32Array(diagram.count).fill(-1);
  let at = 0;
  for (let point = 0; point < diagram.count && at < numbers.length; point += table.orbit_stride ?? 1) {
    if (!diagram.done[point]) continue;
    begins[point] = at;
    at += 1 + nodeNumbers(diagram, point, segments);
  }
  return { numbers, begins };
}
