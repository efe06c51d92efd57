// Spectra: amplitudes of both probes over orders, and the full spectrum of x + iy, forward to the right, backward to
// the left.
import { button, el } from '../dom';
import { Chart, type Frame, type Line, type Range } from '../figure/chart';
import { textSize } from '../figure/figure';
import { drawMeasured } from '../figure/measured';
import { placeLabels, skyline, type Peak } from '../figure/labels';
import { font, textWidth, type Pen } from '../figure/pen';
import type { Theme } from '../figure/theme';
import { tickText } from '../figure/ticks';
import { amplitudeMeasure, frequencyMeasure, shown } from '../model/units';
import type { Spectrum } from '../data/motion';
import { largestOf } from '../data/rest';
import { measuredKeys, Panel, type Table } from './panel';
import { key } from './waveform';

/// Decades of a logarithmic axis below the largest amplitude.
const DECADES = 5;

interface Curve {
  readonly frequency: Float64Array;
  readonly amplitudes: readonly Float64Array[];
}

interface MeasuredCurve extends Curve {
  /// True if the spectrum has a window, as those of computed motions; else it has the orders of whole revolutions.
  readonly windowed: boolean;
}

/// Revolutions from which measured spectra have a window (whirl_signals_spectrum).
const WINDOWED = 3.5;
/// Part of the largest amplitude from which a dot is drawn.
const LEAST = 3e-3;

const EMPTY: Curve = { frequency: new Float64Array(0), amplitudes: [] };

abstract class SpectralPanel extends Panel {
  readonly figure: Chart;
  protected curve: Curve = EMPTY;
  private peaks: readonly Peak[] = [];
  /// Curves of measured motions.
  private measured: readonly MeasuredCurve[] = [];
  private logarithmic = false;

  constructor(
    name: string,
    title: string,
    private readonly lines: readonly Line[],
    xText?: (value: number, step: number) => string,
  ) {
    super(name, title);
    this.figure = new Chart({
      title,
      lines,
      over: (pen, frame, colours) => this.drawPeaks(pen, frame, colours),
      ...(xText ? { xText } : {}),
    });
    const scale = button(
      'log',
      'Amplitudes on a log scale',
      () => {
        this.logarithmic = !this.logarithmic;
        scale.setAttribute('aria-pressed', String(this.logarithmic));
        this.refresh();
      },
      { class: 'icon', 'aria-pressed': 'false' },
    );
    this.assemble(scale);
  }

  protected abstract curveOf(spectrum: Spectrum, frequency: number, amplitude: number): Curve;
  protected abstract peaksOf(lines: Spectrum, frequency: number, amplitude: number): Peak[];
  protected abstract range(highest: number): Range;
  protected abstract axis(unit: string): string;

  protected refresh(): void {
    const { motion, station, units, scales } = this.subject!;
    const frequency = frequencyMeasure(units, scales);
    const amplitude = amplitudeMeasure(units, scales);
    const spectrum = motion?.spectrum(station);
    this.curve = spectrum?.order.length ? this.curveOf(spectrum, frequency.factor, amplitude.factor) : EMPTY;
    this.peaks =
      motion && spectrum?.order.length ? this.peaksOf(motion.lines(station), frequency.factor, amplitude.factor) : [];
    this.measured = this.subject!.measured.flatMap(({ spectrum: own }) =>
      own
        ? [{ ...this.curveOf(own, frequency.factor, amplitude.factor), windowed: 1 / own.order[1]! >= WINDOWED }]
        : [],
    );
    let most = 0;
    for (const { amplitudes } of this.measured)
      for (const values of amplitudes) for (const value of values) if (value > most) most = value;
    for (const values of this.curve.amplitudes) for (const value of values) if (value > most) most = value;
    for (const peak of this.peaks) most = Math.max(most, peak.amplitude);
    if (!(most > 0)) most = 1;
    const order = (spectrum?.order.at(-1) ?? 5) * frequency.factor;
    this.figure.setAxes(this.axis(frequency.unit), `amplitude (${amplitude.unit})`, this.logarithmic);
    const amplitudes: Range = this.logarithmic ? [most * 10 ** -DECADES, most * 3] : [0, most * 1.22];
    const lines = this.curve.amplitudes.length ? this.curve.amplitudes : [new Float64Array(0), new Float64Array(0)];
    this.figure.show(this.range(order), amplitudes, [this.curve.frequency, ...lines]);
    this.describe();
  }

