// Draws a plane with two axes, with one scale on both if both are lengths.
import { textSize } from './figure';
import { font, type Pen } from './pen';
import type { Theme } from './theme';
import { linearTicks, niceStep, tickText } from './ticks';

export interface Extent {
  centre: number;
  half: number;
}

/// Returns the range of values with a margin, at least `least` to either side; ignores NaN.
export function extent(values: Iterable<number>, least: number): Extent {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (Number.isNaN(value)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (!(low <= high)) [low, high] = [0, 0];
  return { centre: (low + high) / 2, half: Math.max(0.58 * (high - low), least) };
}

interface Area {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

export interface Plane {
  readonly area: Area;
  readonly x: (value: number) => number;
  readonly y: (value: number) => number;
}

/// Draws axes, ticks and names; returns the positions of values.
export function drawPlane(
  pen: Pen,
  [width, height]: readonly [number, number],
  extents: readonly [Extent, Extent],
  equal: boolean,
  names: readonly [string, string],
  colours: Theme,
): Plane {
  const size = textSize();
  const area = { left: 5.2 * size, top: 0.8 * size, width: width - 6.2 * size, height: height - 4 * size };
  const [h, v] = extents.map((each) => ({ ...each })) as [Extent, Extent];
  if (equal) {
    const perPixel = Math.max(h.half / area.width, v.half / area.height);
    h.half = perPixel * area.width;
    v.half = perPixel * area.height;
  }
  const x = (value: number) => area.left + (area.width * (value - h.centre + h.half)) / (2 * h.half);
  const y = (value: number) => area.top + (area.height * (v.centre + v.half - value)) / (2 * v.half);
  drawAxes(pen, area, [h, v], [x, y], names, height, colours, size);
  return { area, x, y };
}

function drawAxes(
  pen: Pen,
  area: Area,
  [h, v]: readonly [Extent, Extent],
  [x, y]: readonly [(value: number) => number, (value: number) => number],
  [xName, yName]: readonly [string, string],
  height: number,
  colours: Theme,
  size: number,
): void {
  const [right, bottom] = [area.left + area.width, area.top + area.height];
  const wanted = [area.width / (6 * size), area.height / (3.5 * size)] as const;
  const ticks = [
    linearTicks(h.centre - h.half, h.centre + h.half, wanted[0]),
    linearTicks(v.centre - v.half, v.centre + v.half, wanted[1]),
  ] as const;
  pen.lineWidth = 1;
  pen.strokeStyle = colours.grid;
  pen.beginPath();
  for (const tick of ticks[0]) {
    pen.moveTo(x(tick), area.top);
    pen.lineTo(x(tick), bottom);
  }
  for (const tick of ticks[1]) {
    pen.moveTo(area.left, y(tick));
    pen.lineTo(right, y(tick));
  }
  pen.stroke();
  pen.strokeStyle = colours.frame;
  pen.beginPath();
  pen.moveTo(area.left, area.top);
  pen.lineTo(area.left, bottom);
  pen.lineTo(right, bottom);
  pen.stroke();
  pen.fillStyle = colours.muted;
  pen.font = font(size);
  pen.textAlign = 'center';
  pen.textBaseline = 'top';
  for (const tick of ticks[0]) pen.fillText(tickText(tick, niceStep(2 * h.half, wanted[0])), x(tick), bottom + 5);
  pen.textAlign = 'right';
  pen.textBaseline = 'middle';
  for (const tick of ticks[1]) pen.fillText(tickText(tick, niceStep(2 * v.half, wanted[1])), area.left - 6, y(tick));
  pen.textAlign = 'center';
  pen.fillText(xName, area.left + area.width / 2, height - 0.8 * size);
  pen.save();
  pen.translate(0.8 * size, area.top + area.height / 2);
  pen.rotate(-Math.PI / 2);
  pen.fillText(yName, 0, 0);
  pen.restore();
}
