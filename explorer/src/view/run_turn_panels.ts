// Panels of one turn of a run at its cursor: the motion of the station, forces and gaps of contacts, and torques, over
// the time since the mark or over the angle of the shaft.
import type { RunTurn } from '../data/runup';
import { select } from '../dom';
import { Chart, drawZero, type Frame } from '../figure/chart';
import type { Pen } from '../figure/pen';
import type { Theme } from '../figure/theme';
import { labelled, parameterMeasure, type Units } from '../model/units';
import { Panel, type Table } from './panel';
import { keyElements } from './rest_subject';
import { curve, keyOf, setSame, type Curve } from './run_charts';
import { placeText } from './run_panels';
import { drawRows, motionMeasures, scaled, spanOf, type RunSubject } from './run_subject';
import { key } from './waveform';

/// The curves of a panel, in shown units, at equal angles of a turn from the mark on.
interface TurnCurves {
  /// Time of the middle of the turn (s), and its speed (rad/s).
  readonly time: number;
  readonly speed: number;
  /// Time of every instant since the beginning of the turn, s.
  readonly instants: Float64Array;
  readonly axis: string;
  readonly curves: readonly Curve[];
  /// Remark for the user; "" for none.
  readonly remark: string;
}

/// Returns true if the axis of turns is the time, false if it is the angle.
function isByTime({ frequency }: Units): boolean {
  return frequency !== 'order';
}

export abstract class TurnPanel extends Panel<RunSubject> {
  readonly figure: Chart;
  private shown: TurnCurves | undefined;
  private at = new Float64Array(0);

  constructor(name: string, title: string) {
    super(name, title);
    this.figure = new Chart({ title, over: (pen, frame, colours) => this.draw(pen, frame, colours) });
  }

  /// Returns true if runs like this one have what the panel shows.
  abstract shows(subject: RunSubject): boolean;
  protected abstract find(subject: RunSubject): TurnCurves | undefined;

  protected refresh(): void {
    const subject = this.subject!;
    const of = (this.shown = this.find(subject));
    const byTime = isByTime(subject.units);
    const count = of?.instants.length ?? 0;
    this.at = Float64Array.from({ length: count }, (_, i) => (byTime ? 1e3 * of!.instants[i]! : (360 * i) / count));
    const end = byTime ? (of ? (2e3 * Math.PI) / of.speed : 1) : 360;
    this.figure.setAxes(byTime ? 'time from the mark (ms)' : 'angle from the mark (\u00b0)', of?.axis ?? '');
    this.figure.show([0, end], spanOf(of?.curves.map(({ values }) => values) ?? [], false));
    const place = of ? placeText(subject, of.time, of.speed) : 'no samples of this turn are stored: Compute shows it';
    const first = subject.row < 0;
    this.note.replaceChildren(
      document.createTextNode(first ? placeText(subject, NaN, NaN) : place),
      ...keyElements(of?.curves.map(keyOf) ?? []),
      ...(of ? [key('at the mark', 'key-mark')] : []),
      ...(of?.remark ? [document.createTextNode(of.remark)] : []),
    );
    this.figure.redraw();
  }

  protected table(): Table {
    const { shown: of } = this;
    const { instants, curves } = of ?? { instants: new Float64Array(0), curves: [] };
    return {
      heading: ['angle [\u00b0]', 'time from the mark [s]', ...curves.map(({ text }) => text)],
      rows: Array.from(instants, (time, i) => [
        (360 * i) / instants.length,
        time,
        ...curves.map(({ values }) => values[i]!),
      ]),
    };
  }

  private draw(pen: Pen, frame: Frame, colours: Theme): void {
    const { shown: of, at } = this;
    if (!of) return;
    drawZero(pen, frame, colours.frame);
    const rows = Array.from(at.keys());
    for (const { values, colour, dash } of [...of.curves].reverse())
      drawRows(pen, frame, at, values, rows, { colour: colour(colours), dash });
    pen.fillStyle = colours.keyphasor;
    pen.beginPath();
    for (const { values } of of.curves) {
      const [x, y, radius] = [frame.x(at[0]!), frame.y(values[0]!), 3 * frame.ratio];
      pen.moveTo(x + radius, y);
      pen.arc(x, y, radius, 0, 2 * Math.PI);
    }
    pen.fill();
  }
}

/// The displacements of the station, or its twist. Without samples it shows the sum of the mean and of orders 1 to 4.
export class TurnMotionPanel extends TurnPanel {
  constructor() {
    super('run-motion', 'Motion in the turn');
    this.assemble();
  }

  shows(): boolean {
    return true;
  }

