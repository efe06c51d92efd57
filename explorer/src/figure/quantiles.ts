// Quantiles over samples: 5 to 95 % pale, 25 to 75 % darker, the median as a line.
import type { StoredBand } from '../data/bands';
import type { Frame } from './chart';
import type { Pen } from './pen';

/// Draws a band; the factors lead from SI to the shown units of both axes.
export function drawQuantiles(
  pen: Pen,
  frame: Frame,
  { places }: StoredBand,
  factors: readonly [number, number],
  colour: string,
): void {
  const at = (which: number) =>
    places.flatMap((place) => {
      const [x, y] = [place[0], place[which]];
      return typeof x === 'number' && typeof y === 'number'
        ? [[frame.x(x * factors[0]), frame.y(y * factors[1])] as const]
        : [];
    });
  pen.save();
  pen.fillStyle = pen.strokeStyle = colour;
  for (const [low, high, alpha] of [
    [1, 5, 0.16],
    [2, 4, 0.24],
  ] as const) {
    pen.globalAlpha = alpha;
    pen.beginPath();
    [...at(low), ...at(high).reverse()].forEach(([x, y], i) => (i > 0 ? pen.lineTo : pen.moveTo).call(pen, x, y));
    pen.closePath();
    pen.fill();
  }
  pen.globalAlpha = 0.8;
  pen.lineWidth = 1.2 * frame.ratio;
  pen.beginPath();
  at(3).forEach(([x, y], i) => (i > 0 ? pen.lineTo : pen.moveTo).call(pen, x, y));
  pen.stroke();
  pen.restore();
}

/// Returns the least and the largest number of a band in a range of the parameter, in SI.
export function reachOfBand({ places }: StoredBand, [from, to]: readonly [number, number]): readonly number[] {
  return places.flatMap(([value, low, , , , high]) =>
    typeof value === 'number' && value >= from && value <= to && typeof low === 'number' && typeof high === 'number'
      ? [low, high]
      : [],
  );
}
