// The Bode diagram: amplitude and lag of the response to unbalance over a parameter, at two probes of one station.
import { bandAt, type StoredBand } from '../data/bands';
import { FIELD } from '../data/fields';
import type { Seen } from '../data/measured';
import { largestOf, reachOf, seenBy, type AtRest } from '../data/rest';
import { select, setChoices } from '../dom';
import { Chart, isInside, type Frame } from '../figure/chart';
import { textSize, type Picture } from '../figure/figure';
import { drawLabels } from '../figure/labels';
import { drawMark } from '../figure/marks';
import { drawMeasured, type Spot } from '../figure/measured';
import type { Pen } from '../figure/pen';
import { drawQuantiles, reachOfBand } from '../figure/quantiles';
import type { Theme } from '../figure/theme';
import { amplitudeMeasure, labelled, metreMeasures, parameterMeasure, shownWhole, written } from '../model/units';
import { AngleField } from './angle_field';
import type { CampbellListener } from './campbell';
import type { Table } from './panel';
import {
  lineKey,
  bandKey,
  markKey,
  probeOf,
  pictureOf,
  type Key,
  type RestChart,
  type RestSubject,
} from './rest_subject';
import { Stack } from './stack';

export interface BodeListener extends CampbellListener {
  station(index: number): void;
}

/// Amplitudes and lags of every point, in the order of the values, in shown units.
export interface Response {
  readonly values: readonly number[];
  readonly points: readonly number[];
  /// [first, second, major axis]
  readonly amplitudes: readonly (readonly number[])[];
  /// Degrees, [first, second].
  readonly lags: readonly (readonly number[])[];
}

export function responseOf(subject: RestSubject): Response {
  const { rest, station, units, scales, unit } = subject;
  const { factor } = parameterMeasure(unit, units);
  const seen = rest.order.map((point) => {
    const sway = rest.response(point, station);
    const length = amplitudeMeasure(units, { ...scales, length: rest.diagram.lengthScales[point]! }).factor;
    const probes = [0, 90].map((more) => seenBy(sway, probeOf(subject) + more));
    return { amplitudes: [...probes.map(({ amplitude }) => amplitude), reachOf(sway)].map((a) => a * length), probes };
  });
  return {
    values: rest.order.map((point) => rest.diagram.values[point]! * factor),
    points: rest.order,
    amplitudes: [0, 1, 2].map((which) => seen.map(({ amplitudes }) => amplitudes[which]!)),
    lags: [0, 1].map((which) => seen.map(({ probes }) => probes[which]!.lag)),
  };
}

/// Band of a line of amplitudes.
interface LineBand {
  readonly which: number;
  readonly band: StoredBand;
}

/// Returns the bands of the station's lines: of both probes if they have their stored angles, else of the major axis.
function bandsOf({ bands, parameter, station, choice, rest }: RestSubject): readonly LineBand[] {
  const stored = choice.probe === undefined || choice.probe === rest.probe;
  const found = (which: number, field: string, column: number) => {
    const band = bandAt(bands, parameter, field, station, column);
    return band ? [{ which, band }] : [];
  };
  const probes = stored ? [0, 1].flatMap((which) => found(which, FIELD.UNBALANCE_PROBE, which)) : [];
  return probes.length > 0 ? probes : found(2, FIELD.UNBALANCE_AXES, 0);
}

/// Returns the bands of the lags at both probes if they have their stored angles.
function lagBandsOf({ bands, parameter, station, choice, rest }: RestSubject): readonly LineBand[] {
  if (choice.probe !== undefined && choice.probe !== rest.probe) return [];
  return [0, 1].flatMap((which) => {
    const band = bandAt(bands, parameter, FIELD.UNBALANCE_PROBE_LAG, station, which);
    return band ? [{ which, band }] : [];
  });
}

/// Measured vectors at the first (0) or second (1) probe.
export interface MeasuredProbe {
  readonly which: number;
  readonly amplitudes: readonly Spot[];
  readonly lags: readonly Spot[];
}

