// Measured numbers: dots with a rim, so that they are seen over lines and clouds of computed ones.
import type { Frame } from './chart';
import type { Pen } from './pen';
import type { Theme } from './theme';

export interface Spot {
  readonly x: number;
  readonly y: number;
}

/// Draws dots at values of the axes, in the colour of measured numbers or another one.
export function drawMeasured(
  pen: Pen,
  frame: Frame,
  colours: Theme,
  spots: readonly Spot[],
  colour = colours.measured,
): void {
  const inside = spots.filter(({ x }) => x >= frame.xRange[0] && x <= frame.xRange[1]);
  const radius = radiusOf(inside.length, frame.width / frame.ratio) * frame.ratio;
  drawDots(
    pen,
    inside.map(({ x, y }) => [frame.x(x), frame.y(y)] as const),
    radius,
    colour,
    radius > 2 * frame.ratio ? colours.paper : '',
  );
}

/// Returns the radius of dots in CSS pixels: smaller where there are many.
export function radiusOf(count: number, width: number): number {
  return Math.max(1, Math.min(3.6, (0.3 * width) / Math.max(1, count)));
}

/// Draws dots at positions, each with a rim unless its colour is "".
export function drawDots(
  pen: Pen,
  places: readonly (readonly [number, number])[],
  radius: number,
  colour: string,
  rim: string,
): void {
  const circles = (size: number) => {
    pen.beginPath();
    for (const [x, y] of places) {
      if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
      pen.moveTo(x + size, y);
      pen.arc(x, y, size, 0, 2 * Math.PI);
    }
    pen.fill();
  };
  if (rim) {
    pen.fillStyle = rim;
    circles(1.4 * radius);
  }
  pen.fillStyle = colour;
  circles(radius);
}