  protected abstract describe(): void;

  /// Draws measured spectra: a line with a window, else a dot for every order.
  private drawMeasured(pen: Pen, frame: Frame, colours: Theme): void {
    for (const { frequency, amplitudes, windowed } of this.measured) {
      const most = largestOf(amplitudes.flatMap((values) => Array.from(values)));
      amplitudes.forEach((values, which) => {
        const colour = this.lines[which]!.colour(colours);
        if (!windowed) {
          const spots = Array.from(frequency, (x, i) => ({ x, y: values[i]! })).filter(({ y }) => y > LEAST * most);
          drawMeasured(pen, frame, colours, spots, colour);
          return;
        }
        pen.strokeStyle = colour;
        pen.lineWidth = 1.2 * frame.ratio;
        pen.setLineDash([2 * frame.ratio, 2 * frame.ratio]);
        pen.beginPath();
        let down = false;
        for (const [i, value] of values.entries()) {
          const there = Number.isFinite(value) && (!this.logarithmic || value > 0);
          if (there) (down ? pen.lineTo : pen.moveTo).call(pen, frame.x(frequency[i]!), frame.y(value));
          down = there;
        }
        pen.stroke();
        pen.setLineDash([]);
      });
    }
  }

  /// Entries of the legend for measured spectra.
  protected measuredKeys(): HTMLElement[] {
    const { measured } = this.subject!;
    const seen = measured.filter(({ spectrum }) => spectrum);
    return measuredKeys(
      seen,
      this.measured.map(({ windowed }) => (windowed ? 'dashed' : 'dots')),
    );
  }

  private drawPeaks(pen: Pen, frame: Frame, colours: Theme): void {
    if (!this.subject) return;
    this.drawMeasured(pen, frame, colours);
    const size = textSize() * frame.ratio;
    const face = font(size);
    pen.font = face;
    pen.fillStyle = colours.ink;
    pen.textAlign = 'center';
    pen.textBaseline = 'bottom';
    const hertz = this.subject.units.frequency !== 'order';
    const textOf = ({ frequency }: Peak) =>
      hertz ? shown(Math.abs(frequency), 4) : `${shown(Math.abs(frequency), 3)}X`;
    // Labels are above the curves and above measured ones.
    const tops = [this.curve, ...this.measured].map((each) => skyline(frame, each.frequency, each.amplitudes));
    const top = tops[0]!.map((_, column) => Math.min(...tops.map((each) => each[column]!)));
    for (const label of placeLabels(this.peaks, textOf, frame, top, size, (text) => textWidth(text, face)))
      pen.fillText(label.text, label.centre, label.bottom);
  }
}

/// Returns the peaks to be labelled: above a thirtieth of the largest.
function worthy(peaks: readonly Peak[]): Peak[] {
  const most = Math.max(0, ...peaks.map((peak) => peak.amplitude));
  return peaks.filter((peak) => peak.amplitude > 0.03 * most).sort((a, b) => b.amplitude - a.amplitude);
}

function scaled(values: Float64Array, factor: number): Float64Array {
  return values.map((value) => value * factor);
}

export class SpectrumPanel extends SpectralPanel {
  constructor() {
    super('spectrum', 'Spectrum', [
      { label: 'x', colour: (colours) => colours.x, width: 1.5 },
      { label: 'y', colour: (colours) => colours.y, width: 1.5 },
    ]);
  }

