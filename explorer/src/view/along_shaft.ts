// The machine in one harmonic motion: orbits of its stations along the shaft, and both displacements over the position.
// Stations of shafts of finite elements are at their positions; other stations follow with even spacing. Between
// stations, shafts have the bent shape of their elements if the result has it; else lines are straight.
import { largestOf, reachOf, senseOf, swayAt, whirlOf, WHIRL_TEXT, type ShaftLine, type Sway } from '../data/rest';
import type { StationInfo } from '../engine/protocol';
import { Chart, type Frame, type Range } from '../figure/chart';
import { textSize } from '../figure/figure';
import { font, textWidth, type Pen } from '../figure/pen';
import { Round } from '../figure/round';
import type { Theme } from '../figure/theme';
import { tickText } from '../figure/ticks';
import { labelled, positionMeasure, shown } from '../model/units';
import { Panel, type Table } from './panel';
import { whirlColour, type RestSubject } from './rest_subject';
import { key } from './waveform';

/// A motion of all stations; the drawing scales it by its largest displacement.
export interface Motion {
  readonly sways: readonly Sway[];
  /// Factor to shown sizes: "1" for a shape, micrometres for a response.
  readonly factor: number;
  readonly unit: string;
  readonly text: string;
  /// Shafts between stations; undefined: straight lines from station to station.
  readonly line: ShaftLine | undefined;
}

/// Returns each shaft of a motion as places along it with their motions.
function shaftsOf({ line, sways }: Motion, layout: Layout): (readonly (readonly [number, Sway])[])[] {
  if (!line)
    return layout.lines.map((shaft) => shaft.map((station) => [layout.at[station]!, sways[station]!] as const));
  const numbers = [...new Set(line.shaft)];
  return numbers.map((number) =>
    line.sways.flatMap((sway, i) => (line.shaft[i] === number ? [[line.position[i]!, sway] as const] : [])),
  );
}

export interface SwaySubject extends RestSubject {
  readonly motion: Motion;
}

/// Positions of stations along the drawing.
interface Layout {
  /// [station] positions, m; without shafts the number of the station.
  readonly at: readonly number[];
  /// Stations of each shaft, along it.
  readonly lines: readonly (readonly number[])[];
  readonly range: Range;
  /// Position of the last station on a shaft, m; stations beyond it are on no shaft.
  readonly end: number;
}

export function layoutOf(stations: readonly StationInfo[], line?: ShaftLine): Layout {
  const shafts = new Map<number, number[]>();
  stations.forEach(({ shaft }, i) => shaft > 0 && shafts.set(shaft, [...(shafts.get(shaft) ?? []), i]));
  const lines = [...shafts.values()].map((line) => line.sort((a, b) => stations[a]!.position - stations[b]!.position));
  if (lines.length === 0) {
    const at = stations.map((_, i) => i + 1);
    return { at, lines: [], range: [0.5, stations.length + 0.5], end: Infinity };
  }
  const places = [...lines.flat().map((i) => stations[i]!.position), ...(line?.position ?? [])];
  const [low, high] = [Math.min(...places), Math.max(...places)];
  const step = 0.16 * (high - low) || 1;
  let others = 0;
  const at = stations.map(({ shaft, position }) => (shaft > 0 ? position : high + step * ++others));
  const room = 0.06 * (high - low) || 0.5;
  return { at, lines, range: [low - room, high + step * others + room], end: others ? high + step / 2 : Infinity };
}

function reachOfAll(sways: readonly Sway[]): number {
  return largestOf(sways.map(reachOf)) || 1;
}

const STEPS = 72;
/// Share of the orbit that is drawn: the gap and the bright end show the direction of whirl.
const GAP = 0.9;

/// Orbits of all stations in oblique projection.
export class ShapePanel extends Panel<SwaySubject> {
  readonly figure: Round;

  constructor(title: string) {
    super('shape', title);
    this.figure = new Round(title, (pen, width, height, colours) => this.draw(pen, width, height, colours));
    this.assemble();
  }

  protected refresh(): void {
    const { motion } = this.subject!;
    this.note.textContent = motion.text;
    this.figure.description = motion.text;
    this.figure.redraw();
  }

  protected table(): Table {
    return tableOf(this.subject!);
  }

