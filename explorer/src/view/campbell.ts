// The Campbell diagram: natural frequencies over a parameter, and their damping below.
import {
  CRITICAL_TEXT,
  largestOf,
  ROUNDING,
  WHIRL_TEXT,
  whirlOf,
  type Critical,
  type Mode,
  type Place,
} from '../data/rest';
import { Segments } from '../dom';
import { Chart, drawZero, isInside, type Frame, type Range } from '../figure/chart';
import { textSize, type Picture } from '../figure/figure';
import { drawLabels, type Marked } from '../figure/labels';
import { drawMark } from '../figure/marks';
import type { Pen } from '../figure/pen';
import type { Theme } from '../figure/theme';
import type { RestChoice } from '../model/setting';
import { labelled, naturalMeasure, parameterMeasure, shown, shownWhole } from '../model/units';
import type { Table } from './panel';
import {
  lineKey,
  markKey,
  pictureOf,
  WHIRL_MARKS,
  whirlColour,
  type Key,
  type RestChart,
  type RestSubject,
} from './rest_subject';
import { Stack, type StackListener } from './stack';

/// Largest frequency shown over the highest speed, unless all modes are shown.
const ORDERS = 2;
/// Largest damping ratio on the axis. More damped modes hardly show in a response. API 617 asks for no margin from
/// peaks with an amplification below 2.5. One degree of freedom with unbalance has it above a damping ratio of 0.17
/// (docs/theory.md); the axis ends a little above that.
const MAX_RATIO = 0.25;
/// CSS pixels between marks on a curve.
const APART = 16;

export interface CampbellListener extends StackListener {
  chosen(part: Partial<RestChoice>): void;
}

export class CampbellView implements RestChart {
  readonly title = 'Campbell diagram';
  readonly stack: Stack;
  readonly tools: readonly HTMLElement[];
  private readonly main: Chart;
  private readonly lower: Chart;
  private readonly damping: Segments;
  private readonly reach: Segments;
  private subject: RestSubject | undefined;

  constructor(listener: CampbellListener) {
    this.main = new Chart({
      title: 'Natural frequencies',
      bareX: true,
      under: (pen, frame, colours) => this.drawUnstable(pen, frame, colours),
      over: (pen, frame, colours) => this.drawFrequencies(pen, frame, colours),
      marks: (pen, frame, colours) => this.markFrequencies(pen, frame, colours),
    });
    this.lower = new Chart({
      title: 'Damping of the modes',
      under: (pen, frame, colours) => this.drawUnstable(pen, frame, colours),
      over: (pen, frame, colours) => this.drawDamping(pen, frame, colours),
      marks: (pen, frame, colours) => this.markDamping(pen, frame, colours),
    });
    this.stack = new Stack(this.main, this.lower, listener, (value, steps) => {
      const { rest } = this.subject!;
      return rest.diagram.values[rest.neighbour(value, steps)] ?? value;
    });
    this.damping = new Segments(
      'Damping as',
      [
        { value: 'ratio', text: '\u03b6', title: 'Damping ratio' },
        { value: 'decrement', text: '\u03b4', title: 'Logarithmic decrement' },
      ],
      'ratio',
      (value) => listener.chosen({ decrement: value === 'decrement' }),
    );
    this.reach = new Segments(
      'Frequencies',
      [
        { value: 'near', text: 'near 1X', title: `Frequencies up to ${ORDERS} times the highest speed` },
        { value: 'all', text: 'all', title: 'All modes of the result, however high and however damped' },
      ],
      'near',
      (value) => listener.chosen({ all: value === 'all' }),
    );
    this.tools = [this.damping.root, this.reach.root];
  }

  show(subject: RestSubject): void {
    this.subject = subject;
    const { units, choice } = subject;
    this.damping.value = choice.decrement ? 'decrement' : 'ratio';
    this.reach.value = choice.all ? 'all' : 'near';
    this.stack.show(subject, choice.decrement, choice.all);
    const xLabel = labelled(subject.parameter, parameterMeasure(subject.unit, units).unit);
    this.main.setAxes(xLabel, labelled('damped frequency', naturalMeasure(units).unit));
    this.lower.setAxes(xLabel, choice.decrement ? 'log. decrement' : 'damping ratio');
    const top = topOf(subject);
    this.main.show(this.stack.range, [0, top * naturalMeasure(units).factor]);
    this.lower.show(this.stack.range, this.dampingRange(subject, top));
    this.stack.redraw();
  }

