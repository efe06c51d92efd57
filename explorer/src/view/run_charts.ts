// A run over the time, and over the speed: pairs of charts whose cursors move together.
import { bandAt, type StoredBand } from '../data/bands';
import { FIELD } from '../data/fields';
import { SHAFT_TORQUES, type RunUp } from '../data/runup';
import { el, select, setChoices, type Choice } from '../dom';
import { Chart, type Frame, type Range } from '../figure/chart';
import type { Picture } from '../figure/figure';
import { drawMeasured, type Spot } from '../figure/measured';
import type { Pen } from '../figure/pen';
import { drawQuantiles, reachOfBand } from '../figure/quantiles';
import type { Theme } from '../figure/theme';
import { labelled, metreMeasures, parameterMeasure } from '../model/units';
import type { Table } from './panel';
import { bandKey, lineKey, markKey, pictureOf, type Key } from './rest_subject';
import { drawRows, motionMeasures, scaled, spanOf, type RunSubject } from './run_subject';
import { Stack, type StackListener } from './stack';

/// A line over the rows, in shown units.
export interface Curve {
  readonly text: string;
  readonly values: Float64Array;
  readonly dash: readonly number[];
  readonly colour: (colours: Theme) => string;
  /// Position of every value on the axis, for a curve with other rows than the run (torques); absent: values belong to
  /// the rows of the run that have a turn.
  readonly at?: Float64Array;
}

const DASHES = [[], [7, 4], [2, 3], [9, 3, 2, 3], [4, 2]] as const;
const COLOURS: readonly ((colours: Theme) => string)[] = [
  (colours) => colours.x,
  (colours) => colours.y,
  (colours) => colours.muted,
  (colours) => colours.ink,
  (colours) => colours.touch,
];
const SIGNS = ['\u2501', '\u254d', '\u2508', '\u2505', '\u254c'] as const;
const KINDS = ['x', 'y', 'plain', 'plain', 'unstable'] as const;

export function curve(text: string, values: Float64Array, index: number, at?: Float64Array): Curve {
  const style = index % COLOURS.length;
  return { text, values, dash: DASHES[style]!, colour: COLOURS[style]!, ...(at ? { at } : {}) };
}

/// Returns the rows of a curve that have values.
function rowsOf({ at }: Curve, run: RunUp): readonly number[] {
  return at ? Array.from(at.keys()) : run.rows;
}

export function keyOf({ text, dash, colour }: Curve, index: number): Key {
  const style = index % COLOURS.length;
  return lineKey(SIGNS[style]!, KINDS[style]!, text, dash, colour);
}

/// Returns the curves of a station: largest radius, and amplitudes of x and y at the speed; for a station that twists
/// its largest twist, and the twist's amplitude at the speed.
function motionCurves({ run, station, info, units, scales }: RunSubject): readonly Curve[] {
  const { length, amplitude } = motionMeasures(info, units, scales);
  const at = (axis: number) => scaled(run.column(FIELD.RUNUP_AMPLITUDE, station, axis), amplitude.factor);
  const largest = scaled(run.column(FIELD.RUNUP_RADIUS, station), length.factor);
  if (info.twists)
    return [curve(`twist at 1X (${amplitude.unit})`, at(0), 0), curve(`largest twist (${length.unit})`, largest, 1)];
  return [
    curve(`x at 1X (${amplitude.unit})`, at(0), 0),
    curve(`y at 1X (${amplitude.unit})`, at(1), 1),
    curve(`largest radius (${length.unit})`, largest, 2),
  ];
}

/// A band of tolerances of a curve of motionCurves, by its index.
interface CurveBand {
  readonly index: number;
  readonly band: StoredBand;
}

/// Returns the bands of a station over the time. Twists have none.
function motionBands({ bands, station, info }: RunSubject): readonly CurveBand[] {
  const places = [
    [FIELD.RUNUP_AMPLITUDE, 0],
    [FIELD.RUNUP_AMPLITUDE, 1],
    [FIELD.RUNUP_RADIUS, 0],
  ] as const;
  if (info.twists) return [];
  return places.flatMap(([field, column], index) => {
    const band = bandAt(bands, 'time', field, station, column);
    return band ? [{ index, band }] : [];
  });
}

