// The diagram: a quantity over the parameter, the exponent below on the same axis, and the cursors that request
// motions.
import type { StoredBand } from '../data/bands';
import type { Branches } from '../data/branches';
import type { Diagram } from '../data/diagram';
import type { Seen } from '../data/measured';
import { CLASS_NAMES } from '../data/regimes';
import { lengthsOf, needsSpectra, quantityOf, type ShownQuantity } from '../data/quantities';
import type { Tori } from '../data/tori';
import { el } from '../dom';
import type { StationInfo } from '../engine/protocol';
import { drawBranches, heightsOf, type BranchLines } from '../figure/branches';
import { bandOf, drawTori, type BandAt, type ToriBands } from '../figure/tori';
import { Chart, drawClipped, drawZero, type Frame, type Range } from '../figure/chart';
import { drawCloud, type Cloud } from '../figure/cloud';
import { theme, textSize, type Picture } from '../figure/figure';
import { drawMeasured, type Spot as MeasuredSpot } from '../figure/measured';
import { font, type Pen } from '../figure/pen';
import { drawQuantiles, reachOfBand } from '../figure/quantiles';
import type { Theme } from '../figure/theme';
import { labelled, metreMeasures, parameterMeasure, type Scales } from '../model/units';
import type { Table } from './panel';
import { OrbitMarks } from './orbit_marks';
import { Stack, type Along, type Spot, type StackListener } from './stack';
import { FIELD } from '../data/fields';

export interface MapSubject extends Along {
  readonly diagram: Diagram | undefined;
  /// Branches of the same machine and parameter, or undefined.
  readonly branches: Branches | undefined;
  readonly tori: Tori | undefined;
  readonly quantity: string;
  readonly station: number;
  readonly stations: readonly StationInfo[];
  readonly scales: Scales;
  readonly hidden: ReadonlySet<number>;
  /// Band of tolerances of the shown quantity.
  readonly band: StoredBand | undefined;
  /// Measured vectors of the shown quantity.
  readonly measured: readonly MeasuredVectors[];
}

export interface MeasuredVectors {
  readonly name: string;
  readonly seen: Seen;
  /// True if the diagram shows lags, false for amplitudes.
  readonly lag: boolean;
}

export interface MapListener extends StackListener {
  /// Called after the orbit of a branch point was chosen.
  orbit(point: number): void;
}

/// Share of the height for the ribbons at the bottom.
const RIBBON = 0.07;

export class MapView {
  readonly root: HTMLElement;
  readonly stack: Stack;
  private subject: MapSubject | undefined;
  private quantity: ShownQuantity | undefined;
  private label = '';
  private shapes = false;
  private readonly main: Chart;
  private readonly exponent: Chart;
  private readonly empty = el('p', { class: 'empty' });
  private order: readonly number[] = [];
  private readonly marks: OrbitMarks;
  /// The value at which a key cycles through branches, and the point of the active setting.
  private cycled = NaN;
  private chosen: number | undefined;

  constructor(private readonly listener: MapListener) {
    this.main = new Chart({
      title: 'Diagram',
      bareX: true,
      under: (pen, frame, colours) => {
        this.drawContact(pen, frame, colours);
        this.drawBand(pen, frame, colours);
      },
      marks: (pen, frame, colours) => this.drawMain(pen, frame, colours),
    });
    this.exponent = new Chart({
      title: 'Largest Lyapunov exponent',
      under: (pen, frame, colours) => this.drawContact(pen, frame, colours),
      marks: (pen, frame, colours) => this.drawExponent(pen, frame, colours),
    });
    this.stack = new Stack(this.main, this.exponent, {
      ...listener,
      cursor: (value, settled, spot) => this.cursor(value, settled, spot),
      hover: (spot) => this.marks.hover(spot),
      key: (key, many) => this.key(key, many),
      enlarged: () => this.marks.show(this.branchLines()),
    });
    this.marks = new OrbitMarks(this.main);
    this.root = this.stack.root;
    this.root.append(this.empty);
  }

  show(subject: MapSubject): void {
    if (subject.diagram !== this.subject?.diagram) this.order = [];
    this.subject = subject;
    this.stack.show(subject, subject.quantity, subject.station);
    const { diagram } = subject;
    if (diagram && this.order.length !== diagram.count)
      this.order = Array.from(diagram.values.keys()).sort((a, b) => diagram.values[a]! - diagram.values[b]!);
    this.refresh();
  }