  keys(): readonly Key[] {
    const { rest } = this.subject!;
    const modes = rest.curves.flatMap((curve) => curve.map(({ mode }) => whirlOf(mode.direction)));
    const signs = { forward: '\u25b2', backward: '\u25bc', planar: '\u25a0' } as const;
    const keys = (['forward', 'backward', 'planar'] as const)
      .filter((whirl) => modes.includes(whirl))
      .map((whirl) =>
        markKey(signs[whirl], whirl, WHIRL_TEXT[whirl], WHIRL_MARKS[whirl], (colours) => whirlColour(whirl, colours)),
      );
    keys.push(lineKey('\u254c', 'plain', 'speed of the shaft, 1X', [6, 4], (colours) => colours.muted));
    if (rest.critical.some(({ kind }) => kind === 'critical'))
      keys.push(markKey('\u25cb', 'plain', 'critical speed', 'ring', (colours) => colours.ink));
    if (rest.critical.some(({ kind }) => kind !== 'critical'))
      keys.push(markKey('\u2715', 'threshold', 'threshold of stability', 'cross', (colours) => colours.touch));
    if (rest.order.some((point) => rest.growing(point) > 0))
      keys.push({
        ...{ sign: '\u25ae', kind: 'unstable', text: 'unstable' },
        draw: (pen, x, y, size, colours) => {
          pen.fillStyle = colours.contactShade;
          pen.beginPath();
          pen.rect(x - 0.5 * size, y - 0.5 * size, size, size);
          pen.fill();
        },
      });
    return keys;
  }

  picture(): Picture {
    return pictureOf(this.title, this.stack, this.keys());
  }

  table(): Table {
    const { rest, parameter, unit, units } = this.subject!;
    const [value, frequency] = [parameterMeasure(unit, units), naturalMeasure(units)];
    return {
      heading: [
        labelled(parameter, value.unit),
        labelled('speed', frequency.unit),
        'mode',
        'name',
        labelled('damped frequency', frequency.unit),
        'damping ratio',
        'logarithmic decrement',
        'whirl (1 forward to -1 backward)',
      ],
      rows: rest.order.flatMap((point) =>
        rest
          .modes(point)
          .map((mode, i) => [
            rest.diagram.values[point]! * value.factor,
            rest.speed(point) * frequency.factor,
            i + 1,
            mode.name,
            mode.frequency * frequency.factor,
            mode.ratio,
            mode.decrement,
            mode.direction,
          ]),
      ),
    };
  }

  // ---------------------------------------------------------------- ranges

  private dampingRange({ rest, choice }: RestSubject, top: number): Range {
    const seen = rest.curves
      .flatMap((curve) => curve.map(({ mode }) => mode))
      .filter(({ frequency }) => frequency <= top);
    // Extend the range if all modes have more damping.
    const most = Math.max(
      MAX_RATIO,
      -1.5 *
        largestOf(
          seen.map(({ ratio }) => -ratio),
          -Infinity,
        ),
    );
    let [low, high] = [0, 0];
    for (const mode of seen) {
      if (!choice.all && mode.ratio > most) continue;
      low = Math.min(low, dampingOf(mode, choice));
      high = Math.max(high, dampingOf(mode, choice));
    }
    const room = high - low > ROUNDING ? 0.08 * (high - low) : 0.01;
    return [low - room, high + room];
  }

  // ---------------------------------------------------------------- drawing

  private valueFactor(): number {
    return parameterMeasure(this.subject!.unit, this.subject!.units).factor;
  }

  /// Shades ranges with a growing mode, from threshold to threshold.
  private drawUnstable(pen: Pen, frame: Frame, colours: Theme): void {
    if (!this.subject) return;
    const { rest } = this.subject;
    const values = rest.order.map((point) => rest.diagram.values[point]!);
    const thresholds = rest.critical.filter(({ kind }) => kind !== 'critical').map(({ value }) => value);
    const border = (i: number) => {
      const [a, b] = [values[i]!, values[i + 1]!];
      return thresholds.find((value) => value >= a && value <= b) ?? (a + b) / 2;
    };
    pen.fillStyle = colours.contactShade;
    pen.beginPath();
    rest.order.forEach((point, i) => {
      if (!(rest.growing(point) > 0)) return;
      const left = frame.x((i > 0 ? border(i - 1) : values[i]!) * this.valueFactor());
      const right = frame.x((i + 1 < values.length ? border(i) : values[i]!) * this.valueFactor());
      pen.rect(left, frame.top, right - left, frame.height);
    });
    pen.fill();
  }