/// Returns the factor from m to the shown unit of a band.
function bandFactor({ units, scales }: RunSubject, { index }: CurveBand): number {
  const { length, amplitude } = metreMeasures(units, scales);
  return (index < 2 ? amplitude : length).factor;
}

/// Returns the label of the chart of motions.
function motionLabel({ info, units, scales }: RunSubject): string {
  return labelled(info.twists ? 'twist' : 'motion', motionMeasures(info, units, scales).length.unit);
}

/// A quantity of the lower chart over the time.
interface Below {
  readonly id: string;
  readonly text: string;
  readonly axis: string;
  readonly curves: (subject: RunSubject) => readonly Curve[];
}

function belowOf({ run, units }: RunSubject): readonly Below[] {
  const speed = parameterMeasure('rad/s', units);
  const torque = parameterMeasure('N m', units);
  const each = (field: string) => (subject: RunSubject) =>
    run.contacts.map((name, i) => curve(name, subject.run.column(field, i), i));
  const contacts: readonly Below[] =
    run.contacts.length > 0
      ? [
          { id: 'force', text: 'Contact force', axis: 'normal force (N)', curves: each(FIELD.RUNUP_FORCE) },
          {
            id: 'share',
            text: 'Share of a turn in contact',
            axis: 'share of the turn',
            curves: each(FIELD.RUNUP_SHARE),
          },
        ]
      : [];
  return [
    {
      id: 'speed',
      text: 'Speed',
      axis: labelled('speed', speed.unit),
      curves: (subject) => [curve('speed', scaled(subject.run.speed, speed.factor), 0)],
    },
    ...contacts,
    {
      id: 'torque',
      text: 'Torques on the shaft',
      axis: labelled('torque', torque.unit),
      curves: (subject) =>
        SHAFT_TORQUES.map((name, i) =>
          curve(name, scaled(subject.run.column(FIELD.RUNUP_TORQUE, 0, i), torque.factor), i),
        ),
    },
    ...run.torques.map(({ name }, i) => ({
      id: `torque-${i}`,
      text: `Torque: ${name}`,
      axis: labelled('torque', torque.unit),
      curves: (subject: RunSubject) => {
        const own = subject.run.torques[i];
        const at = subject.run.torqueTimes;
        return own
          ? [
              curve('largest in the row', scaled(own.largest, torque.factor), 0, at),
              curve('least', scaled(own.least, torque.factor), 1, at),
            ]
          : [];
      },
    })),
    ...(run.torques.length > 0
      ? [
          {
            id: 'speeds',
            text: 'Speeds of the stations',
            axis: labelled('speed', speed.unit),
            curves: (subject: RunSubject) =>
              subject.run.stations.map(({ name }, i) =>
                curve(
                  name,
                  scaled(subject.run.column(FIELD.RUNUP_STATION_SPEED, i), speed.factor),
                  i,
                  subject.run.torqueTimes,
                ),
              ),
          },
        ]
      : []),
  ];
}

export interface RunChart {
  readonly title: string;
  readonly stack: Stack;
  readonly tools: readonly HTMLElement[];
  /// Shows a run within a range of the axis (SI).
  show(subject: RunSubject, range: Range): void;
  /// The whole range of the axis in SI.
  whole(run: RunUp): Range;
  /// Moves the cursor; the lines stay.
  cursor(subject: RunSubject): void;
  keys(): readonly Key[];
  picture(): Picture;
  table(): Table;
}

interface MeasuredSpots {
  readonly axis: number;
  readonly spots: readonly Spot[];
}

abstract class RunPair implements RunChart {
  readonly stack: Stack;
  protected readonly main: Chart;
  protected readonly lower: Chart;
  protected subject: RunSubject | undefined;
  protected upperCurves: readonly Curve[] = [];
  protected lowerCurves: readonly Curve[] = [];
  abstract readonly tools: readonly HTMLElement[];
  /// Dot at the cursor's row on the first line, as the run may pass a speed several times.
  private readonly dot = el('div', { class: 'run-dot', hidden: true });

