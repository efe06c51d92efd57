// Data of the views of a machine at rest.
import type { StoredBand } from '../data/bands';
import type { MeasuredData } from '../data/measured';
import type { AtRest, Whirl } from '../data/rest';
import { el } from '../dom';
import type { StationInfo } from '../engine/protocol';
import type { Mark } from '../figure/marks';
import { drawMark } from '../figure/marks';
import { font, textWidth, type Pen } from '../figure/pen';
import { textSize, theme, type Picture } from '../figure/figure';
import type { Theme } from '../figure/theme';
import type { RestChoice } from '../model/setting';
import type { Scales } from '../model/units';
import type { Table } from './panel';
import type { Along, Stack } from './stack';

export interface RestSubject extends Along {
  readonly rest: AtRest;
  /// The shown point; -1 if none is computed.
  readonly point: number;
  readonly station: number;
  readonly info: StationInfo;
  readonly scales: Scales;
  readonly choice: RestChoice;
  readonly measured: readonly MeasuredData[];
  readonly bands: readonly StoredBand[] | undefined;
  /// Label for files and titles: "omega 3000 rpm".
  readonly label: string;
}

/// Returns the angle of the first probe in degrees.
export function probeOf({ choice, rest }: RestSubject): number {
  return choice.probe ?? rest.probe;
}

/// A pair of charts over the parameter, in its card.
export interface RestChart {
  readonly title: string;
  readonly stack: Stack;
  readonly tools: readonly HTMLElement[];
  show(subject: RestSubject): void;
  keys(): readonly Key[];
  picture(): Picture;
  table(): Table;
}

/// An entry of a legend: its sign on the page, and a function that draws it.
export interface Key {
  readonly sign: string;
  readonly kind: string;
  readonly text: string;
  readonly draw: (pen: Pen, x: number, y: number, size: number, colours: Theme) => void;
}

export const WHIRL_MARKS: Readonly<Record<Whirl, Mark>> = { forward: 'up', backward: 'down', planar: 'square' };

export function whirlColour(whirl: Whirl, colours: Theme): string {
  return whirl === 'planar' ? colours.muted : colours[whirl];
}

export function markKey(sign: string, kind: string, text: string, mark: Mark, of: (colours: Theme) => string): Key {
  return {
    ...{ sign, kind, text },
    draw: (pen, x, y, size, colours) => {
      pen.fillStyle = pen.strokeStyle = of(colours);
      pen.lineWidth = 1.5;
      drawMark(pen, mark, x, y, 0.35 * size);
    },
  };
}

/// Returns the key of bands of tolerances.
export function bandKey({ samples }: StoredBand): Key {
  return markKey(
    '\u25a8',
    'plain',
    `tolerances, in the colours of the lines: 5 to 95 %, 25 to 75 % and median of ${samples} samples`,
    'square',
    (colours) => colours.band,
  );
}

export function lineKey(
  sign: string,
  kind: string,
  text: string,
  dash: readonly number[],
  of: (colours: Theme) => string,
): Key {
  return {
    ...{ sign, kind, text },
    draw: (pen, x, y, size, colours) => {
      pen.strokeStyle = of(colours);
      pen.lineWidth = 1.5;
      pen.setLineDash([...dash]);
      pen.beginPath();
      pen.moveTo(x - 0.8 * size, y);
      pen.lineTo(x + 0.8 * size, y);
      pen.stroke();
      pen.setLineDash([]);
    },
  };
}

export function keyElements(keys: readonly Key[]): HTMLElement[] {
  return keys.map(({ sign, kind, text }) =>
    el('span', { class: 'legend-sign' }, el('span', { class: `sign sign-${kind}`, 'aria-hidden': 'true' }, sign), text),
  );
}

/// Places the entries of a legend under a picture, in as many lines as needed.
export function placeKeys(keys: readonly Key[], width: number): { readonly x: number; readonly line: number }[] {
  const size = textSize();
  const face = font(size);
  let [x, line] = [0, 0];
  return keys.map(({ text }) => {
    const wide = textWidth(text, face) + 3 * size;
    if (x > 0 && 5 * size + x + wide - size > width) [x, line] = [0, line + 1];
    const place = { x: 5 * size + x, line };
    x += wide;
    return place;
  });
}

/// Returns the picture of a stack's charts with their legend.
export function pictureOf(title: string, stack: Stack, keys: readonly Key[]): Picture {
  const linesOf = (width: number) => 1 + (placeKeys(keys, width).at(-1)?.line ?? 0);
  return stack.picture(
    title,
    (pen, width, top, height) => sketchKeys(keys, pen, width, top, height, height / linesOf(width)),
    linesOf,
  );
}

export function sketchKeys(
  keys: readonly Key[],
  pen: Pen,
  width: number,
  top: number,
  height: number,
  lineHeight: number,
): void {
  const colours = theme();
  const size = textSize();
  pen.fillStyle = colours.paper;
  pen.beginPath();
  pen.rect(0, top, width, height);
  pen.fill();
  const places = placeKeys(keys, width);
  keys.forEach(({ text, draw }, i) => {
    const { x, line } = places[i]!;
    const y = top + (line + 0.5) * lineHeight;
    draw(pen, x, y, size, colours);
    pen.fillStyle = colours.ink;
    pen.font = font(size);
    pen.textAlign = 'left';
    pen.textBaseline = 'middle';
    pen.fillText(text, x + 1.1 * size, y);
  });
}