  private drawFrequencies(pen: Pen, frame: Frame, colours: Theme): void {
    if (!this.subject) return;
    const { factor } = naturalMeasure(this.subject.units);
    this.drawSpeed(pen, frame, colours, factor);
    this.drawCurves(pen, frame, colours, ({ frequency }) => frequency * factor);
  }

  private markFrequencies(pen: Pen, frame: Frame, colours: Theme): void {
    if (!this.subject) return;
    const { factor } = naturalMeasure(this.subject.units);
    this.drawPoints(pen, frame, colours, ({ frequency }) => frequency * factor);
    this.drawCritical(pen, frame, colours, ({ frequency }) => frequency * factor, true);
  }

  private drawDamping(pen: Pen, frame: Frame, colours: Theme): void {
    if (!this.subject) return;
    const { choice } = this.subject;
    drawZero(pen, frame, colours.muted);
    const top = topOf(this.subject);
    this.drawCurves(pen, frame, colours, (mode) => (mode.frequency <= top ? dampingOf(mode, choice) : NaN));
  }

  private markDamping(pen: Pen, frame: Frame, colours: Theme): void {
    if (!this.subject) return;
    const { choice } = this.subject;
    const top = topOf(this.subject);
    this.drawPoints(pen, frame, colours, (mode) => (mode.frequency <= top ? dampingOf(mode, choice) : NaN));
    this.drawCritical(pen, frame, colours, () => 0, false);
  }

  private drawSpeed(pen: Pen, frame: Frame, colours: Theme, factor: number): void {
    const { rest } = this.subject!;
    pen.strokeStyle = colours.muted;
    pen.lineWidth = 1.3 * frame.ratio;
    pen.setLineDash([6 * frame.ratio, 4 * frame.ratio]);
    pen.beginPath();
    rest.order.forEach((point, i) => {
      const [x, y] = [rest.diagram.values[point]! * this.valueFactor(), Math.abs(rest.speed(point)) * factor];
      (i > 0 ? pen.lineTo : pen.moveTo).call(pen, frame.x(x), frame.y(y));
    });
    pen.stroke();
    pen.setLineDash([]);
  }

  /// Returns a function for the position of a point's mode in the frame.
  private placer(frame: Frame, heightOf: (mode: Mode) => number): (place: Place) => readonly [number, number] {
    const { values } = this.subject!.rest.diagram;
    return ({ point, mode }) => [frame.x(values[point]! * this.valueFactor()), frame.y(heightOf(mode))];
  }

  private drawCurves(pen: Pen, frame: Frame, colours: Theme, heightOf: (mode: Mode) => number): void {
    const { rest } = this.subject!;
    const place = this.placer(frame, heightOf);
    pen.lineWidth = 1.5 * frame.ratio;
    for (const curve of rest.curves) this.drawCurve(pen, curve.map(place), curve, colours);
  }

  private drawPoints(pen: Pen, frame: Frame, colours: Theme, heightOf: (mode: Mode) => number): void {
    const { rest } = this.subject!;
    const place = this.placer(frame, heightOf);
    // Keep a distance between marks of modes that were not followed, separately for each number of a mode.
    const lasts = new Map<number, number>();
    for (const curve of rest.curves) {
      let last = -Infinity;
      for (const each of curve) {
        const [x, y] = place(each);
        if (curve.length === 1) last = lasts.get(each.index) ?? -Infinity;
        if (!(Math.abs(x - last) >= APART * frame.ratio) || !isInside(frame, x, y)) continue;
        last = x;
        if (curve.length === 1) lasts.set(each.index, x);
        const whirl = whirlOf(each.mode.direction);
        pen.fillStyle = whirlColour(whirl, colours);
        drawMark(pen, WHIRL_MARKS[whirl], x, y, 3.4 * frame.ratio);
      }
    }
  }