  constructor(
    readonly title: string,
    private readonly parameter: string,
    private readonly unit: string,
    upper: string,
    lower: string,
    listener: StackListener,
    walk: (subject: RunSubject, value: number, steps: number) => number,
  ) {
    this.main = new Chart({
      title: upper,
      bareX: true,
      under: (pen, frame, colours) => {
        this.drawBands(pen, frame, colours);
        this.drawUnder(pen, frame, colours);
      },
      over: (pen, frame, colours) => {
        this.draw(pen, frame, colours, this.upperCurves, Infinity);
        this.drawMeasured(pen, frame, colours, false);
      },
    });
    this.lower = new Chart({
      title: lower,
      ...(parameter === 'speed' ? { yTicks: [0, 90, 180, 270, 360] } : {}),
      under: (pen, frame, colours) => this.drawUnder(pen, frame, colours),
      over: (pen, frame, colours) => {
        this.draw(pen, frame, colours, this.lowerCurves, parameter === 'speed' ? 180 : Infinity);
        this.drawMeasured(pen, frame, colours, true);
      },
    });
    this.main.overlay.append(this.dot);
    this.stack = new Stack(this.main, this.lower, listener, (value, steps) =>
      this.subject ? walk(this.subject, value, steps) : value,
    );
  }

  /// Returns the values on the axis in shown units, by rows.
  protected abstract along(subject: RunSubject): Float64Array;
  /// Returns measured amplitudes, or lags, of x (axis 0) and y (axis 1) in shown units.
  protected measuredOf(_subject: RunSubject, _lag: boolean): readonly MeasuredSpots[] {
    return [];
  }

  /// Returns the bands of the upper curves.
  protected bandsOf(_subject: RunSubject): readonly CurveBand[] {
    return [];
  }

  private drawBands(pen: Pen, frame: Frame, colours: Theme): void {
    const { subject } = this;
    for (const own of subject ? this.bandsOf(subject) : [])
      drawQuantiles(pen, frame, own.band, [1, bandFactor(subject!, own)], COLOURS[own.index]!(colours));
  }

  private drawMeasured(pen: Pen, frame: Frame, colours: Theme, lag: boolean): void {
    for (const { axis, spots } of this.subject ? this.measuredOf(this.subject, lag) : [])
      drawMeasured(pen, frame, colours, spots, COLOURS[axis]!(colours));
  }

  /// Draws what is below the lines.
  protected drawUnder(_pen: Pen, _frame: Frame, _colours: Theme): void {}
  abstract whole(run: RunUp): Range;
  /// Returns the value of the cursor on the axis, in SI.
  protected abstract placeOf(subject: RunSubject): number;

  cursor(subject: RunSubject): void {
    this.subject = subject;
    this.stack.setCursors(this.placeOf(subject), NaN, wordsOf(subject));
    const [x, y] = [this.along(subject)[subject.row] ?? NaN, this.upperCurves[0]?.values[subject.row] ?? NaN];
    this.dot.hidden = !(this.main.isSeen(x, 'x') && this.main.isSeen(y, 'y'));
    this.dot.style.transform = `translate(${this.main.placeOf(x)}px, ${this.main.heightOf(y)}px)`;
  }

  protected showPair(subject: RunSubject, range: Range, upper: string, lower: string, lag: boolean): void {
    const { units, name, station } = subject;
    this.subject = subject;
    this.stack.show({ name, parameter: this.parameter, unit: this.unit, units, range }, station, lower);
    const xLabel = labelled(this.parameter, parameterMeasure(this.unit, units).unit);
    this.main.setAxes(xLabel, upper);
    this.lower.setAxes(xLabel, lower);
    const shownRows = (curves: readonly Curve[]) =>
      curves.map((own) => rowsOf(own, subject.run).map((row) => own.values[row]!));
    const spots = this.measuredOf(subject, false).map((each) => each.spots.map(({ y }) => y));
    const reaches = this.bandsOf(subject).map((own) =>
      reachOfBand(own.band, range).map((value) => value * bandFactor(subject, own)),
    );
    this.main.show(this.stack.range, spanOf([...shownRows(this.upperCurves), ...spots, ...reaches]));
    this.lower.show(this.stack.range, lag ? [0, 360] : spanOf(shownRows(this.lowerCurves)));
    this.stack.redraw();
  }