  protected find({ run, station, time, info, units, scales }: RunSubject): TurnCurves | undefined {
    const orbit = run.orbitAt(station, time);
    if (!orbit) return undefined;
    const { factor, unit } = motionMeasures(info, units, scales).length;
    const count = orbit.x.length;
    const turn = orbit.sampled ? run.turnAt(time) : undefined;
    const even = () => Float64Array.from({ length: count }, (_, i) => ((i / count) * 2 * Math.PI) / orbit.speed);
    const [x, y] = [scaled(orbit.x, factor), scaled(orbit.y, factor)];
    return {
      ...{ time: orbit.time, speed: orbit.speed, instants: turn?.instants ?? even() },
      axis: labelled(info.twists ? 'twist' : 'displacement', unit),
      curves: info.twists ? [curve(`twist (${unit})`, x, 0)] : [curve(`x (${unit})`, x, 0), curve(`y (${unit})`, y, 1)],
      remark: orbit.sampled ? '' : 'the sum of orders 1 to 4',
    };
  }
}

/// Numbers of every contact over the turn.
abstract class TurnContactsPanel extends TurnPanel {
  protected abstract readonly quantity: string;
  protected abstract valuesOf(turn: RunTurn): readonly Float64Array[];
  protected abstract measureOf(subject: RunSubject): { readonly factor: number; readonly unit: string };

  shows({ run }: RunSubject): boolean {
    return run.contacts.length > 0;
  }

  protected find(subject: RunSubject): TurnCurves | undefined {
    const turn = subject.run.turnAt(subject.time);
    if (!turn) return undefined;
    const { factor, unit } = this.measureOf(subject);
    const values = this.valuesOf(turn);
    return {
      ...turn,
      axis: labelled(this.quantity, unit),
      curves: subject.run.contacts.map((name, i) => curve(`${name} (${unit})`, scaled(values[i]!, factor), i)),
      remark: '',
    };
  }
}

export class TurnForcePanel extends TurnContactsPanel {
  protected readonly quantity = 'normal force';

  constructor() {
    super('run-force', 'Contact force in the turn');
    this.assemble();
  }

  protected valuesOf({ forces }: RunTurn): readonly Float64Array[] {
    return forces;
  }

  protected measureOf({ units }: RunSubject): { readonly factor: number; readonly unit: string } {
    return parameterMeasure('N', units);
  }
}

export class TurnGapPanel extends TurnContactsPanel {
  protected readonly quantity = 'gap';

  constructor() {
    super('run-gap', 'Gap in the turn');
    this.assemble();
  }

  protected valuesOf({ gaps }: RunTurn): readonly Float64Array[] {
    return gaps;
  }

  protected measureOf({ info, units, scales }: RunSubject): { readonly factor: number; readonly unit: string } {
    return motionMeasures({ ...info, twists: false }, units, scales).length;
  }
}

/// Torques of a shaft that a drive turns; the user chooses those on the shaft, or that of one motor, coupling or shaft.
export class TurnTorquePanel extends TurnPanel {
  private readonly which = select('Torques', [], '', (value) => {
    this.chosen = value;
    if (this.subject) this.refresh();
  });
  private chosen = '';

  constructor() {
    super('run-torque', 'Torques in the turn');
    this.assemble(this.which);
  }

  shows({ run }: RunSubject): boolean {
    return run.driven || run.shaftNames.length > 0;
  }

  protected override refresh(): void {
    const { run } = this.subject!;
    const choices = [
      { value: '', text: 'On the shaft' },
      ...run.shaftNames.map((name) => ({ value: name, text: `On the ${name}` })),
      ...run.torques.map(({ name }) => ({ value: name, text: name })),
    ];
    if (choices.every(({ value }) => value !== this.chosen)) this.chosen = '';
    setSame(this.which, choices, this.chosen);
    this.which.hidden = choices.length < 2;
    super.refresh();
  }

  protected find({ run, time, units }: RunSubject): TurnCurves | undefined {
    const turn = run.turnAt(time);
    if (!turn) return undefined;
    const { factor, unit } = parameterMeasure('N m', units);
    const own = new Set(run.torques.map(({ name }) => name));
    // Leave out torques on the shaft that are 0 throughout the turn.
    const shaft = turn.shafts.find(({ name }) => name === this.chosen);
    const shown =
      shaft?.torques ??
      turn.torques.filter(({ name, values }) =>
        this.chosen ? name === this.chosen : !own.has(name) && values.some((value) => value !== 0),
      );
    return {
      ...turn,
      axis: labelled('torque', unit),
      curves: shown.map(({ name, values }, i) => curve(`${name} (${unit})`, scaled(values, factor), i)),
      remark: shown.length > 0 ? '' : 'no torques',
    };
  }
}
