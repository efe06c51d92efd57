// Pictures of a run at its cursor: the orbit of the turn, the nearest spectrum, and the place of the spectrum in the
// waterfall.
import type { RunOrbit } from '../data/runup';
import { button } from '../dom';
import { Chart, type Frame } from '../figure/chart';
import type { Pen } from '../figure/pen';
import { drawPlane, extent, type Plane } from '../figure/plane';
import { Round } from '../figure/round';
import type { Theme } from '../figure/theme';
import { tickText } from '../figure/ticks';
import { amplitudeMeasure, lengthMeasure, parameterMeasure, shown, type Units } from '../model/units';
import { Panel, type Table } from './panel';
import { scaled, type RunSubject } from './run_subject';
import { key } from './waveform';

export function placeText({ run, row, units }: RunSubject, time: number, speed: number): string {
  const measure = parameterMeasure('rad/s', units);
  return row < 0 || run.rows.length === 0
    ? 'the first turn is not complete yet'
    : `${shown(time, 5)} s, ${shown(speed * measure.factor, 5)} ${measure.unit}`;
}

/// The orbit of the last turn before the cursor, with the keyphasor's dot and the walls.
export class RunOrbitPanel extends Panel<RunSubject> {
  readonly figure = new Round('Orbit', (pen, width, height, colours) => this.draw(pen, width, height, colours));
  private orbit: RunOrbit | undefined;
  private whole = true;

  constructor() {
    super('run-orbit', 'Orbit at the cursor');
    const zoom = button(
      '\u2922',
      'Fit the orbit, or show the walls around it',
      () => {
        this.whole = !this.whole;
        zoom.setAttribute('aria-pressed', String(!this.whole));
        this.figure.redraw();
      },
      { class: 'icon', 'aria-pressed': 'false' },
    );
    this.assemble(zoom);
  }

  protected refresh(): void {
    const subject = this.subject!;
    const { run, station, time } = subject;
    this.orbit = run.orbitAt(station, time);
    const of = this.orbit;
    this.note.replaceChildren(
      document.createTextNode(of ? placeText(subject, of.time, of.speed) : placeText(subject, NaN, NaN)),
      key('at the mark', 'key-mark'),
      ...(of && !of.sampled ? [document.createTextNode('the sum of orders 1 to 4')] : []),
    );
    this.figure.description = this.note.textContent ?? '';
    this.figure.redraw();
  }

  protected table(): Table {
    const { units, scales } = this.subject!;
    const { factor, unit } = lengthMeasure(units, scales);
    const { x, y } = this.orbit ?? { x: new Float64Array(0), y: new Float64Array(0) };
    return {
      heading: ['share of the turn', `x [${unit}]`, `y [${unit}]`],
      rows: Array.from(x, (value, i) => [i / x.length, value * factor, y[i]! * factor]),
    };
  }

  private draw(pen: Pen, width: number, height: number, colours: Theme): void {
    const { subject, orbit } = this;
    if (!subject || !orbit) return;
    const { factor, unit } = lengthMeasure(subject.units, subject.scales);
    const [x, y] = [scaled(orbit.x, factor), scaled(orbit.y, factor)];
    const radius = x.reduce((most, value, i) => Math.max(most, Math.hypot(value, y[i]!)), 0);
    const walls = [subject.info.gap, subject.info.clearance].map((wall) => wall * factor);
    // Leave out walls that are far away, with which the orbit would be too small.
    const near = walls.filter((wall) => wall > 0 && wall < 3 * radius);
    const reach = 1.04 * Math.max(radius, ...near, 1e-300);
    const names = [`x (${unit})`, `y (${unit})`] as const;
    const around = { centre: 0, half: reach };
    const extents = this.whole
      ? ([around, around] as const)
      : ([extent(x, 1e-3 * reach), extent(y, 1e-3 * reach)] as const);
    const plane = drawPlane(pen, [width, height], extents, true, names, colours);
    pen.save();
    pen.beginPath();
    pen.rect(plane.area.left, plane.area.top, plane.area.width, plane.area.height);
    pen.clip();
    walls.forEach((wall, i) => drawWall(pen, plane, wall, i === 0 ? colours.stator : colours.clearance));
    drawTurn(pen, plane, x, y, colours);
    pen.restore();
  }
}

function drawWall(pen: Pen, { x, y }: Plane, radius: number, colour: string): void {
  if (!(radius > 0)) return;
  pen.strokeStyle = colour;
  pen.lineWidth = 2;
  pen.beginPath();
  pen.moveTo(x(radius), y(0));
  pen.arc(x(0), y(0), x(radius) - x(0), 0, 2 * Math.PI);
  pen.stroke();
}

/// Draws one turn from the mark on, with a gap before it that shows the direction, and a dot at the mark.
function drawTurn(pen: Pen, plane: Plane, x: Float64Array, y: Float64Array, colours: Theme): void {
  const last = x.length - Math.max(1, Math.round(x.length / 28));
  pen.strokeStyle = colours.a;
  pen.lineWidth = 1.6;
  pen.lineJoin = 'round';
  pen.beginPath();
  for (let i = 0; i <= last; i++) (i > 0 ? pen.lineTo : pen.moveTo).call(pen, plane.x(x[i]!), plane.y(y[i]!));
  pen.stroke();
  pen.fillStyle = colours.keyphasor;
  pen.beginPath();
  pen.arc(plane.x(x[0]!), plane.y(y[0]!), 4.5, 0, 2 * Math.PI);
  pen.fill();
}

/// Returns the measure of orders at a speed: orders, or Hz.
function frequencyOf(units: Units, speed: number): { readonly factor: number; readonly unit: string } {
  if (units.frequency === 'order') return { factor: 1, unit: 'orders' };
  const own = (units.frequency === 'own' && units.shown?.frequency) || { unit: 'Hz', size: 1 };
  return { factor: speed / (2 * Math.PI * own.size), unit: own.unit };
}

