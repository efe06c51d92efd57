// Lines and marks of branches over a diagram.
import type { Branches, Special } from '../data/branches';
import type { Column } from '../data/diagram';
import type { Frame } from './chart';
import { font, textWidth, type Pen } from './pen';
import { drawMark, type Mark } from './marks';
import type { Theme } from './theme';

/// Branches as lines: one coordinate of the section, or the bounds of an autonomous motion.
export interface BranchLines {
  readonly branches: Branches;
  readonly section: Column;
  readonly bounds: readonly Column[];
  readonly factor: number;
  readonly valueFactor: number;
}

const MARKS: Readonly<Record<Special, Mark>> = {
  fold: 'cross',
  crossing: 'down',
  doubling: 'up',
  torus: 'dot',
  Hopf: 'square',
  graze: 'ring',
};

/// Returns the heights of a point: one for each revolution, or both bounds.
export function heightsOf(lines: BranchLines, point: number): number[] {
  const { section, bounds, branches, factor } = lines;
  if (branches.isFree(point)) return bounds.map(({ data }) => data[point]! * factor);
  const all = Array.from(section.data.subarray(point * section.rows, (point + 1) * section.rows), (v) => v * factor);
  return all.filter((value) => !Number.isNaN(value));
}

function drawLines(pen: Pen, lines: BranchLines, frame: Frame, colours: Theme): void {
  const { values } = lines.branches.diagram;
  for (const { stable, points } of lines.branches.pieces) {
    const heights = points.map((point) => heightsOf(lines, point));
    pen.strokeStyle = stable ? colours.ink : colours.backward;
    pen.lineWidth = (stable ? 1.6 : 1.2) * frame.ratio;
    pen.setLineDash(stable ? [] : [5 * frame.ratio, 3 * frame.ratio]);
    pen.beginPath();
    for (let line = 0; line < (heights[0]?.length ?? 0); line++)
      points.forEach((point, i) => {
        const [x, y] = [frame.x(values[point]! * lines.valueFactor), frame.y(heights[i]![line] ?? NaN)];
        if (i === 0) pen.moveTo(x, y);
        else pen.lineTo(x, y);
      });
    pen.stroke();
  }
  pen.setLineDash([]);
}

/// Draws marks of special points on every line; the first mark of a point has a label with kind and value, if there is
/// room.
function drawChanges(pen: Pen, lines: BranchLines, frame: Frame, colours: Theme): void {
  const size = 10 * frame.ratio;
  const taken: { x: number; y: number; width: number }[] = [];
  const face = font(size);
  pen.font = face;
  pen.textAlign = 'left';
  pen.textBaseline = 'bottom';
  pen.lineWidth = 1.4 * frame.ratio;
  for (const { point, kind } of lines.branches.changes) {
    const value = lines.branches.diagram.values[point]! * lines.valueFactor;
    const x = frame.x(value);
    if (!(x >= frame.left && x <= frame.left + frame.width)) continue;
    pen.fillStyle = pen.strokeStyle = colours.touch;
    const heights = heightsOf(lines, point);
    for (const height of heights) drawMark(pen, MARKS[kind], x, frame.y(height), 3.4 * frame.ratio);
    const text = `${kind} ${Number(value.toPrecision(6))}`;
    const width = textWidth(text, face);
    const y = frame.y(Math.max(...heights)) - 4 * frame.ratio;
    const left = Math.min(x + 3 * frame.ratio, frame.left + frame.width - width);
    const free = taken.every(
      (other) => left > other.x + other.width || left + width < other.x || Math.abs(y - other.y) > size,
    );
    if (!free || !(y - size > frame.top)) continue;
    taken.push({ x: left, y, width });
    pen.fillStyle = colours.ink;
    pen.fillText(text, left, y);
  }
}

export function drawBranches(pen: Pen, lines: BranchLines, frame: Frame, colours: Theme): void {
  pen.save();
  drawLines(pen, lines, frame, colours);
  drawChanges(pen, lines, frame, colours);
  pen.restore();
}