  private draw(pen: Pen, width: number, height: number, colours: Theme): void {
    const { motion, rest } = this.subject!;
    const layout = layoutOf(rest.stations, motion.line);
    const size = textSize();
    const [low, high] = layout.range;
    const reach = Math.min(0.3 * height, 0.12 * width + 0.1 * height);
    const scale = reach / reachOfAll([...motion.sways, ...(motion.line?.sways ?? [])]);
    const slant = 0.42;
    const middle = 0.5 * height - 0.4 * size;
    const across = (at: number) => 0.5 * reach + ((width - reach) * (at - low)) / (high - low);
    // Draw x out of the plane of the drawing, to the left and down.
    const placeAt = (at: number, [x, y]: readonly [number, number]) =>
      [across(at) - slant * scale * x, middle - scale * y + 0.6 * slant * scale * x] as const;
    const place = (station: number, xy: readonly [number, number]) => placeAt(layout.at[station]!, xy);
    pen.strokeStyle = colours.frame;
    pen.lineWidth = 1;
    for (const line of layout.lines)
      polyline(
        pen,
        line.map((station) => place(station, [0, 0])),
      );
    motion.sways.forEach((sway, station) => drawOrbit(pen, sway, (xy) => place(station, xy), colours));
    pen.strokeStyle = colours.ink;
    pen.lineWidth = 1.8;
    for (const shaft of shaftsOf(motion, layout))
      polyline(
        pen,
        shaft.map(([at, sway]) => placeAt(at, swayAt(sway, 0))),
      );
    drawNames(pen, rest.stations, layout.at.map(across), height - 0.5 * size, colours, size);
    drawTriad(pen, [1.3 * size, 1.6 * size], size, colours);
  }
}

function polyline(pen: Pen, places: readonly (readonly [number, number])[]): void {
  pen.beginPath();
  let down = false;
  for (const [x, y] of places) {
    const there = Number.isFinite(x + y);
    if (there) (down ? pen.lineTo : pen.moveTo).call(pen, x, y);
    down = there;
  }
  pen.stroke();
}

function drawOrbit(
  pen: Pen,
  sway: Sway,
  place: (xy: readonly [number, number]) => readonly [number, number],
  colours: Theme,
): void {
  const colour = whirlColour(whirlOf(senseOf(sway)), colours);
  pen.strokeStyle = colour;
  pen.lineWidth = 1.4;
  polyline(
    pen,
    Array.from({ length: STEPS + 1 }, (_, i) => place(swayAt(sway, (2 * Math.PI * GAP * i) / STEPS))),
  );
  const [x, y] = place(swayAt(sway, 0));
  if (!Number.isFinite(x + y)) return;
  pen.fillStyle = colour;
  pen.beginPath();
  pen.moveTo(x + 3, y);
  pen.arc(x, y, 3, 0, 2 * Math.PI);
  pen.fill();
}

/// Draws names below their stations, as far as there is room.
function drawNames(
  pen: Pen,
  stations: readonly StationInfo[],
  at: readonly number[],
  bottom: number,
  colours: Theme,
  size: number,
): void {
  const face = font(size);
  pen.font = face;
  pen.fillStyle = colours.muted;
  pen.textAlign = 'center';
  pen.textBaseline = 'bottom';
  const ends = [-Infinity, -Infinity, -Infinity];
  const order = at.map((_, i) => i).sort((a, b) => at[a]! - at[b]!);
  for (const i of order) {
    const half = textWidth(stations[i]!.name, face) / 2 + 0.3 * size;
    const row = ends.findIndex((end) => at[i]! - half > end);
    if (row < 0) continue;
    ends[row] = at[i]! + half;
    pen.fillText(stations[i]!.name, at[i]!, bottom - row * 1.1 * size);
  }
}

function drawTriad(pen: Pen, [x, y]: readonly [number, number], size: number, colours: Theme): void {
  const long = 1.5 * size;
  pen.strokeStyle = pen.fillStyle = colours.muted;
  pen.lineWidth = 1;
  pen.font = font(0.9 * size);
  pen.textAlign = 'left';
  pen.textBaseline = 'middle';
  const [left, down] = [0.42 * 1.6 * long, 0.6 * 0.42 * 1.6 * long];
  const origin = [x + left, y + 0.2 * size] as const;
  for (const [dx, dy, name] of [
    [long, 0, 'z'],
    [0, -long, 'y'],
    [-left, down, 'x'],
  ] as const) {
    pen.beginPath();
    pen.moveTo(...origin);
    pen.lineTo(origin[0] + dx, origin[1] + dy);
    pen.stroke();
    pen.fillText(name, origin[0] + dx + 3, origin[1] + dy);
  }
}

/// Returns a table with the stations, then the places of shafts between them.
function tableOf({ rest, motion }: SwaySubject): Table {
  const unit = motion.unit ? ` (${motion.unit})` : '';
  const row = (name: string, shaft: number, position: number, sway: Sway) => {
    const parts = [sway.xc, sway.xs, sway.yc, sway.ys].map((each) => each * motion.factor);
    return [name, shaft || '', shaft ? position : '', ...parts, WHIRL_TEXT[whirlOf(senseOf(sway))]];
  };
  const { line } = motion;
  return {
    heading: ['station', 'shaft', 'z (m)', ...['x cos', 'x sin', 'y cos', 'y sin'].map((part) => part + unit), 'whirl'],
    rows: [
      ...rest.stations.map(({ name, shaft, position }, i) => row(name, shaft, position, motion.sways[i]!)),
      ...(line ? line.sways.map((sway, i) => row('', line.shaft[i]!, line.position[i]!, sway)) : []),
    ],
  };
}