  /// Sets the branch points of settings A and B, the point of the active setting, and whether the user may choose other
  /// points.
  setOrbits(both: readonly (number | undefined)[], active: number | undefined, free: boolean): void {
    this.chosen = active;
    this.marks.choose(both, free);
  }

  /// Shows the quantity of the diagram; a diagram that is being computed has columns and scale with its first points.
  private showQuantity(subject: MapSubject): void {
    const { diagram } = subject;
    this.quantity =
      diagram &&
      quantityOf(diagram, subject.quantity, subject.station, subject.stations, subject.units, subject.scales.symbol);
    const xLabel = labelled(subject.parameter, parameterMeasure(subject.unit, subject.units).unit);
    if (this.quantity || diagram?.known) this.label = this.quantity?.label ?? '';
    this.main.setAxes(xLabel, this.label);
    this.exponent.setAxes(xLabel, 'exponent / rev.');
    this.empty.textContent = this.quantity || !diagram?.known ? '' : 'The run does not have this quantity.';
  }

  /// Redraws after new points, or a change of colours.
  refresh(): void {
    const subject = this.subject;
    if (!subject) return;
    this.showQuantity(subject);
    const x = this.stack.range;
    this.main.show(x, this.mainRange(subject));
    this.exponent.show(x, this.exponentRange(subject));
    this.stack.redraw();
    this.marks.show(this.branchLines());
  }

  focus(): void {
    this.main.overlay.focus();
  }

  picture(): Picture {
    this.shapes = true;
    const made = this.stack.picture('Bifurcation diagram', (pen, width, top, height) =>
      this.sketchLegend(pen, width, top, height),
    );
    this.shapes = false;
    return made;
  }

  table(): Table {
    const subject = this.subject;
    const { diagram } = subject ?? {};
    if (!subject || !diagram) return { heading: ['point'], rows: [] };
    const measure = parameterMeasure(subject.unit, subject.units);
    const quantity = this.quantity;
    const rows = quantity?.column.rows ?? 0;
    const label = quantity?.label ?? '';
    return {
      heading: [
        labelled(subject.parameter, measure.unit),
        'branch',
        'verdict',
        'exponent per revolution',
        'its error',
        'contact share',
        ...Array.from({ length: rows }, (_, row) => (rows === 1 ? label : `${label} ${row + 1}`)),
      ],
      rows: this.order
        .filter((point) => diagram.done[point])
        .map((point) => {
          const exponent = diagram.exponent(point);
          const numbers = Array.from(
            quantity?.column.data.subarray(point * rows, (point + 1) * rows) ?? [],
            (value) => value * quantity!.factor,
          );
          return [
            diagram.values[point]! * measure.factor,
            diagram.branch[point]!,
            diagram.verdicts[point]![0],
            exponent.value,
            exponent.error,
            diagram.contact(point),
            ...numbers,
          ];
        }),
    };
  }

  // ---------------------------------------------------------------- orbits of branches

  /// Handles the cursor: near a branch it selects an orbit, elsewhere the motion at its value.
  private cursor(value: number, settled: boolean, spot: Spot | undefined): void {
    const point = spot ? this.marks.at(spot) : -1;
    if (point >= 0) this.listener.orbit(point);
    else this.listener.cursor(value, settled);
    this.marks.hover(undefined);
  }

  /// Handles keys: arrows move along the branch of the selected orbit; "o" cycles through the orbits at the cursor's
  /// value and back to the motion.
  private key(key: string, many: number): boolean {
    const { branches } = this.marks;
    const { chosen } = this;
    if (!branches) return false;
    const steps = { ArrowRight: many, ArrowUp: many, ArrowLeft: -many, ArrowDown: -many }[key];
    if (steps !== undefined && chosen !== undefined) this.listener.orbit(branches.along(chosen, steps));
    else if (key.toLowerCase() === 'o') this.cycle(branches);
    else return false;
    return true;
  }

  private cycle(branches: Branches): void {
    const { chosen } = this;
    if (chosen === undefined || !branches.at(this.cycled).includes(chosen)) this.cycled = this.stack.chosenValue;
    const there = branches.at(this.cycled);
    const next = chosen === undefined ? 0 : there.indexOf(chosen) + 1;
    if (next < there.length) this.listener.orbit(there[next]!);
    else if (chosen !== undefined) this.listener.cursor(this.cycled, true);
  }