  abstract show(subject: RunSubject, range: Range): void;

  private draw(pen: Pen, frame: Frame, colours: Theme, curves: readonly Curve[], jump: number): void {
    const { subject } = this;
    if (!subject) return;
    const xs = this.along(subject);
    for (const own of [...curves].reverse())
      drawRows(
        pen,
        frame,
        own.at ?? xs,
        own.values,
        rowsOf(own, subject.run),
        { colour: own.colour(colours), dash: own.dash },
        jump,
      );
  }

  keys(): readonly Key[] {
    const lower = this.lowerCurves.length > 1 && this.parameter === 'time' ? this.lowerCurves : [];
    const measured = this.subject && this.measuredOf(this.subject, false).length > 0;
    const dots = markKey('\u25cf', 'plain', 'measured 1X, in the colours of x and y', 'dot', (colours) => colours.ink);
    const bands = this.subject ? this.bandsOf(this.subject) : [];
    const shades = bands.slice(0, 1).map(({ band }) => bandKey(band));
    return [...this.upperCurves.map(keyOf), ...lower.map(keyOf), ...(measured ? [dots] : []), ...shades];
  }

  picture(): Picture {
    return pictureOf(this.title, this.stack, this.keys());
  }

  table(): Table {
    const subject = this.subject!;
    const { run, units } = subject;
    const speed = parameterMeasure('rad/s', units);
    const curves = [...this.upperCurves, ...this.lowerCurves];
    const at = curves.find((own) => own.at)?.at;
    return {
      heading: ['time (s)', labelled('speed', speed.unit), 'turns', ...curves.map(({ text }) => text)],
      rows: (at ? Array.from(at.keys()) : run.rows).map((row) => [
        at?.[row] ?? run.time[row]!,
        run.speed[row]! * speed.factor,
        run.column(FIELD.RUNUP_TURNS)[row]!,
        ...curves.map(({ values }) => values[row]!),
      ]),
    };
  }
}

/// Draws lines at instants of events.
function drawEvents(pen: Pen, frame: Frame, colours: Theme, events: readonly number[]): void {
  pen.strokeStyle = colours.touch;
  pen.lineWidth = frame.ratio;
  pen.setLineDash([3 * frame.ratio, 3 * frame.ratio]);
  for (const at of events) {
    pen.beginPath();
    pen.moveTo(frame.x(at), frame.top);
    pen.lineTo(frame.x(at), frame.top + frame.height);
    pen.stroke();
  }
  pen.setLineDash([]);
}

export class RunOverTime extends RunPair {
  readonly tools: readonly HTMLElement[];
  private readonly station: HTMLSelectElement;
  private readonly below: HTMLSelectElement;
  private chosen = 'speed';
  private range: Range = [0, 1];

  constructor(listener: StackListener & { station(index: number): void }) {
    super(
      'The run over the time',
      'time',
      's',
      'Amplitude over the time',
      'Speed over the time',
      listener,
      (subject, value, steps) => stepped(subject, value, steps),
    );
    this.station = select('Station', [], '', (value) => listener.station(Number(value)));
    this.below = select('What the lower chart shows', [], '', (value) => {
      this.chosen = value;
      if (this.subject) this.show(this.subject, this.range);
      this.changed?.();
    });
    this.tools = [this.station, this.below];
  }

  /// Called after the user chose another quantity.
  changed?: () => void;

  show(subject: RunSubject, range: Range): void {
    const { run } = subject;
    const choices = belowOf(subject);
    const below = choices.find(({ id }) => id === this.chosen) ?? choices[0]!;
    this.range = range;
    setSame(
      this.station,
      run.stations.map(({ name }, i) => ({ value: String(i), text: name })),
      String(subject.station),
    );
    this.station.hidden = run.stations.length < 2;
    setSame(
      this.below,
      choices.map(({ id, text }) => ({ value: id, text })),
      below.id,
    );
    this.upperCurves = motionCurves(subject);
    this.lowerCurves = below.curves(subject);
    this.showPair(subject, range, motionLabel(subject), below.axis, false);
  }

