// Cells of a map: rectangles if they are few, else a raster whose cost does not depend on the number of cells.
import type { Frame } from './chart';
import { pixelOf } from './theme';
import { SvgPen, type Pen } from './pen';

/// Maximum number of cells that are drawn as rectangles.
const MAX_RECTANGLES = 20_000;

export interface Sheet {
  readonly columns: number;
  readonly rows: number;
  /// [columns + 1], [rows + 1] edges of cells in the pen's pixels; y falls.
  readonly x: readonly number[];
  readonly y: readonly number[];
  /// Returns the colour of a cell, counted row by row; undefined leaves it blank.
  colour(cell: number): string | undefined;
  /// Region id of a cell: no border is drawn between equal ids, or next to NaN; undefined: no borders.
  readonly kind: ((cell: number) => number) | undefined;
  readonly ink: string;
}

/// Visible cells of an axis: the first, and the one after the last.
type Seen = readonly [number, number];

function seenOf(edges: readonly number[], low: number, high: number): Seen {
  const rising = edges[0]! <= edges.at(-1)!;
  const outside = (i: number) => {
    const [a, b] = rising ? [edges[i]!, edges[i + 1]!] : [edges[i + 1]!, edges[i]!];
    return b <= low || a >= high;
  };
  let [from, to] = [0, edges.length - 1];
  while (from < to && outside(from)) from++;
  while (to > from && outside(to - 1)) to--;
  return [from, to];
}

/// Draws the visible cells.
export function drawCells(pen: Pen, sheet: Sheet, frame: Frame): void {
  const across = seenOf(sheet.x, frame.left, frame.left + frame.width);
  const up = seenOf(sheet.y, frame.top, frame.top + frame.height);
  if ((across[1] - across[0]) * (up[1] - up[0]) > MAX_RECTANGLES) {
    drawRaster(pen, sheet, frame);
    return;
  }
  drawRectangles(pen, sheet, across, up, frame.ratio);
  if (!sheet.kind) return;
  pen.strokeStyle = sheet.ink;
  pen.lineWidth = frame.ratio;
  drawBoundaries(pen, sheet, across, up);
}

/// Draws rectangles. Neighbours of one colour in a row are one rectangle, which overlaps the next one slightly to hide
/// the seam.
function drawRectangles(pen: Pen, sheet: Sheet, across: Seen, up: Seen, seam: number): void {
  const { x, y, columns, rows } = sheet;
  for (let row = up[0]; row < up[1]; row++)
    for (let column = across[0], next; column < across[1]; column = next) {
      const colour = sheet.colour(row * columns + column);
      for (next = column + 1; next < across[1] && sheet.colour(row * columns + next) === colour;) next++;
      if (!colour) continue;
      const [under, above] = [next < columns ? seam : 0, row + 1 < rows ? seam : 0];
      pen.fillStyle = colour;
      pen.beginPath();
      pen.rect(x[column]!, y[row + 1]! - above, x[next]! - x[column]! + under, y[row]! - y[row + 1]! + above);
      pen.fill();
    }
}

/// Returns true if both ids are known and differ.
function differ(one: number, other: number): boolean {
  return one < other || one > other;
}

/// Draws borders between cells of different ids.
function drawBoundaries(pen: Pen, sheet: Sheet, across: Seen, up: Seen): void {
  const { x, y, columns, rows } = sheet;
  const kindAt = (column: number, row: number) => sheet.kind!(row * columns + column);
  const line = (fromX: number, fromY: number, toX: number, toY: number) => {
    pen.moveTo(fromX, fromY);
    pen.lineTo(toX, toY);
  };
  pen.beginPath();
  for (let row = up[0]; row < up[1]; row++)
    for (let column = across[0]; column < across[1]; column++) {
      const own = kindAt(column, row);
      const [right, high] = [x[column + 1]!, y[row + 1]!];
      if (column + 1 < columns && differ(own, kindAt(column + 1, row))) line(right, y[row]!, right, high);
      if (row + 1 < rows && differ(own, kindAt(column, row + 1))) line(x[column]!, high, right, high);
    }
  pen.stroke();
}

/// Returns the cell under the middle of every pixel along an axis; -1 outside.
function cellsUnder(edges: readonly number[], first: number, pixels: number): Int32Array {
  const under = new Int32Array(pixels).fill(-1);
  const count = edges.length - 1;
  for (let cell = 0; cell < count; cell++) {
    const [a, b] = [Math.min(edges[cell]!, edges[cell + 1]!), Math.max(edges[cell]!, edges[cell + 1]!)];
    const [from, to] = [Math.max(0, Math.ceil(a - first - 0.5)), Math.min(pixels, Math.ceil(b - first - 0.5))];
    for (let i = from; i < to; i++) under[i] = cell;
  }
  return under;
}

/// Draws a raster; inside an SVG it has twice the resolution.
function drawRaster(pen: Pen, sheet: Sheet, frame: Frame): void {
  const fine = pen instanceof SvgPen ? 2 : 1;
  const [width, height] = [frame.width, frame.height].map((size) => Math.max(1, Math.round(size * fine))) as [
    number,
    number,
  ];
  const finer = (edges: readonly number[]) => edges.map((edge) => edge * fine);
  const columns = cellsUnder(finer(sheet.x), frame.left * fine, width);
  const rows = cellsUnder(finer(sheet.y), frame.top * fine, height);
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext('2d')!;
  const image = context.createImageData(width, height);
  paint(new Uint32Array(image.data.buffer), sheet, columns, rows);
  context.putImageData(image, 0, 0);
  pen.drawImage(canvas, frame.left, frame.top, frame.width, frame.height);
}

function paint(pixels: Uint32Array, sheet: Sheet, columns: Int32Array, rows: Int32Array): void {
  const colours = new Map<string, number>();
  const pixel = (colour: string) => {
    if (!colours.has(colour)) colours.set(colour, pixelOf(colour));
    return colours.get(colour)!;
  };
  const width = columns.length;
  const cellAt = (i: number, j: number) =>
    i < width && j < rows.length && columns[i]! >= 0 && rows[j]! >= 0 ? rows[j]! * sheet.columns + columns[i]! : -1;
  const { kind } = sheet;
  const ink = pixelOf(sheet.ink);
  for (let j = 0; j < rows.length; j++)
    for (let i = 0; i < width; i++) {
      const cell = cellAt(i, j);
      if (cell < 0) continue;
      const colour = sheet.colour(cell);
      if (colour) pixels[j * width + i] = pixel(colour);
      if (!kind) continue;
      const meets = (other: number) => other >= 0 && other !== cell && differ(kind(cell), kind(other));
      if (meets(cellAt(i + 1, j)) || meets(cellAt(i, j + 1))) pixels[j * width + i] = ink;
    }
}