  // ---------------------------------------------------------------- ranges

  private visible(subject: MapSubject, visit: (point: number) => void): void {
    const { diagram, range, hidden } = subject;
    if (!diagram) return;
    for (let point = 0; point < diagram.count; point++) {
      const value = diagram.values[point]!;
      if (diagram.done[point] && value >= range[0] && value <= range[1] && !hidden.has(diagram.classes[point]!))
        visit(point);
    }
  }

  private mainRange(subject: MapSubject): Range {
    const quantity = this.quantity;
    let [low, high] = [Infinity, -Infinity];
    if (quantity)
      this.visible(subject, (point) => {
        const { rows, data } = quantity.column;
        for (let i = point * rows; i < (point + 1) * rows; i++) {
          const value = data[i]!;
          if (value < low) low = value;
          if (value > high) high = value;
        }
      });
    const lines = this.branchLines();
    if (lines && quantity)
      for (const { point } of lines.branches.changes)
        for (const height of heightsOf(lines, point)) {
          low = Math.min(low, height / quantity.factor);
          high = Math.max(high, height / quantity.factor);
        }
    const along = quantity && subject.band && bandFactors(subject, quantity);
    for (const value of along ? reachOfBand(subject.band!, subject.range) : []) {
      low = Math.min(low, (value * along![1]) / quantity!.factor);
      high = Math.max(high, (value * along![1]) / quantity!.factor);
    }
    for (const { y } of quantity ? this.measuredSpots(subject) : []) {
      low = Math.min(low, y / quantity!.factor);
      high = Math.max(high, y / quantity!.factor);
    }
    for (const band of quantity ? this.bandsInView() : []) {
      low = Math.min(low, band.low / quantity!.factor);
      high = Math.max(high, band.high / quantity!.factor);
    }
    if (!(low <= high)) return [0, 1];
    const factor = quantity!.factor;
    const room = 0.04 * (high - low) * factor || Math.abs(high * factor) * 0.1 || 1;
    [low, high] = [low * factor - room, high * factor + room];
    return [low - RIBBON * 1.2 * (high - low), high];
  }

  /// Returns the range of exponents without the strongest decays, which would flatten the curve.
  private exponentRange(subject: MapSubject): Range {
    const values: number[] = [];
    this.visible(subject, (point) => {
      const { value } = subject.diagram!.exponent(point);
      if (Number.isFinite(value)) values.push(value);
    });
    if (!values.length) return [-1, 1];
    values.sort((a, b) => a - b);
    const low = Math.min(values[Math.floor(values.length * 0.02)]!, 0);
    const high = Math.max(values.at(-1)!, 0);
    const room = 0.12 * (high - low) || 0.1;
    return [low - room, high + room];
  }

  // ---------------------------------------------------------------- drawing

  private drawMain(pen: Pen, frame: Frame, colours: Theme): void {
    const cloud = this.cloud();
    if (!cloud) return;
    drawCloud(pen, cloud, frame, colours, this.shapes);
    drawClipped(pen, frame, () => {
      const bands = this.toriBands();
      if (bands) drawTori(pen, bands, frame, colours);
      const lines = this.branchLines();
      if (lines) drawBranches(pen, lines, frame, colours);
      this.drawRibbon(pen, frame, colours);
      drawMeasured(pen, frame, colours, this.subject ? this.measuredSpots(this.subject) : []);
    });
  }

  /// Draws the quantiles of tolerances.
  private drawBand(pen: Pen, frame: Frame, colours: Theme): void {
    const { subject } = this;
    const factors = subject?.band && this.quantity && bandFactors(subject, this.quantity);
    if (factors) drawQuantiles(pen, frame, subject.band!, factors, colours.band);
  }

  /// Returns measured vectors in the shown units.
  private measuredSpots({ measured, units, scales, unit, range }: MapSubject): MeasuredSpot[] {
    const along = parameterMeasure(unit, units).factor;
    const amplitude = metreMeasures(units, scales).amplitude.factor;
    return measured.flatMap(({ seen, lag }) =>
      seen.at.flatMap((at, i) => {
        const y = lag ? seen.lags?.[i] : seen.amplitudes[i]! * amplitude;
        return y !== undefined && at >= range[0] && at <= range[1] ? [{ x: at * along, y }] : [];
      }),
    );
  }

