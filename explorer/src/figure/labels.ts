// Places the labels of a spectrum's peaks: above their peaks, without overlapping each other or the curves.
import type { Frame } from './chart';
import { font, textWidth, type Pen } from './pen';
import type { Theme } from './theme';

export interface Peak {
  readonly frequency: number;
  readonly amplitude: number;
}

/// Place of a label: middle, half the width and lower edge, in the pen's pixels.
interface Place {
  readonly centre: number;
  readonly half: number;
  readonly bottom: number;
}

export interface Label extends Place {
  readonly text: string;
}

const MAX_LABELS = 6;

/// Returns the highest point of the curves in every pixel column of the frame; the lower edge where there is no curve.
export function skyline(frame: Frame, at: Float64Array, curves: readonly Float64Array[]): Float64Array {
  const floor = frame.top + frame.height;
  const top = new Float64Array(Math.max(1, Math.ceil(frame.width))).fill(floor);
  for (const curve of curves)
    for (let i = 1; i < at.length; i++) {
      const [x0, x1] = [frame.x(at[i - 1]!) - frame.left, frame.x(at[i]!) - frame.left];
      const [y0, y1] = [Math.min(floor, frame.y(curve[i - 1]!)), Math.min(floor, frame.y(curve[i]!))];
      if (Number.isNaN(y0 + y1)) continue; // the curve has a gap
      const height = (column: number) => y0 + (y1 - y0) * Math.min(1, Math.max(0, (column - x0) / (x1 - x0 || 1)));
      for (let column = Math.max(0, Math.floor(x0)); column <= Math.min(top.length - 1, Math.floor(x1)); column++)
        top[column] = Math.min(top[column]!, height(column), height(column + 1));
    }
  return top;
}

/// Returns the possible places of a peak's label, free of curves and inside the frame: above the peak, to either side,
/// next to its tip, or a line higher.
function places(x: number, y: number, half: number, size: number, frame: Frame, top: Float64Array): Place[] {
  const gap = 0.3 * size;
  const roof = (centre: number) => {
    const first = Math.max(0, Math.floor(centre - half - gap - frame.left));
    return Math.min(...top.subarray(first, Math.max(first + 1, Math.ceil(centre + half + gap - frame.left))));
  };
  const inside = (centre: number) => Math.min(Math.max(centre, frame.left + half), frame.left + frame.width - half);
  const above = [0, -0.8 * half, 0.8 * half]
    .map((shift) => inside(x + shift))
    .map((centre) => ({ centre, half, bottom: Math.min(roof(centre), y) - 0.2 * size }));
  const beside = [x - half - 2 * gap, x + half + 2 * gap]
    .filter((centre) => centre === inside(centre))
    .map((centre) => ({ centre, half, bottom: Math.min(roof(centre) - 0.2 * size, y + 0.6 * size) }));
  const higher = above.map((place) => ({ ...place, bottom: place.bottom - 1.15 * size }));
  // Leave out places far from the peak.
  return [...above, ...beside, ...higher].filter(({ bottom }) => bottom >= frame.top + size && y - bottom < 2.2 * size);
}

/// Returns true if two labels are at least half a letter apart.
function apart(one: Place, other: Place, size: number): boolean {
  return (
    Math.abs(one.centre - other.centre) > one.half + other.half + 0.4 * size ||
    Math.abs(one.bottom - other.bottom) > 1.15 * size
  );
}

/// Places the labels of peaks, highest first, as far as there is room; `width` measures a text.
export function placeLabels(
  peaks: readonly Peak[],
  textOf: (peak: Peak) => string,
  frame: Frame,
  top: Float64Array,
  size: number,
  width: (text: string) => number,
): Label[] {
  const taken: Label[] = [];
  for (const peak of peaks) {
    const [x, y] = [frame.x(peak.frequency), frame.y(peak.amplitude)];
    if (taken.length === MAX_LABELS) break;
    if (x < frame.left || x > frame.left + frame.width) continue;
    const text = textOf(peak);
    const place = places(x, y, width(text) / 2, size, frame, top).find((each) =>
      taken.every((other) => apart(each, other, size)),
    );
    if (place) taken.push({ ...place, text });
  }
  return taken;
}

/// Area for labels.
type Room = Pick<Frame, 'left' | 'top' | 'width' | 'height'>;

/// A mark at (x, y), in the pen's pixels, and its text.
export interface Marked {
  readonly x: number;
  readonly y: number;
  readonly text: string;
}

/// Places texts next to their marks without overlapping edges, texts or other marks; texts without room are left out.
function placeNextTo(marks: readonly Marked[], frame: Room, size: number, width: (text: string) => number): Label[] {
  const taken: Label[] = [];
  for (const { x, y, text } of marks) {
    const half = width(text) / 2;
    const away = 0.7 * size;
    const tries = [-1, 1].flatMap((up) =>
      [1, -1, 0].map((side) => ({
        text,
        half,
        centre: x + side * (half + away),
        bottom: y + (up < 0 ? -0.4 : 1.5) * size + (side === 0 ? up * 0.5 * size : 0),
      })),
    );
    const place = tries.find(
      ({ centre, bottom }) =>
        centre - half > frame.left + 2 &&
        centre + half < frame.left + frame.width - 2 &&
        bottom - size > frame.top &&
        bottom < frame.top + frame.height &&
        taken.every((other) => apart({ centre, half, bottom }, other, size)) &&
        marks.every(
          (other) =>
            Math.abs(other.x - centre) > half + 0.45 * size || Math.abs(other.y - bottom + 0.5 * size) > 0.9 * size,
        ),
    );
    if (place) taken.push(place);
  }
  return taken;
}

/// Draws the texts on a background, so that lines do not cross them.
export function drawLabels(pen: Pen, marks: readonly Marked[], frame: Room, size: number, colours: Theme): void {
  const face = font(size);
  pen.font = face;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  for (const { text, centre, half, bottom } of placeNextTo(marks, frame, size, (each) => textWidth(each, face))) {
    pen.fillStyle = colours.paper;
    pen.globalAlpha = 0.75;
    pen.beginPath();
    pen.rect(centre - half - 0.1 * size, bottom - size, 2 * half + 0.2 * size, size);
    pen.fill();
    pen.globalAlpha = 1;
    pen.fillStyle = colours.ink;
    pen.fillText(text, centre, bottom - 0.5 * size);
  }
}