  protected curveOf(spectrum: Spectrum, frequency: number, amplitude: number): Curve {
    return {
      frequency: scaled(spectrum.order, frequency),
      amplitudes: [scaled(spectrum.x, amplitude), scaled(spectrum.y, amplitude)],
    };
  }

  protected peaksOf(lines: Spectrum, frequency: number, amplitude: number): Peak[] {
    return worthy(
      Array.from(lines.order, (order, i) => ({
        frequency: order * frequency,
        amplitude: Math.max(lines.x[i]!, lines.y[i]!) * amplitude,
      })),
    );
  }

  protected range(highest: number): Range {
    return [0, highest];
  }

  protected axis(unit: string): string {
    return `frequency (${unit})`;
  }

  protected describe(): void {
    this.note.replaceChildren(key('x', 'key-x'), key('y', 'key-y'), ...this.measuredKeys());
  }

  protected table(): Table {
    const { units, scales } = this.subject!;
    const [f, a] = [frequencyMeasure(units, scales).unit, amplitudeMeasure(units, scales).unit];
    return {
      heading: [`frequency [${f}]`, `x [${a}]`, `y [${a}]`],
      rows: Array.from(this.curve.frequency, (frequency, i) => [
        frequency,
        this.curve.amplitudes[0]![i]!,
        this.curve.amplitudes[1]![i]!,
      ]),
    };
  }
}

export class FullSpectrumPanel extends SpectralPanel {
  constructor() {
    super(
      'full-spectrum',
      'Full spectrum',
      [
        { label: 'backward', colour: (colours) => colours.backward, width: 1.5 },
        { label: 'forward', colour: (colours) => colours.forward, width: 1.5 },
      ],
      (value, step) => tickText(value, step),
    );
  }

  /// Returns the curve; backward frequencies are negative, the highest first, so that the axis is continuous.
  protected curveOf(spectrum: Spectrum, frequency: number, amplitude: number): Curve {
    const count = spectrum.order.length;
    const at = Float64Array.from(
      { length: 2 * count },
      (_, i) => (i < count ? -spectrum.order[count - 1 - i]! : spectrum.order[i - count]!) * frequency,
    );
    const backward = Float64Array.from({ length: 2 * count }, (_, i) =>
      i < count ? spectrum.backward[count - 1 - i]! * amplitude : NaN,
    );
    const forward = Float64Array.from({ length: 2 * count }, (_, i) =>
      i < count ? NaN : spectrum.forward[i - count]! * amplitude,
    );
    return { frequency: at, amplitudes: [backward, forward] };
  }

  protected peaksOf(lines: Spectrum, frequency: number, amplitude: number): Peak[] {
    const both = Array.from(lines.order, (order, i) => [
      { frequency: order * frequency, amplitude: lines.forward[i]! * amplitude },
      { frequency: -order * frequency, amplitude: lines.backward[i]! * amplitude },
    ]);
    return worthy(both.flat());
  }

  protected range(highest: number): Range {
    return [-highest, highest];
  }

  protected axis(unit: string): string {
    return `\u2190 backward \u00b7 ${unit} \u00b7 forward \u2192`;
  }

  protected describe(): void {
    this.note.replaceChildren(
      key('forward', 'key-forward'),
      key('backward', 'key-backward'),
      el('span', {}, 'relative to the rotation'),
      ...this.measuredKeys(),
    );
  }

  protected table(): Table {
    const { units, scales } = this.subject!;
    const [f, a] = [frequencyMeasure(units, scales).unit, amplitudeMeasure(units, scales).unit];
    const count = this.curve.frequency.length / 2;
    const [backward, forward] = this.curve.amplitudes;
    return {
      heading: [`frequency [${f}]`, `forward [${a}]`, `backward [${a}]`],
      rows: Array.from({ length: count }, (_, i) => [
        this.curve.frequency[count + i]!,
        forward![count + i]!,
        backward![count - 1 - i]!,
      ]),
    };
  }
}