/// Returns measured vectors of the station in shown units.
export function measuredOf(subject: RestSubject): readonly MeasuredProbe[] {
  const { rest, measured, parameter, unit, units, scales, station } = subject;
  const along = parameterMeasure(unit, units).factor;
  const { amplitude } = metreMeasures(units, scales);
  return measured.flatMap((data) => {
    if (data.kind !== 'vectors' || (data.parameter && data.parameter !== parameter)) return [];
    const valueAt = (at: number) => (data.parameter ? at : valueOfSpeed(rest, at)) * along;
    const spots = (seen: Seen, heights: readonly number[], factor: number) =>
      heights.map((height, i) => ({ x: valueAt(seen.at[i]!), y: height * factor }));
    return [0, 1].flatMap((which) => {
      const seen = data.seen(station, probeOf(subject) + 90 * which);
      if (!seen) return [];
      const amplitudes = spots(seen, seen.amplitudes, amplitude.factor);
      return [{ which, amplitudes, lags: spots(seen, seen.lags ?? [], 1) }];
    });
  });
}

/// Returns the parameter's value at a speed, between the stored points; NaN outside of them.
function valueOfSpeed(rest: AtRest, speed: number): number {
  const points = rest.order.map((point) => ({ value: rest.diagram.values[point]!, speed: rest.speed(point) }));
  for (const [i, after] of points.entries()) {
    const before = points[i - 1] ?? after;
    const [low, high] = [Math.min(before.speed, after.speed), Math.max(before.speed, after.speed)];
    if (!(speed >= low && speed <= high)) continue;
    const part = high > low ? (speed - before.speed) / (after.speed - before.speed) : 0;
    return before.value + part * (after.value - before.value);
  }
  return NaN;
}

/// Returns the points whose amplitude exceeds both neighbours and a twentieth of the largest.
function peaksOf(amplitudes: readonly number[]): number[] {
  const most = largestOf(amplitudes);
  return amplitudes.flatMap((each, i) =>
    i > 0 && i + 1 < amplitudes.length && each > amplitudes[i - 1]! && each >= amplitudes[i + 1]! && each > most / 20
      ? [i]
      : [],
  );
}

const DASHES = [[], [7, 4], [2, 3]] as const;
const colourOf = (which: number) => (colours: Theme) => [colours.x, colours.y, colours.muted][which]!;

export class BodeView implements RestChart {
  readonly title = 'Bode diagram';
  readonly stack: Stack;
  readonly tools: readonly HTMLElement[];
  private readonly main: Chart;
  private readonly lower: Chart;
  private readonly station: HTMLSelectElement;
  private readonly probe: AngleField;
  private subject: RestSubject | undefined;
  private measured: readonly MeasuredProbe[] = [];
  private bands: readonly LineBand[] = [];
  private lagBands: readonly LineBand[] = [];
  private response: Response = { values: [], points: [], amplitudes: [[], [], []], lags: [[], []] };

  constructor(listener: BodeListener) {
    this.main = new Chart({
      title: 'Amplitude',
      bareX: true,
      under: (pen, frame, colours) => this.drawBands(pen, frame, colours),
      over: (pen, frame, colours) => this.drawAmplitudes(pen, frame, colours),
      marks: (pen, frame, colours) => this.drawPeaks(pen, frame, colours),
    });
    this.lower = new Chart({
      title: 'Phase lag',
      yTicks: [0, 90, 180, 270, 360],
      under: (pen, frame, colours) => this.drawLagBands(pen, frame, colours),
      over: (pen, frame, colours) => this.drawLags(pen, frame, colours),
    });
    this.stack = new Stack(this.main, this.lower, listener, (value, steps) => {
      const { rest } = this.subject!;
      return rest.diagram.values[rest.neighbour(value, steps)] ?? value;
    });
    this.station = select('Station', [], '', (value) => listener.station(Number(value)));
    this.probe = new AngleField((probe) => listener.chosen({ probe }));
    this.tools = [this.station, this.probe.root];
  }