const forwardText = (value: number, step: number) => tickText(Math.abs(value), step);

/// The full spectrum that is nearest to the cursor.
export class RunSpectrumPanel extends Panel<RunSubject> {
  readonly figure = new Chart({
    title: 'Spectrum',
    lines: [{ label: 'x + iy', colour: (colours) => colours.a, width: 1.5 }],
    xText: forwardText,
  });
  private lines: readonly [Float64Array, Float64Array] = [new Float64Array(0), new Float64Array(0)];

  constructor() {
    super('run-spectrum', 'Spectrum at the cursor');
    this.assemble();
  }

  protected refresh(): void {
    const subject = this.subject!;
    const { run, station, time, units, scales } = subject;
    const index = run.spectrumNear(time);
    const of = run.spectrum(station, Math.max(index, 0));
    const frequency = frequencyOf(units, of.speed);
    const amplitude = amplitudeMeasure(units, scales);
    const bins = index < 0 ? 0 : of.order.length;
    // Place backward whirl to the left, forward whirl to the right.
    const order = Float64Array.from({ length: Math.max(0, 2 * bins - 1) }, (_, i) => i - bins + 1);
    this.lines = [
      order.map((bin) => Math.sign(bin) * of.order[Math.abs(bin)]! * frequency.factor),
      order.map((bin) => (bin < 0 ? of.backward : of.forward)[Math.abs(bin)]! * amplitude.factor),
    ];
    const reach = (of.order.at(-1) ?? 5) * (frequency.factor || 1);
    const most = this.lines[1].reduce((top, value) => Math.max(top, value), 0) || 1;
    this.figure.setAxes(`\u2190 backward  (${frequency.unit})  forward \u2192`, `amplitude (${amplitude.unit})`);
    this.figure.show([-reach, reach], [0, 1.1 * most], [...this.lines]);
    this.note.textContent = index < 0 ? 'no spectrum of this run yet' : placeText(subject, of.time, of.speed);
  }

  protected table(): Table {
    const { units, scales } = this.subject!;
    return {
      heading: [
        `frequency [${frequencyOf(units, 1).unit}], negative: backward`,
        `amplitude [${amplitudeMeasure(units, scales).unit}]`,
      ],
      rows: Array.from(this.lines[0], (frequency, i) => [frequency, this.lines[1][i]!]),
    };
  }
}

/// Height of the tallest peak as a share of the time axis.
const TALL = 0.16;

/// Spectra over the time, one above the other; the one nearest to the cursor stands out.
export class RunWaterfallPanel extends Panel<RunSubject> {
  readonly figure = new Chart({
    title: 'Waterfall',
    over: (pen, frame, colours) => this.draw(pen, frame, colours),
    xText: forwardText,
  });
  private shownFor: { readonly run: unknown; readonly of: string } | undefined;

  constructor() {
    super('run-waterfall', 'Waterfall over the time');
    this.assemble();
  }

  protected refresh(): void {
    const { run, station, time, units } = this.subject!;
    const of = JSON.stringify([station, units, run.spectrumNear(time)]);
    // Redraw only if another spectrum is at the cursor.
    if (this.shownFor?.run === run && this.shownFor.of === of) return;
    this.shownFor = { run, of };
    const order = run.spectrum(station, 0).order.at(-1) ?? 5;
    this.figure.setAxes('\u2190 backward  (orders)  forward \u2192', 'time (s)');
    this.figure.show([-order, order], [0, (1 + TALL) * (run.duration || 1)]);
    this.figure.redraw();
    const { factor, unit } = amplitudeMeasure(units, this.subject!.scales);
    const most = run.largestInSpectra(station) * factor;
    this.note.textContent = most > 0 ? `the tallest peak: ${shown(most, 4)} ${unit}` : 'no spectrum of this run yet';
  }

  protected table(): Table {
    const { run, station, units, scales } = this.subject!;
    const { factor, unit } = amplitudeMeasure(units, scales);
    const rows = Array.from(run.spectrumTimes.keys()).flatMap((index) => {
      const of = run.spectrum(station, index);
      return Number.isFinite(of.time)
        ? Array.from(of.order, (order, bin) => [of.time, order, of.forward[bin]! * factor, of.backward[bin]! * factor])
        : [];
    });
    return { heading: ['time [s]', 'order', `forward [${unit}]`, `backward [${unit}]`], rows };
  }

  private draw(pen: Pen, frame: Frame, colours: Theme): void {
    const { subject } = this;
    if (!subject) return;
    const { run, station, time } = subject;
    const tall = (TALL * run.duration) / (run.largestInSpectra(station) || 1);
    const marked = run.spectrumNear(time);
    pen.lineJoin = 'round';
    const draw = (index: number, colour: string, width: number) => {
      const of = run.spectrum(station, index);
      if (!Number.isFinite(of.time)) return;
      pen.strokeStyle = colour;
      pen.lineWidth = width * frame.ratio;
      pen.beginPath();
      for (let bin = 1 - of.order.length; bin < of.order.length; bin++) {
        const size = (bin < 0 ? of.backward : of.forward)[Math.abs(bin)]!;
        const [x, y] = [Math.sign(bin) * of.order[Math.abs(bin)]!, of.time + tall * size];
        (bin > 1 - of.order.length ? pen.lineTo : pen.moveTo).call(pen, frame.x(x), frame.y(y));
      }
      pen.stroke();
    };
    for (const index of run.spectrumTimes.keys()) if (index !== marked) draw(index, colours.frame, 0.8);
    if (marked >= 0) draw(marked, colours.a, 2);
  }
}