  /// Draws a curve in pieces of one colour.
  private drawCurve(
    pen: Pen,
    places: readonly (readonly [number, number])[],
    curve: readonly Place[],
    colours: Theme,
  ): void {
    for (let i = 1; i < curve.length;) {
      const whirl = whirlOf(curve[i]!.mode.direction);
      pen.strokeStyle = whirlColour(whirl, colours);
      pen.beginPath();
      let open = false;
      for (; i < curve.length && whirlOf(curve[i]!.mode.direction) === whirl; i++) {
        const [[x0, y0], [x1, y1]] = [places[i - 1]!, places[i]!];
        const whole = Number.isFinite(y0 + y1);
        if (whole && !open) pen.moveTo(x0, y0);
        if (whole) pen.lineTo(x1, y1);
        open = whole;
      }
      pen.stroke();
    }
  }

  private drawCritical(
    pen: Pen,
    frame: Frame,
    colours: Theme,
    heightOf: (found: Pick<Critical, 'frequency'>) => number,
    all: boolean,
  ): void {
    const { rest } = this.subject!;
    const size = textSize() * frame.ratio;
    const marks: Marked[] = [];
    for (const found of rest.critical) {
      if (found.kind === 'critical' && !all) continue;
      const [x, y] = [frame.x(found.value * this.valueFactor()), frame.y(heightOf(found))];
      if (!isInside(frame, x, y)) continue;
      pen.lineWidth = 1.6 * frame.ratio;
      pen.strokeStyle = found.kind === 'critical' ? colours.ink : colours.touch;
      drawMark(pen, found.kind === 'critical' ? 'ring' : 'cross', x, y, 5 * frame.ratio);
      marks.push({ x, y, text: shownWhole(found.value * this.valueFactor(), 5) });
    }
    if (!all) return;
    drawLabels(pen, [...marks.reverse(), ...this.lineEnds(frame, heightOf)], frame, size, colours);
  }

  /// Returns the ends of lines at the right edge, from above. If two lines end at the same place, the name of the upper
  /// one is above it.
  private lineEnds(frame: Frame, heightOf: (mode: Pick<Mode, 'frequency'>) => number): Marked[] {
    const { rest } = this.subject!;
    const place = this.placer(frame, heightOf);
    const ends = rest.curves.flatMap((curve) => {
      const places = curve.map((each) => {
        const [x, y] = place(each);
        return { x, y, text: each.mode.name };
      });
      const seen = places.filter(
        ({ x, y }) => x <= frame.left + frame.width && y >= frame.top && y <= frame.top + frame.height,
      );
      const end = seen.at(-1);
      return end?.text && end.x >= frame.left ? [end] : [];
    });
    return ends.sort((a, b) => a.y - b.y);
  }
}

/// Returns the highest frequency shown, rad/s: above all critical speeds and all frequencies below twice the largest
/// speed.
export function topOf({ rest, choice }: RestSubject): number {
  const fastest = largestOf(rest.order.map((point) => Math.abs(rest.speed(point))));
  let [highest, lowest, near] = [0, Infinity, 0];
  for (const curve of rest.curves)
    for (const { mode } of curve) {
      highest = Math.max(highest, mode.frequency);
      lowest = Math.min(lowest, mode.frequency);
      if (mode.frequency <= ORDERS * fastest) near = Math.max(near, mode.frequency);
    }
  if (choice.all || fastest === 0 || ORDERS * fastest >= highest) return 1.05 * highest || 1;
  return Math.max(Math.min(ORDERS * fastest, 1.1 * Math.max(fastest, near)), 1.2 * lowest);
}

function dampingOf({ ratio, decrement }: Mode, choice: RestChoice): number {
  return choice.decrement ? decrement : ratio;
}

/// Returns the text of a damping ratio or decrement.
export function dampingText(value: number): string {
  return Math.abs(value) <= ROUNDING ? '0' : shown(value, 3);
}

/// Returns "critical speed" with the whirl of its mode.
export function criticalText({ kind, direction }: Critical): string {
  return kind === 'critical' ? `${CRITICAL_TEXT[kind]}, ${WHIRL_TEXT[whirlOf(direction)]}` : CRITICAL_TEXT[kind];
}