  /// Returns the shown coordinate of the section along the branches.
  private branchLines(): BranchLines | undefined {
    const { subject } = this;
    const { branches } = subject ?? {};
    if (!subject || !branches || (subject.quantity !== 'x' && subject.quantity !== 'y')) return undefined;
    const { station, stations, units, scales } = subject;
    const shown = (id: string) => quantityOf(branches.diagram, id, station, stations, units, scales.symbol);
    const column = subject.quantity === 'x' ? 0 : 1;
    const [section, high, low] = [shown(subject.quantity), shown(`trace/high:${column}`), shown(`trace/low:${column}`)];
    return (
      section &&
      high &&
      low && {
        branches,
        section: section.column,
        bounds: [high.column, low.column],
        factor: section.factor,
        valueFactor: parameterMeasure(subject.unit, units).factor,
      }
    );
  }

  /// Returns the shown coordinate of the sections of tori.
  private toriBands(): ToriBands | undefined {
    const { subject } = this;
    const { tori } = subject ?? {};
    if (!subject || !tori || (subject.quantity !== 'x' && subject.quantity !== 'y')) return undefined;
    const column = subject.quantity === 'x' ? 0 : 1;
    const [low, high] = [FIELD.TORUS_SECTION_LOW, FIELD.TORUS_SECTION_HIGH].map((field) =>
      lengthsOf(tori.diagram, field, subject.station, column, subject.units),
    );
    const valueFactor = parameterMeasure(subject.unit, subject.units).factor;
    return (
      low &&
      high && { tori, low: low.column, high: high.column, factor: low.factor, valueFactor, lines: this.branchLines() }
    );
  }

  /// Returns the bands of tori within the range.
  private bandsInView(): BandAt[] {
    const bands = this.toriBands();
    if (!bands) return [];
    const [from, to] = this.subject!.range.map((value) => value * bands.valueFactor);
    return bands.tori.all
      .flatMap((torus) => Array.from({ length: torus.curves }, (_, curve) => bandOf(bands, torus, curve)).flat())
      .filter(({ value }) => value >= from! && value <= to!);
  }

  private cloud(): Cloud | undefined {
    const { subject, quantity } = this;
    if (!subject?.diagram || !quantity) return undefined;
    return {
      diagram: subject.diagram,
      column: quantity.column,
      factor: quantity.factor,
      valueFactor: parameterMeasure(subject.unit, subject.units).factor,
      hidden: subject.hidden,
    };
  }

  private drawExponent(pen: Pen, frame: Frame, colours: Theme): void {
    const { subject } = this;
    const column =
      subject?.diagram &&
      (subject.diagram.column(FIELD.LYAPUNOV_LARGEST) ?? subject.diagram.column(FIELD.REGIME_EXPONENT));
    if (!subject?.diagram || !column) return;
    drawClipped(pen, frame, () => {
      drawZero(pen, frame, colours.muted);
      this.drawErrors(pen, frame, subject, colours);
    });
    const valueFactor = parameterMeasure(subject.unit, subject.units).factor;
    drawCloud(
      pen,
      { diagram: subject.diagram, column, factor: 1, valueFactor, hidden: subject.hidden },
      frame,
      colours,
      this.shapes,
    );
  }

  /// Draws standard errors that are wide enough to be visible.
  private drawErrors(pen: Pen, frame: Frame, subject: MapSubject, colours: Theme): void {
    const factor = parameterMeasure(subject.unit, subject.units).factor;
    const diagram = subject.diagram!;
    pen.strokeStyle = colours.muted;
    pen.beginPath();
    this.visible(subject, (point) => {
      const { value, error } = diagram.exponent(point);
      const [top, bottom] = [frame.y(value + error), frame.y(value - error)];
      if (!(bottom - top > 3 * frame.ratio)) return;
      const x = frame.x(diagram.values[point]! * factor);
      pen.moveTo(x, top);
      pen.lineTo(x, bottom);
    });
    pen.stroke();
  }

