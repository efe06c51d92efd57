// Bands of tori over a diagram.
import type { Column } from '../data/diagram';
import { QUASI_PERIODIC } from '../data/regimes';
import type { Tori, Torus } from '../data/tori';
import type { BranchLines } from './branches';
import type { Frame } from './chart';
import { font, textWidth, type Pen } from './pen';
import type { Theme } from './theme';

/// Bounds of one coordinate of the section, [points][curves].
export interface ToriBands {
  readonly tori: Tori;
  readonly low: Column;
  readonly high: Column;
  readonly factor: number;
  readonly valueFactor: number;
  /// The orbits at which tori begin, if branches are shown.
  readonly lines: BranchLines | undefined;
}

/// A band at one value, in shown units.
export interface BandAt {
  readonly value: number;
  readonly low: number;
  readonly high: number;
  readonly stable: boolean;
}

/// Returns the band of one closed curve along a branch of tori, from the orbit at which the branch begins to the orbit
/// to which it may shrink.
export function bandOf(bands: ToriBands, torus: Torus, curve: number): BandAt[] {
  const { tori, low, high, factor, valueFactor, lines } = bands;
  const band = torus.points.map((point) => ({
    value: tori.diagram.values[point]! * valueFactor,
    low: low.data[point * low.rows + curve]! * factor,
    high: high.data[point * high.rows + curve]! * factor,
    stable: tori.isStable(point),
  }));
  const at = lines && lines.section.data[torus.origin * lines.section.rows + curve]! * lines.factor;
  const value = lines && lines.branches.diagram.values[torus.origin]! * lines.valueFactor;
  const last = band.at(-1)!;
  const end = tori.vanishesAt(torus.points.at(-1)!);
  const middle = (last.low + last.high) / 2;
  if (end !== undefined) band.push({ value: end * valueFactor, low: middle, high: middle, stable: last.stable });
  if (at !== undefined && value !== undefined && !Number.isNaN(at))
    band.unshift({ value, low: at, high: at, stable: band[0]!.stable });
  return band;
}

function fill(pen: Pen, band: readonly BandAt[], frame: Frame): void {
  pen.globalAlpha = 0.28;
  pen.beginPath();
  band.forEach(({ value, high }, i) =>
    i === 0 ? pen.moveTo(frame.x(value), frame.y(high)) : pen.lineTo(frame.x(value), frame.y(high)),
  );
  for (const { value, low } of [...band].reverse()) pen.lineTo(frame.x(value), frame.y(low));
  pen.closePath();
  pen.fill();
  pen.globalAlpha = 1;
}

/// Draws both edges, solid along stable tori, dashed along unstable ones.
function outline(pen: Pen, band: readonly BandAt[], frame: Frame): void {
  pen.lineWidth = 1.2 * frame.ratio;
  for (const stable of [true, false])
    for (const side of ['low', 'high'] as const) {
      pen.setLineDash(stable ? [] : [5 * frame.ratio, 3 * frame.ratio]);
      pen.beginPath();
      for (let i = 1; i < band.length; i++) {
        if (band[i]!.stable !== stable) continue;
        if (i === 1 || band[i - 1]!.stable !== stable)
          pen.moveTo(frame.x(band[i - 1]!.value), frame.y(band[i - 1]![side]));
        pen.lineTo(frame.x(band[i]!.value), frame.y(band[i]![side]));
      }
      pen.stroke();
    }
  pen.setLineDash([]);
}

/// Writes the rotation numbers below the middle of the band: "rotation 0.39865 to 0.41552".
function label(pen: Pen, bands: ToriBands, torus: Torus, band: readonly BandAt[], frame: Frame, colours: Theme): void {
  const size = 10 * frame.ratio;
  const face = font(size);
  const [first, last] = [torus.points[0]!, torus.points.at(-1)!].map((point) =>
    Number(bands.tori.rotation(point).toPrecision(5)),
  );
  const text = `rotation ${first} to ${last}`;
  const width = textWidth(text, face);
  const places = band.map(({ value }) => frame.x(value));
  const [from, to] = [Math.min(...places), Math.max(...places)];
  const middle = (from + to) / 2;
  if (to - from < width / 2) return; // narrow bands have no room for a label until the view is enlarged
  const left = Math.max(frame.left, Math.min(middle - width / 2, frame.left + frame.width - width));
  const bottom = frame.y(Math.min(...band.map(({ low }) => low)));
  if (!(middle >= frame.left && middle <= frame.left + frame.width)) return;
  pen.font = face;
  pen.textAlign = 'left';
  pen.textBaseline = 'top';
  pen.fillStyle = colours.ink;
  pen.fillText(text, left, Math.min(bottom + 3 * frame.ratio, frame.top + frame.height - 2.5 * size));
}

export function drawTori(pen: Pen, bands: ToriBands, frame: Frame, colours: Theme): void {
  pen.save();
  for (const torus of bands.tori.all)
    for (let curve = 0; curve < torus.curves; curve++) {
      const band = bandOf(bands, torus, curve);
      pen.fillStyle = pen.strokeStyle = colours.classes[QUASI_PERIODIC]!;
      fill(pen, band, frame);
      outline(pen, band, frame);
      if (curve === 0) label(pen, bands, torus, band, frame, colours);
    }
  pen.restore();
}
