// A grid of finer cells over a part of a map; the engine computes its points.
import type { Layout, SweepPoints } from '../engine/protocol';
import { Diagram } from './diagram';
import { nearestOn, type Cell, type MapAxis } from './parameter_map';

/// Cells of an axis: the first, and the one after the last.
export type Cells = readonly [number, number];

/// Returns an axis whose cells are divided into `parts` of equal size, or of equal ratio on a logarithmic axis.
function finerAxis({ parameter, edges, logarithmic }: MapAxis, [first, end]: Cells, parts: number): MapAxis {
  const count = (end - first) * parts;
  const at = (place: number) => {
    const cell = Math.min(first + Math.floor(place / parts), end - 1);
    const part = place / parts - (cell - first);
    const [low, high] = [edges[cell]!, edges[cell + 1]!];
    return logarithmic ? low * (high / low) ** part : low + (high - low) * part;
  };
  return {
    parameter,
    values: Float64Array.from({ length: count }, (_, i) => at(i + 0.5)),
    edges: Float64Array.from({ length: count + 1 }, (_, i) => at(i)),
    logarithmic,
  };
}

export class MapGrid {
  /// All points, row by row, along the first parameter.
  readonly diagram: Diagram;

  private constructor(
    readonly x: MapAxis,
    readonly y: MapAxis,
  ) {
    const [columns, count] = [x.values.length, x.values.length * y.values.length];
    const values = Float64Array.from({ length: count }, (_, point) => x.values[point % columns]!);
    this.diagram = Diagram.awaited(x.parameter, values, new Int8Array(count));
  }

  /// Makes a grid by dividing cells of both axes of a map into columns and rows.
  static over(x: MapAxis, across: Cells, columns: number, y: MapAxis, up: Cells, rows: number): MapGrid {
    return new MapGrid(finerAxis(x, across, columns), finerAxis(y, up, rows));
  }

  get columns(): number {
    return this.x.values.length;
  }

  get rows(): number {
    return this.y.values.length;
  }

  /// Returns the computed point of a cell, by the number of the cell; -1 without one.
  pointAt(cell: number): number {
    return this.diagram.done[cell] ? cell : -1;
  }

  /// Returns the computed cell at a place; undefined without one.
  at(x: number, y: number): Cell | undefined {
    const inside = ({ edges }: MapAxis, value: number) => value >= edges[0]! && value <= edges.at(-1)!;
    if (!inside(this.x, x) || !inside(this.y, y)) return undefined;
    const [column, row] = [nearestOn(this.x, x), nearestOn(this.y, y)];
    return this.pointAt(row * this.columns + column) < 0 ? undefined : { column, row };
  }

  /// Makes room for the numbers that maps show, one for each point.
  expect(layout: Layout): void {
    this.diagram.expect({ ...layout, fields: layout.fields.filter(({ rows }) => rows === 1) });
  }

  /// Stores points of a row.
  take(row: number, points: SweepPoints): void {
    this.diagram.take(points, (slot) => row * this.columns + slot);
  }
}