  whole(run: RunUp): Range {
    return [0, run.duration > 0 ? run.duration : 1];
  }

  protected placeOf({ time }: RunSubject): number {
    return time;
  }

  protected along({ run }: RunSubject): Float64Array {
    return run.time;
  }

  protected override bandsOf(subject: RunSubject): readonly CurveBand[] {
    return motionBands(subject);
  }

  protected override drawUnder(pen: Pen, frame: Frame, colours: Theme): void {
    drawEvents(pen, frame, colours, this.subject?.run.events ?? []);
  }
}

export class RunOverSpeed extends RunPair {
  readonly tools: readonly HTMLElement[] = [];

  constructor(listener: StackListener) {
    super(
      'The run over the speed',
      'speed',
      'rad/s',
      'Amplitude over the speed',
      'Lag over the speed',
      listener,
      (subject, _, steps) => {
        const { rows } = subject.run;
        const at = rows.indexOf(subject.row) + steps;
        return subject.run.speed[rows[Math.min(rows.length - 1, Math.max(0, at))] ?? -1] ?? NaN;
      },
    );
  }

  show(subject: RunSubject, range: Range): void {
    const { run, station, info } = subject;
    const lag = (axis: number) => run.column(FIELD.RUNUP_LAG, station, axis);
    this.upperCurves = motionCurves(subject);
    this.lowerCurves = info.twists
      ? [curve('lag of the twist (\u00b0)', lag(0), 0)]
      : [curve('lag of x (\u00b0)', lag(0), 0), curve('lag of y (\u00b0)', lag(1), 1)];
    this.showPair(subject, range, motionLabel(subject), 'lag at 1X (\u00b0)', true);
  }

  protected override measuredOf({ measured, station, units, scales }: RunSubject, lag: boolean) {
    const speed = parameterMeasure('rad/s', units);
    const { amplitude } = metreMeasures(units, scales);
    return measured.flatMap((data) =>
      [0, 1].flatMap((axis) => {
        const seen = data.kind === 'vectors' && !data.parameter ? data.seen(station, 90 * axis) : undefined;
        const heights = lag ? seen?.lags : seen?.amplitudes.map((each) => each * amplitude.factor);
        return seen && heights ? [{ axis, spots: heights.map((y, i) => ({ x: seen.at[i]! * speed.factor, y })) }] : [];
      }),
    );
  }

  whole(run: RunUp): Range {
    const speeds = run.rows.map((row) => run.speed[row]!);
    const high = Math.max(0, ...speeds);
    return [0, high > 0 ? 1.02 * high : 1];
  }

  protected placeOf({ run, row }: RunSubject): number {
    return run.speed[row] ?? NaN;
  }

  protected along({ run, units }: RunSubject): Float64Array {
    return scaled(run.speed, parameterMeasure('rad/s', units).factor);
  }
}

/// Returns the time `steps` rows from a time.
function stepped({ run }: RunSubject, time: number, steps: number): number {
  const at = run.rows.indexOf(run.rowAt(time)) + steps;
  return run.time[run.rows[Math.min(run.rows.length - 1, Math.max(0, at))] ?? -1] ?? time;
}

/// Returns the text of the slider in addition to its value.
function wordsOf({ run, row, station, info, units, scales }: RunSubject): string {
  if (row < 0) return '';
  const { factor, unit } = motionMeasures(info, units, scales).amplitude;
  const speed = parameterMeasure('rad/s', units);
  const size = (run.column(FIELD.RUNUP_AMPLITUDE, station, 0)[row] ?? NaN) * factor;
  const at = `${run.time[row]!.toPrecision(4)} s, ${(run.speed[row]! * speed.factor).toPrecision(4)} ${speed.unit}`;
  return `${at}, ${info.twists ? 'twist' : 'x'} ${size.toPrecision(3)} ${unit}`;
}

/// Sets the choices of a list, unless they are the same.
export function setSame(list: HTMLSelectElement, choices: readonly Choice[], value: string): void {
  const same =
    choices.length === list.options.length && choices.every((each, i) => list.options[i]!.text === each.text);
  if (!same) setChoices(list, choices, value);
  list.value = value;
}
