// Clouds of points: a raster coloured by regime, more opaque where more points fall on a pixel. 400,000 points take a
// few milliseconds, much less than single dots.
import type { Diagram, Column } from '../data/diagram';
import type { Frame } from './chart';
import { textSize } from './figure';
import type { Pen } from './pen';
import { pixelOf, type Theme } from './theme';

/// Maximum number of dots drawn as shapes in an SVG; more dots become a picture inside it.
const MAX_SHAPES = 20_000;

const LAST_PERIODIC = 3;
const EDGE = 8;

export interface Cloud {
  readonly diagram: Diagram;
  readonly column: Column;
  /// Factor from the column's numbers to those of the axis.
  readonly factor: number;
  /// Factor from the values in SI to those of the axis.
  readonly valueFactor: number;
  /// Regime classes that are not drawn.
  readonly hidden: ReadonlySet<number>;
}

/// Calls `visitor` with the position of every dot whose middle is in the frame, in the order of the diagram.
function visit(cloud: Cloud, frame: Frame, visitor: (x: number, y: number, kind: number) => void): void {
  const { diagram, column, factor, valueFactor, hidden } = cloud;
  const { rows, data } = column;
  // Both axes are linear.
  const [x0, x1] = [frame.x(frame.xRange[0]), frame.x(frame.xRange[1])];
  const xScale = (x1 - x0) / (frame.xRange[1] - frame.xRange[0]);
  const [y0, y1] = [frame.y(frame.yRange[0]), frame.y(frame.yRange[1])];
  const yScale = ((y1 - y0) / (frame.yRange[1] - frame.yRange[0])) * factor;
  const yBase = y0 - ((y1 - y0) / (frame.yRange[1] - frame.yRange[0])) * frame.yRange[0];
  // Widen the range slightly, so that rounding does not lose the points at the ends.
  const [left, right] = [frame.left - 0.01, frame.left + frame.width + 0.01];
  const [top, bottom] = [frame.top, frame.top + frame.height];
  for (let point = 0; point < diagram.count; point++) {
    const kind = diagram.classes[point]!;
    if (!diagram.done[point] || hidden.has(kind)) continue;
    const x = x0 + (diagram.values[point]! * valueFactor - frame.xRange[0]) * xScale;
    if (x < left || x > right) continue;
    for (let i = point * rows; i < (point + 1) * rows; i++) {
      const y = yBase + data[i]! * yScale;
      if (y >= top && y <= bottom) visitor(x, y, kind);
    }
  }
}

/// Returns the number of points in the frame.
function pointsInside(cloud: Cloud, frame: Frame): number {
  let count = 0;
  for (const value of cloud.diagram.values) {
    const shown = value * cloud.valueFactor;
    if (shown >= frame.xRange[0] && shown <= frame.xRange[1]) count++;
  }
  return count;
}

/// Returns the side of a dot in pixels: about the width of a column of the diagram, within limits.
function dotSize(cloud: Cloud, frame: Frame): number {
  const column = frame.width / Math.max(1, pointsInside(cloud, frame));
  // Enlarge dots with the text of the page on large screens.
  const unit = (frame.ratio * textSize()) / 10.5;
  const least = cloud.column.rows === 1 ? 2.4 : 1;
  return Math.max(1, Math.round(Math.min(Math.max(column, least * unit), 2.6 * unit)));
}

/// Returns the side of a dot of a kind: dots of periodic motions, which are few, are larger.
function sideOf(cloud: Cloud, kind: number, side: number): number {
  return kind <= LAST_PERIODIC && cloud.column.rows > 1 ? side + 1 : side;
}

/// Makes a picture of the frame with EDGE pixels around it, so that dots at its edges are complete.
function raster(cloud: Cloud, frame: Frame, colours: Theme): HTMLCanvasElement {
  const [width, height] = [frame.width, frame.height].map((size) => Math.max(1, Math.round(size)) + 2 * EDGE);
  const side = dotSize(cloud, frame);
  const counts = new Uint16Array(width! * height!);
  const kinds = new Uint8Array(width! * height!);
  visit(cloud, frame, (x, y, kind) => {
    const wide = sideOf(cloud, kind, side);
    const [left, top] = [x - frame.left, y - frame.top].map((at) => EDGE + Math.round(at - (wide - 1) / 2));
    for (let row = Math.max(0, top!); row < Math.min(height!, top! + wide); row++)
      for (let column = Math.max(0, left!); column < Math.min(width!, left! + wide); column++) {
        const at = row * width! + column;
        if (counts[at]! < 65535) counts[at]!++;
        kinds[at] = kind;
      }
  });
  return painted(counts, kinds, width!, height!, colours);
}

/// Paints pixels with an opacity that rises with the number n of hits: 1 - 0.45 e^(-(n-1)/3).
function painted(
  counts: Uint16Array,
  kinds: Uint8Array,
  width: number,
  height: number,
  colours: Theme,
): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext('2d')!;
  const image = context.createImageData(width, height);
  const pixels = new Uint32Array(image.data.buffer);
  const rgb = colours.classes.map((colour) => pixelOf(colour) & 0xffffff);
  const alphas = Array.from({ length: 16 }, (_, n) => Math.round(255 * (1 - 0.45 * Math.exp(-(n - 1) / 3))));
  for (let at = 0; at < counts.length; at++) {
    const count = counts[at]!;
    if (count) pixels[at] = (rgb[kinds[at]!]! | (alphas[Math.min(count, 15)]! << 24)) >>> 0;
  }
  context.putImageData(image, 0, 0);
  return canvas;
}

function drawShapes(pen: Pen, cloud: Cloud, frame: Frame, colours: Theme): void {
  const side = dotSize(cloud, frame);
  const dots = colours.classes.map(() => [] as number[]);
  visit(cloud, frame, (x, y, kind) => dots[kind]!.push(x, y));
  dots.forEach((places, kind) => {
    if (!places.length) return;
    const wide = sideOf(cloud, kind, side);
    pen.fillStyle = colours.classes[kind]!;
    pen.beginPath();
    for (let i = 0; i < places.length; i += 2) pen.rect(places[i]! - wide / 2, places[i + 1]! - wide / 2, wide, wide);
    pen.fill();
  });
}

/// Draws the cloud: as shapes if `shapes` is true and they are not too many, else as a picture.
export function drawCloud(pen: Pen, cloud: Cloud, frame: Frame, colours: Theme, shapes: boolean): void {
  if (shapes && pointsInside(cloud, frame) * cloud.column.rows <= MAX_SHAPES) {
    drawShapes(pen, cloud, frame, colours);
    return;
  }
  const fine = shapes ? 2 : 1; // double resolution inside an SVG
  const finer: Frame = fine === 1 ? frame : magnified(frame, fine);
  const edge = EDGE / fine;
  const [width, height] = [frame.width + 2 * edge, frame.height + 2 * edge];
  pen.drawImage(raster(cloud, finer, colours), frame.left - edge, frame.top - edge, width, height);
}

function magnified(frame: Frame, by: number): Frame {
  return {
    left: frame.left * by,
    top: frame.top * by,
    width: frame.width * by,
    height: frame.height * by,
    ratio: frame.ratio * by,
    xRange: frame.xRange,
    yRange: frame.yRange,
    x: (value) => frame.x(value) * by,
    y: (value) => frame.y(value) * by,
  };
}