/// Both displacements over the position, when the largest displacement has its peak and a quarter of a period later.
export class DisplacementsPanel extends Panel<SwaySubject> {
  readonly figure: Chart;
  private stations: readonly StationInfo[] = [];

  constructor(title: string) {
    super('displacements', title);
    this.figure = new Chart({
      title,
      xText: (value, step) =>
        this.stations.some(({ shaft }) => shaft > 0) ? tickText(value, step) : this.nameAt(value),
      over: (pen, frame, colours) => this.drawMotion(pen, frame, colours),
    });
    this.assemble();
  }

  protected refresh(): void {
    const { motion, rest, units } = this.subject!;
    this.stations = rest.stations;
    const layout = layoutOf(rest.stations, motion.line);
    const most = 1.15 * reachOfAll([...motion.sways, ...(motion.line?.sways ?? [])]) * motion.factor;
    const along = positionMeasure(units);
    const factor = layout.lines.length > 0 ? along.factor : 1;
    this.figure.setAxes(
      layout.lines.length > 0 ? labelled('z', along.unit) : 'station',
      motion.unit ? `displacement (${motion.unit})` : 'displacement',
    );
    this.figure.show([layout.range[0] * factor, layout.range[1] * factor], [-most, most]);
    this.figure.redraw();
    this.note.replaceChildren(
      key('x', 'key-x'),
      key('y', 'key-y'),
      document.createTextNode('dashed, open: a quarter of a period later'),
    );
  }

  protected table(): Table {
    return tableOf(this.subject!);
  }

  private nameAt(value: number): string {
    return Number.isInteger(value) ? (this.stations[value - 1]?.name ?? '') : '';
  }

  private drawMotion(pen: Pen, frame: Frame, colours: Theme): void {
    if (!this.subject) return;
    const { motion, units } = this.subject;
    const layout = layoutOf(this.stations, motion.line);
    const factor = layout.lines.length > 0 ? positionMeasure(units).factor : 1;
    const size = textSize() * frame.ratio;
    const across = (station: number) => frame.x(layout.at[station]! * factor);
    pen.strokeStyle = colours.muted;
    pen.lineWidth = frame.ratio;
    polyline(pen, [
      [frame.left, frame.y(0)],
      [frame.left + frame.width, frame.y(0)],
    ]);
    if (Number.isFinite(layout.end)) this.drawAside(pen, frame, frame.x(layout.end * factor), colours, size, across);
    for (const [axis, colour] of [colours.x, colours.y].entries())
      for (const later of [true, false]) {
        const heightOf = (sway: Sway) => frame.y(swayAt(sway, later ? Math.PI / 2 : 0)[axis]! * motion.factor);
        const place = (station: number) => [across(station), heightOf(motion.sways[station]!)] as const;
        pen.strokeStyle = pen.fillStyle = colour;
        pen.lineWidth = 1.5 * frame.ratio;
        pen.setLineDash(later ? [5 * frame.ratio, 4 * frame.ratio] : []);
        for (const shaft of shaftsOf(motion, layout))
          polyline(
            pen,
            shaft.map(([at, sway]) => [frame.x(at * factor), heightOf(sway)] as const),
          );
        pen.setLineDash([]);
        motion.sways.forEach((_, station) => drawDot(pen, place(station), 2.8 * frame.ratio, later, colours));
      }
  }

  /// Draws stations without a shaft separately, with their names.
  private drawAside(
    pen: Pen,
    frame: Frame,
    end: number,
    colours: Theme,
    size: number,
    across: (station: number) => number,
  ): void {
    pen.strokeStyle = colours.frame;
    pen.setLineDash([2 * frame.ratio, 3 * frame.ratio]);
    polyline(pen, [
      [end, frame.top],
      [end, frame.top + frame.height],
    ]);
    pen.setLineDash([]);
    pen.fillStyle = colours.muted;
    pen.font = font(0.9 * size);
    pen.textBaseline = 'middle';
    pen.textAlign = 'left';
    this.stations.forEach(({ name, shaft }, station) => {
      if (shaft > 0) return;
      pen.save();
      pen.translate(across(station) - 0.7 * size, frame.top + frame.height - 0.4 * size);
      pen.rotate(-Math.PI / 2);
      pen.fillText(name, 0, 0);
      pen.restore();
    });
  }
}

function drawDot(pen: Pen, [x, y]: readonly [number, number], radius: number, open: boolean, colours: Theme): void {
  if (!Number.isFinite(x + y)) return;
  const ink = pen.fillStyle;
  if (open) pen.fillStyle = colours.paper;
  pen.beginPath();
  pen.moveTo(x + radius, y);
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fill();
  if (open) pen.stroke();
  pen.fillStyle = ink;
}

/// Returns the text of the largest displacement, to follow a text such as "forward, 104.2 Hz".
export function sizeText({ sways, factor, unit }: Omit<Motion, 'text' | 'line'>): string {
  return `largest ${shown(reachOfAll(sways) * factor, 4)} ${unit}`.trim();
}
