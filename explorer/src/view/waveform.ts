// The waveform: both probes over the last revolutions, with the once-per-revolution marks.
import { alignment } from '../data/measured';
import { Chart, type Frame } from '../figure/chart';
import { drawMeasured } from '../figure/measured';
import type { Pen } from '../figure/pen';
import type { Theme } from '../figure/theme';
import { lengthMeasure, shown, type Measure } from '../model/units';
import { measuredKeys, Panel, type Subject, type Table } from './panel';

/// Returns the revolutions shown: two periods and at least 4; 12 for motions without a period.
function revolutionsShown(period: number, available: number): number {
  return Math.min(available, period > 0 ? Math.max(4, 2 * period) : 12);
}

interface MeasuredTrace {
  /// 0: x, 1: y.
  readonly axis: number;
  readonly x: readonly number[];
  readonly y: readonly number[];
}

export class WaveformPanel extends Panel {
  readonly figure = new Chart({
    title: 'Waveform',
    lines: [
      { label: 'x', colour: (colours) => colours.x },
      { label: 'y', colour: (colours) => colours.y },
    ],
    over: (pen, frame, colours) => this.drawMarks(pen, frame, colours),
  });
  private time = new Float64Array(0);
  /// Measured samples in shown units.
  private measured: readonly MeasuredTrace[] = [];
  private traces: readonly [Float64Array, Float64Array] = [this.time, this.time];

  constructor() {
    super('waveform', 'Waveform');
    this.assemble();
  }

  protected refresh(): void {
    const subject = this.subject!;
    const { motion, station, units, scales } = subject;
    const length = lengthMeasure(units, scales);
    const wave = motion?.waveform(station) ?? { x: new Float64Array(0), y: new Float64Array(0) };
    const per = motion?.samplesPerRevolution ?? 1;
    const revolutions = revolutionsShown(motion?.period ?? 0, Math.floor(wave.x.length / per));
    // Include one sample more: the mark at which the first revolution begins.
    const first = Math.max(0, wave.x.length - revolutions * per - 1);
    const unit = this.timeUnit(subject);
    this.time = Float64Array.from(
      { length: wave.x.length - first },
      (_, i) => ((i + first + 1) / per - wave.x.length / per + revolutions) * unit.factor,
    );
    const shownPart = (values: Float64Array) => values.slice(first).map((value) => value * length.factor);
    this.traces = [shownPart(wave.x), shownPart(wave.y)];
    const differences = this.placeMeasured(subject, Math.max(revolutions, 1), unit.factor, length);
    let [low, high] = [Infinity, -Infinity];
    for (const { y } of this.measured)
      for (const value of y) [low, high] = [Math.min(low, value), Math.max(high, value)];
    for (const trace of this.traces)
      for (const value of trace) {
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
    if (!(low <= high)) [low, high] = [-1, 1];
    const room = 0.06 * (high - low) || 1;
    this.figure.setAxes(unit.label, `displacement (${length.unit})`);
    this.figure.show(
      [0, Math.max(revolutions, 1) * unit.factor],
      [low - room, high + room],
      [this.time, ...this.traces],
    );
    this.note.replaceChildren(
      key('x', 'key-x'),
      key('y', 'key-y'),
      key('once per revolution', 'key-mark'),
      ...measuredKeys(subject.measured, differences),
    );
  }

  /// Places the measured samples on the axis: those of a periodic motion where they differ least from it. Returns texts
  /// of the differences.
  private placeMeasured(subject: Subject, revolutions: number, turn: number, length: Measure): string[] {
    const { motion, station, measured } = subject;
    const period = motion && Number.isInteger(motion.period) ? motion.period : 0;
    const traces: MeasuredTrace[] = [];
    const texts = measured.map((each) => {
      const { moved, rms } =
        period > 0
          ? alignment(each, motion!.waveform(station), motion!.samplesPerRevolution, period)
          : { moved: 0, rms: NaN };
      // The first whole revolution of the record is the first one of the picture.
      const first = Math.floor(each.turns[0] ?? 0);
      const begin = period > 0 ? moved + Math.floor(first / period) * period - first : -first;
      for (const [axis, values] of [each.x, each.y].entries()) {
        if (!values) continue;
        const shownTurns = Array.from(each.turns.keys()).filter((i) => {
          const at = each.turns[i]! + begin;
          return at >= 0 && at <= revolutions;
        });
        traces.push({
          axis,
          x: shownTurns.map((i) => (each.turns[i]! + begin) * turn),
          y: shownTurns.map((i) => values[i]! * length.factor),
        });
      }
      return Number.isFinite(rms) ? `differs by ${shown(rms * length.factor, 3)} ${length.unit} rms` : '';
    });
    this.measured = traces;
    return texts;
  }

  protected table(): Table {
    const { units, scales } = this.subject!;
    const { unit } = lengthMeasure(units, scales);
    return {
      heading: [this.timeUnit(this.subject!).heading, `x [${unit}]`, `y [${unit}]`],
      rows: Array.from(this.time, (time, i) => [time, this.traces[0][i]!, this.traces[1][i]!]),
    };
  }

  private timeUnit({ units, scales }: Subject): { factor: number; label: string; heading: string } {
    return units.frequency !== 'order'
      ? { factor: (2 * Math.PI * 1e3) / scales.speed, label: 'time (ms)', heading: 'time [ms]' }
      : { factor: 1, label: 'revolutions', heading: 'revolution' };
  }

  private drawMarks(pen: Pen, frame: Frame, colours: Theme): void {
    for (const { axis, x, y } of this.measured)
      drawMeasured(
        pen,
        frame,
        colours,
        x.map((at, i) => ({ x: at, y: y[i]! })),
        axis === 0 ? colours.x : colours.y,
      );
    const per = this.subject?.motion?.samplesPerRevolution;
    if (!per) return;
    const radius = 3 * frame.ratio;
    pen.fillStyle = colours.keyphasor;
    pen.beginPath();
    for (let mark = this.time.length - 1; mark >= 0; mark -= per)
      for (const trace of this.traces) {
        const [x, y] = [frame.x(this.time[mark]!), frame.y(trace[mark]!)];
        pen.moveTo(x + radius, y);
        pen.arc(x, y, radius, 0, 2 * Math.PI);
      }
    pen.fill();
  }
}

/// Makes an entry of a legend: a swatch and a text.
export function key(text: string, kind: string): HTMLElement {
  const entry = document.createElement('span');
  entry.className = `key ${kind}`;
  entry.textContent = text;
  return entry;
}