  show(subject: RestSubject): void {
    this.subject = subject;
    const { units, scales, rest } = subject;
    setChoices(
      this.station,
      rest.stations.map(({ name }, i) => ({ value: String(i), text: name })),
      String(subject.station),
    );
    this.probe.show(probeOf(subject));
    this.response = responseOf(subject);
    this.measured = measuredOf(subject);
    this.bands = bandsOf(subject);
    this.lagBands = lagBandsOf(subject);
    this.stack.show(subject, subject.station);
    const xLabel = labelled(subject.parameter, parameterMeasure(subject.unit, units).unit);
    this.main.setAxes(xLabel, labelled('amplitude', amplitudeMeasure(units, scales).unit));
    this.lower.setAxes(xLabel, 'lag (\u00b0)');
    const [low, high] = this.stack.range;
    const inside = this.response.values.map((value) => value >= low && value <= high);
    const along = parameterMeasure(subject.unit, units).factor;
    const height = metreMeasures(units, scales).amplitude.factor;
    const most = Math.max(
      ...this.bands.map(({ band }) => height * largestOf(reachOfBand(band, [low / along, high / along]))),
      largestOf(this.response.amplitudes[2]!.filter((_, i) => inside[i])),
      largestOf(
        this.measured.flatMap(({ amplitudes }) =>
          amplitudes.filter(({ x }) => x >= low && x <= high).map(({ y }) => y),
        ),
      ),
    );
    this.main.show(this.stack.range, [0, 1.08 * most || 1]);
    this.lower.show(this.stack.range, [0, 360]);
    this.stack.redraw();
  }

  keys(): readonly Key[] {
    const probe = probeOf(this.subject!);
    const text = (angle: number) => `probe at ${written(angle, 4)}\u00b0`;
    return [
      lineKey('\u2501', 'x', text(probe), DASHES[0], colourOf(0)),
      lineKey('\u254d', 'y', text(probe + 90), DASHES[1], colourOf(1)),
      lineKey('\u2508', 'plain', 'major axis of the orbit', DASHES[2], colourOf(2)),
      markKey('\u25cb', 'plain', 'peak', 'ring', (colours) => colours.ink),
      ...this.bands.slice(0, 1).map(({ band }) => bandKey(band)),
      ...(this.measured.length > 0
        ? [markKey('\u25cf', 'plain', 'measured, in the colours of the probes', 'dot', (colours) => colours.ink)]
        : []),
    ];
  }

  picture(): Picture {
    return pictureOf(this.title, this.stack, this.keys());
  }

  table(): Table {
    const subject = this.subject!;
    const { rest, parameter, unit, units, scales } = subject;
    const amplitude = amplitudeMeasure(units, scales).unit;
    const [first, second] = [0, 90].map((more) => `probe at ${written(probeOf(subject) + more, 4)} deg`);
    const { values, points, amplitudes, lags } = this.response;
    const speed = parameterMeasure('rad/s', units);
    return {
      heading: [
        labelled(parameter, parameterMeasure(unit, units).unit),
        labelled('speed', speed.unit),
        `${first} (${amplitude})`,
        'its lag (deg)',
        `${second} (${amplitude})`,
        'its lag (deg)',
        `major axis (${amplitude})`,
      ],
      rows: values.map((value, i) => [
        value,
        rest.speed(points[i]!) * speed.factor,
        amplitudes[0]![i]!,
        lags[0]![i]!,
        amplitudes[1]![i]!,
        lags[1]![i]!,
        amplitudes[2]![i]!,
      ]),
    };
  }

  /// Draws quantiles of tolerances under the lines: of the major axis, and of the probes at their stored angles.
  private drawBands(pen: Pen, frame: Frame, colours: Theme): void {
    const { subject } = this;
    if (!subject) return;
    const { units, unit, scales } = subject;
    const factors = [parameterMeasure(unit, units).factor, metreMeasures(units, scales).amplitude.factor] as const;
    for (const { which, band } of this.bands) drawQuantiles(pen, frame, band, factors, colourOf(which)(colours));
  }

