// Refinement of the visible part of a map: finer cells, coarse to fine, until it is stopped.
import { MapGrid, type Cells } from '../data/map_grid';
import type { MapAxis, ParameterMap } from '../data/parameter_map';
import type { Engine, Setting } from '../engine/protocol';
import { plainText } from './map_cut';
import { coarseToFine } from './recompute';

/// Number of cells along each axis: the least of the finest grid, and the largest of a part that can be refined.
export const FINE = 64;

/// The visible cells.
export interface MapPart {
  readonly across: Cells;
  readonly up: Cells;
}

/// Returns true if a part has few enough cells to be refined.
export function canRefine({ across, up }: MapPart): boolean {
  return [across, up].every(([first, end]) => end > first && end - first <= FINE);
}

/// Returns the divisions of the cells of an axis for each grid in turn; an axis may keep its division while the other
/// one is refined further.
function partsOf([first, end]: Cells): number[] {
  const parts = [2];
  while ((end - first) * parts.at(-1)! < FINE) parts.push(2 * parts.at(-1)!);
  return parts;
}

export interface MapRefinementWish {
  readonly map: ParameterMap;
  readonly part: MapPart;
  readonly setting: Setting;
  /// SI unit of the second parameter.
  readonly unit: string;
  /// Revolutions of every motion: before the record, and in it.
  readonly revolutions: readonly [number, number];
  /// True if motions of the stored map have more revolutions.
  readonly shorter: boolean;
  /// Returns a rejection of the engine in the words of the page.
  say(refused: string): string;
}

export class MapRefinement {
  /// Grids, coarse to fine; the last one may be incomplete.
  readonly grids: MapGrid[] = [];
  busy = true;
  /// Error message, or "".
  trouble = '';
  private readonly abort = new AbortController();

  constructor(
    private readonly engine: Engine,
    readonly wish: MapRefinementWish,
    private readonly changed: () => void,
  ) {
    void this.run();
  }

  get map(): ParameterMap {
    return this.wish.map;
  }

  /// Ends the computation; computed cells stay.
  stop(): void {
    this.abort.abort();
  }

  /// Description of its cells for the user.
  get text(): string {
    const { revolutions, shorter } = this.wish;
    const grid = this.grids.at(-1);
    const fewer = shorter ? ', fewer than in the run: its verdict has less confidence' : '';
    if (this.trouble || !grid) return this.trouble && `Finer cells: ${this.wish.say(this.trouble)}.`;
    const { columns, rows, diagram } = grid;
    return (
      `In the dashed frame: ${columns} by ${rows} cells, ${diagram.known} of them computed in this page, each from ` +
      `${revolutions.join(' + ')} revolutions${fewer}; no result holds them.`
    );
  }

  private get over(): boolean {
    return this.abort.signal.aborted || this.trouble !== '';
  }

  private async run(): Promise<void> {
    const { map, part } = this.wish;
    const [columns, rows] = [partsOf(part.across), partsOf(part.up)];
    for (let i = 0; i < Math.max(columns.length, rows.length) && !this.over; i++) {
      const finest = (parts: number[]) => parts[Math.min(i, parts.length - 1)]!;
      const grid = MapGrid.over(map.x, part.across, finest(columns), map.y, part.up, finest(rows));
      this.grids.push(grid);
      await this.fill(grid);
    }
    this.busy = false;
    this.changed();
  }

  /// Computes the rows of a grid, coarse to fine, as many at a time as there are workers.
  private async fill(grid: MapGrid): Promise<void> {
    const rows = coarseToFine(grid.rows);
    const work = async () => {
      for (let row = rows.shift(); row !== undefined && !this.over; row = rows.shift()) await this.row(grid, row);
    };
    await Promise.all(Array.from({ length: this.engine.workers }, work));
  }

  private async row(grid: MapGrid, row: number): Promise<void> {
    const { setting, unit } = this.wish;
    const assignment = `${grid.y.parameter}=${plainText(grid.y.values[row]!, unit)}`;
    const outcome = await this.engine.sweep(
      {
        setting: { ...setting, assignments: [...(setting.assignments ?? []), assignment] },
        parameter: grid.x.parameter,
        values: grid.x.values,
      },
      {
        layout: (layout) => grid.expect(layout),
        points: (points) => {
          grid.take(row, points);
          this.changed();
        },
      },
      { priority: 6, signal: this.abort.signal },
    );
    if (!outcome.ok && outcome.why !== 'stale') this.trouble ||= outcome.message;
  }
}

/// Returns the cells of an axis between two values.
export function cellsBetween({ edges }: MapAxis, [low, high]: readonly [number, number]): Cells {
  const slack = 1e-9 * (edges.at(-1)! - edges[0]!);
  let [first, end] = [0, edges.length - 1];
  while (first < end && edges[first + 1]! <= low + slack) first++;
  while (end > first && edges[end - 1]! >= high - slack) end--;
  return [first, end];
}