  /// Calls `visitor` for every visible point with its pixel range, half-way to its neighbours.
  private cells(frame: Frame, visitor: (point: number, left: number, right: number) => void): void {
    const { subject, order } = this;
    const { diagram } = subject ?? {};
    if (!subject || !diagram) return;
    const factor = parameterMeasure(subject.unit, subject.units).factor;
    // Draw the attractor with most starts last, over the others.
    for (const branch of [...new Set(diagram.branch)].sort((a, b) => b - a)) {
      const mine = order.filter((point) => diagram.branch[point] === branch && diagram.done[point]);
      const place = (i: number) => frame.x(diagram.values[mine[i]!]! * factor);
      for (let i = 0; i < mine.length; i++) {
        const here = place(i);
        const left = i > 0 ? (place(i - 1) + here) / 2 : here - (mine.length > 1 ? place(1) - here : 4) / 2;
        const right =
          i + 1 < mine.length ? (place(i + 1) + here) / 2 : here + (mine.length > 1 ? here - place(i - 1) : 4) / 2;
        if (right >= frame.left && left <= frame.left + frame.width) visitor(mine[i]!, left, right);
      }
    }
  }

  private drawContact(pen: Pen, frame: Frame, colours: Theme): void {
    const diagram = this.subject?.diagram;
    if (!diagram?.column(FIELD.RUB_SHARE)) return;
    pen.fillStyle = colours.contactShade;
    pen.beginPath();
    this.cells(frame, (point, left, right) => {
      if (diagram.branch[point]! >= 0 && diagram.contact(point) > 0)
        pen.rect(left, frame.top, right - left, frame.height);
    });
    pen.fill();
  }

  /// Draws regimes as a ribbon along the bottom, and confidence above it if the run has it.
  private drawRibbon(pen: Pen, frame: Frame, colours: Theme): void {
    const diagram = this.subject!.diagram!;
    if (!diagram.judged) return;
    const thick = 6 * frame.ratio;
    const both = diagram.branch.includes(-1) && diagram.branch.includes(1);
    const bottom = frame.top + frame.height;
    this.cells(frame, (point, left, right) => {
      const height = both ? thick / 2 : thick;
      const top = bottom - thick + (both && diagram.branch[point]! < 0 ? height : 0);
      pen.fillStyle = colours.classes[diagram.classes[point]!]!;
      pen.beginPath();
      pen.rect(left, top, right - left + 0.5, height);
      pen.fill();
      const confidence = diagram.confidence(point);
      if (!(confidence >= 0)) return;
      pen.globalAlpha = [0.12, 0.45, 1][confidence] ?? 0.12;
      pen.fillStyle = colours.ink;
      pen.beginPath();
      pen.rect(left, bottom - thick - 5 * frame.ratio, right - left + 0.5, 3 * frame.ratio);
      pen.fill();
      pen.globalAlpha = 1;
    });
  }

  private sketchLegend(pen: Pen, width: number, top: number, height: number): void {
    const colours = theme();
    const size = textSize();
    pen.fillStyle = colours.paper;
    pen.beginPath();
    pen.rect(0, top, width, height);
    pen.fill();
    pen.font = font(size);
    pen.textAlign = 'left';
    pen.textBaseline = 'middle';
    let x = 5 * size;
    for (const { name, kind } of this.legend()) {
      pen.fillStyle = colours.classes[kind]!;
      pen.beginPath();
      pen.rect(x, top + height / 2 - 4, 8, 8);
      pen.fill();
      pen.fillStyle = colours.ink;
      pen.fillText(name, x + 12, top + height / 2);
      x += 24 + name.length * size * 0.56;
    }
  }

  private legend(): { name: string; kind: number }[] {
    const diagram = this.subject?.diagram;
    if (!diagram?.judged) return [];
    const there = new Set(Array.from(diagram.classes).filter((_, point) => diagram.done[point]));
    return CLASS_ENTRIES.filter(({ kind }) => there.has(kind));
  }
}

/// Returns the factors from SI to the shown units of both axes.
function bandFactors({ units, unit, scales, quantity: id }: MapSubject, quantity: ShownQuantity): [number, number] {
  const { length, amplitude } = metreMeasures(units, scales);
  const height = quantity.length ? (needsSpectra(id) ? amplitude : length).factor : 1;
  return [parameterMeasure(unit, units).factor, height];
}

const CLASS_ENTRIES = CLASS_NAMES.map((name, kind) => ({ name, kind }));