  /// Draws quantiles of lags under their lines. Bands go on beyond a whole turn, and are drawn a turn lower and higher,
  /// too.
  private drawLagBands(pen: Pen, frame: Frame, colours: Theme): void {
    const { subject } = this;
    if (!subject) return;
    const factors = [parameterMeasure(subject.unit, subject.units).factor, 1] as const;
    for (const { which, band } of this.lagBands)
      for (const turns of turnsOf(band))
        drawQuantiles(pen, frame, turned(band, 360 * turns), factors, colourOf(which)(colours));
  }

  private drawAmplitudes(pen: Pen, frame: Frame, colours: Theme): void {
    const { values, amplitudes } = this.response;
    for (const which of [0, 1, 2])
      strokeLine(pen, frame, values, amplitudes[which]!, colourOf(which)(colours), DASHES[which]!, Infinity);
    for (const { which, amplitudes: spots } of this.measured)
      drawMeasured(pen, frame, colours, spots, colourOf(which)(colours));
  }

  private drawPeaks(pen: Pen, frame: Frame, colours: Theme): void {
    const { values, amplitudes } = this.response;
    const size = textSize() * frame.ratio;
    const marks = peaksOf(amplitudes[0]!).map((i) => ({
      x: frame.x(values[i]!),
      y: frame.y(amplitudes[0]![i]!),
      text: shownWhole(values[i]!),
    }));
    const inside = marks.filter(({ x, y }) => isInside(frame, x, y));
    pen.strokeStyle = colours.ink;
    pen.lineWidth = 1.4 * frame.ratio;
    for (const { x, y } of inside) drawMark(pen, 'ring', x, y, 4 * frame.ratio);
    drawLabels(pen, inside, frame, size, colours);
  }

  private drawLags(pen: Pen, frame: Frame, colours: Theme): void {
    const { values, lags } = this.response;
    for (const which of [0, 1])
      strokeLine(pen, frame, values, lags[which]!, colourOf(which)(colours), DASHES[which]!, 180);
    for (const { which, lags: spots } of this.measured)
      drawMeasured(pen, frame, colours, spots, colourOf(which)(colours));
  }
}

/// Returns a band of angles, moved by some degrees.
function turned(band: StoredBand, by: number): StoredBand {
  const moved = (angle: number | null) => (angle === null ? null : angle + by);
  return {
    ...band,
    places: band.places.map(
      ([value, ...angles]) => [value, ...angles.map(moved)] as unknown as StoredBand['places'][number],
    ),
  };
}

/// Returns the turns by which a band of angles is moved so that some of it lies between 0 and 360 degrees.
export function turnsOf(band: StoredBand): readonly number[] {
  const reach = reachOfBand(band, [-Infinity, Infinity]);
  if (reach.length === 0) return [];
  const [low, high] = [-Math.floor(Math.max(...reach) / 360), 1 - Math.ceil(Math.min(...reach) / 360)];
  return Array.from({ length: Math.max(0, high - low + 1) }, (_, i) => low + i);
}

/// Draws a line that breaks at jumps of more than `most`.
function strokeLine(
  pen: Pen,
  frame: Frame,
  values: readonly number[],
  heights: readonly number[],
  colour: string,
  dash: readonly number[],
  most: number,
): void {
  pen.strokeStyle = colour;
  pen.lineWidth = 1.5 * frame.ratio;
  pen.setLineDash(dash.map((each) => each * frame.ratio));
  pen.beginPath();
  let down = false;
  heights.forEach((height, i) => {
    const there = Number.isFinite(height);
    if (i > 0 && Math.abs(height - heights[i - 1]!) > most) down = false;
    if (there) (down ? pen.lineTo : pen.moveTo).call(pen, frame.x(values[i]!), frame.y(height));
    down = there;
  });
  pen.stroke();
  pen.setLineDash([]);
}
