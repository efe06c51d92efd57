// The orbit, viewed along the shaft, with the once-per-revolution mark, the probes, the directions of rotation and
// whirl, and the circles of clearance and gap.
import { button } from '../dom';
import type { OrbitOfBranch } from '../data/orbit';
import { drawDots, radiusOf } from '../figure/measured';
import { drawMark } from '../figure/marks';
import { font, type Pen } from '../figure/pen';
import { Round } from '../figure/round';
import type { Theme } from '../figure/theme';
import { linearTicks, niceStep } from '../figure/ticks';
import { lengthMeasure, shown, type Measure } from '../model/units';
import { measuredKeys, Panel, type Subject, type Table } from './panel';
import { textSize } from '../figure/figure';
import { FIELD } from '../data/fields';

/// Conversion of lengths, with y upwards, to the pen's pixels.
interface Place {
  readonly x: (value: number) => number;
  readonly y: (value: number) => number;
  readonly scale: number;
}

/// The trail of an animated motion: its last samples, oldest first, in length scales.
export interface Trail {
  readonly x: ArrayLike<number>;
  readonly y: ArrayLike<number>;
  /// Indices of the samples at the mark.
  readonly marks: readonly number[];
  readonly touching: boolean;
  readonly text: string;
}

const MAX_REVOLUTIONS = 20;
/// Part of a revolution within which a measured instant is at the mark.
const AT_MARK = 1e-6;

export class OrbitPanel extends Panel {
  readonly figure = new Round('Orbit', (pen, width, height, colours) => this.draw(pen, width, height, colours));
  private whole = true;
  private trail: Trail | undefined;

  constructor(tools: readonly HTMLElement[]) {
    super('orbit', 'Orbit');
    const zoom = button(
      '\u2922',
      'Fit the orbit, or show the whole clearance',
      () => {
        this.whole = !this.whole;
        zoom.setAttribute('aria-pressed', String(!this.whole));
        this.figure.redraw();
      },
      { class: 'icon', 'aria-pressed': 'false' },
    );
    this.assemble(...tools, zoom);
  }

  /// Shows a moving point with its trail in place of the settled orbit; undefined ends it.
  watch(trail: Trail | undefined): void {
    this.trail = trail;
    this.figure.redraw();
  }

  protected refresh(): void {
    const { motion, station, units, scales } = this.subject!;
    const length = lengthMeasure(units, scales);
    if (!motion || motion.diverged) this.note.textContent = motion ? 'The motion diverged: there is no orbit.' : '';
    else {
      const span = (column: number) =>
        (motion.number(FIELD.ORBIT_HIGH, station, column) - motion.number(FIELD.ORBIT_LOW, station, column)) *
        length.factor;
      const radius = motion.number(FIELD.ORBIT_MAX_RADIUS, station) * length.factor;
      this.note.textContent =
        `X ${shown(span(0), 3)}, Y ${shown(span(1), 3)} ${length.unit} p-p; ${shown(radius, 3)} ${length.unit} ` +
        '0-p from the centre';
      const whirl = motion.forwardWhirl(station) === false ? 'backward' : 'forward';
      this.figure.description = [`${this.note.textContent}; whirl ${whirl}`, motion.orbit?.label]
        .filter(Boolean)
        .join('; ');
    }
    this.note.append(...measuredKeys(this.subject!.measured.filter(({ x, y }) => x && y)));
    this.figure.redraw();
  }

  protected table(): Table {
    const { motion, station, units, scales } = this.subject!;
    const length = lengthMeasure(units, scales);
    const wave = motion?.waveform(station) ?? { x: [], y: [] };
    const per = motion?.samplesPerRevolution ?? 1;
    return {
      heading: ['revolution', `x [${length.unit}]`, `y [${length.unit}]`],
      rows: Array.from(wave.x, (x, i) => [(i + 1) / per, x * length.factor, wave.y[i]! * length.factor]),
    };
  }

  private draw(pen: Pen, width: number, height: number, colours: Theme): void {
    const subject = this.subject;
    if (!subject) return;
    const view = this.view(subject);
    const length = lengthMeasure(subject.units, subject.scales);
    const size = textSize();
    const side = Math.min(width, height) - 2.6 * size;
    const scale = side / (2 * view.half);
    const place: Place = {
      x: (value) => width / 2 + (value - view.x) * scale,
      y: (value) => height / 2 - (value - view.y) * scale,
      scale,
    };
    drawGrid(pen, place, view, [width, height], length, colours, size);
    pen.save();
    pen.beginPath();
    pen.rect(0, 0, width, height);
    pen.clip();
    drawCircles(pen, place, subject, this.trail?.touching ?? false, colours, size);
    pen.restore();
    if (!this.trail) drawMeasuredOrbits(pen, place, subject, colours);
    if (this.trail) drawTrail(pen, place, this.trail, subject.accent(colours), colours, [width, height], size);
    else if (subject.motion && !subject.motion.diverged) drawOrbit(pen, place, subject, colours);
    drawDirections(pen, subject, this.trail !== undefined, [width, height], colours, size);
    const orbit = this.trail ? undefined : subject.motion?.orbit;
    if (orbit) drawName(pen, orbit, width, colours, size);
  }

  /// Returns centre and half-width of the view, in length scales.
  private view(subject: Subject): { x: number; y: number; half: number } {
    const { motion, station, info } = subject;
    const walls = Math.max(info.gap, info.clearance);
    const measured = this.trail ? [] : orbitsOf(subject);
    const reach = this.trail
      ? largest(this.trail.x, this.trail.y)
      : Math.max(motion?.number(FIELD.ORBIT_MAX_RADIUS, station) || 0, ...measured.map(([x, y]) => largest(x, y)));
    if (!this.trail && !this.whole && motion && Number.isFinite(reach)) {
      const bound = (field: string, column: number) => motion.number(field, station, column);
      const [left, right] = [bound(FIELD.ORBIT_LOW, 0), bound(FIELD.ORBIT_HIGH, 0)];
      const [low, high] = [bound(FIELD.ORBIT_LOW, 1), bound(FIELD.ORBIT_HIGH, 1)];
      const span = (axis: 0 | 1, ends: readonly (number | undefined)[]) => {
        const all = measured.flatMap((orbit) => Array.from(orbit[axis]));
        const [from, to] = [Math.min(ends[0]!, ...all), Math.max(ends[1]!, ...all)];
        return { middle: (from + to) / 2, size: to - from };
      };
      const [x, y] = [span(0, [left, right]), span(1, [low, high])];
      return { x: x.middle, y: y.middle, half: 0.56 * Math.max(x.size, y.size, 1e-9) };
    }
    const most = Math.max(walls, Number.isFinite(reach) ? reach : 0) || 1;
    return { x: 0, y: 0, half: 1.06 * most };
  }
}

/// Returns the measured orbits: x and y of every instant.
function orbitsOf({ measured }: Subject): (readonly [Float64Array, Float64Array])[] {
  return measured.flatMap(({ x, y }) => (x && y ? [[x, y] as const] : []));
}

/// Draws measured orbits as dots, with rings around those at the mark.
function drawMeasuredOrbits(pen: Pen, place: Place, subject: Subject, colours: Theme): void {
  for (const { x, y, turns } of subject.measured) {
    if (!x || !y) continue;
    const places = Array.from(x, (value, i) => [place.x(value), place.y(y[i]!)] as const);
    const radius = radiusOf(places.length, 900);
    drawDots(pen, places, radius, colours.measured, radius > 2 ? colours.paper : '');
    pen.strokeStyle = colours.measured;
    pen.lineWidth = 1.5;
    places.forEach(([left, top], i) => {
      if (Math.abs(turns[i]! - Math.round(turns[i]!)) < AT_MARK) drawMark(pen, 'ring', left, top, 6.5);
    });
  }
}

/// Draws the name of a branch orbit, which has no verdict.
function drawName(pen: Pen, orbit: OrbitOfBranch, width: number, colours: Theme, size: number): void {
  const most = shown(orbit.largest, 3);
  const lines = [
    `branch ${orbit.branch}: ${orbit.verdict}`,
    orbit.rests ? `growth ${most} per rad` : `largest multiplier ${most}`,
  ];
  lines.forEach((text, i) =>
    label(pen, text, width - 0.4 * size, (2.9 + 1.3 * i) * size, 'right', 'top', colours.ink, colours, size),
  );
}

function largest(x: ArrayLike<number>, y: ArrayLike<number>): number {
  let most = 0;
  for (let i = 0; i < x.length; i++) most = Math.max(most, Math.hypot(x[i]!, y[i]!));
  return most;
}

function drawGrid(
  pen: Pen,
  place: Place,
  view: { x: number; y: number; half: number },
  [width, height]: readonly [number, number],
  length: Measure,
  colours: Theme,
  size: number,
): void {
  const halves = [width / 2 / place.scale, height / 2 / place.scale] as const;
  const division = niceStep(2 * view.half * length.factor, 8);
  const ticks = (centre: number, half: number) =>
    linearTicks(
      (centre - half) * length.factor,
      (centre + half) * length.factor,
      (2 * half * length.factor) / division,
    ).map((tick) => tick / length.factor);
  pen.lineWidth = 1;
  pen.strokeStyle = colours.grid;
  pen.beginPath();
  for (const x of ticks(view.x, halves[0])) {
    pen.moveTo(place.x(x), 0);
    pen.lineTo(place.x(x), height);
  }
  for (const y of ticks(view.y, halves[1])) {
    pen.moveTo(0, place.y(y));
    pen.lineTo(width, place.y(y));
  }
  pen.stroke();
  pen.strokeStyle = colours.frame;
  pen.beginPath();
  pen.moveTo(place.x(0), 0);
  pen.lineTo(place.x(0), height);
  pen.moveTo(0, place.y(0));
  pen.lineTo(width, place.y(0));
  pen.stroke();
  label(
    pen,
    `${shown(division, 3)} ${length.unit}/div`,
    width - 0.4 * size,
    height - 0.4 * size,
    'right',
    'bottom',
    colours.muted,
    colours,
    size,
  );
}

/// Draws a text on a background, so that lines do not cross it.
function label(
  pen: Pen,
  text: string,
  x: number,
  y: number,
  align: CanvasTextAlign,
  baseline: CanvasTextBaseline,
  ink: string,
  colours: Theme,
  size: number,
): void {
  const width = text.length * size * 0.54 + 4;
  const left = align === 'right' ? x - width + 2 : align === 'center' ? x - width / 2 : x - 2;
  const top = baseline === 'bottom' ? y - size * 1.15 : baseline === 'middle' ? y - size * 0.65 : y - 2;
  pen.save();
  pen.globalAlpha = 0.8;
  pen.fillStyle = colours.paper;
  pen.beginPath();
  pen.rect(left, top, width, size * 1.3);
  pen.fill();
  pen.restore();
  pen.fillStyle = ink;
  pen.font = font(size);
  pen.textAlign = align;
  pen.textBaseline = baseline;
  pen.fillText(text, x, y);
}

function circle(pen: Pen, x: number, y: number, radius: number): void {
  pen.beginPath();
  pen.moveTo(x + radius, y);
  pen.arc(x, y, radius, 0, 2 * Math.PI);
}

function drawCircles(pen: Pen, place: Place, subject: Subject, touching: boolean, colours: Theme, size: number): void {
  const { gap, clearance } = subject.info;
  const [x, y] = [place.x(0), place.y(0)];
  if (clearance > 0) {
    circle(pen, x, y, clearance * place.scale);
    pen.strokeStyle = colours.clearance;
    pen.lineWidth = 1.4;
    pen.setLineDash([6, 4]);
    pen.stroke();
    pen.setLineDash([]);
    const angle = 0.75 * Math.PI;
    label(
      pen,
      'bearing',
      x + clearance * place.scale * Math.cos(angle),
      y - clearance * place.scale * Math.sin(angle),
      'center',
      'middle',
      colours.clearance,
      colours,
      size,
    );
  }
  if (gap > 0) {
    circle(pen, x, y, gap * place.scale);
    pen.strokeStyle = touching ? colours.touch : colours.stator;
    pen.lineWidth = touching ? 6 : 2;
    pen.stroke();
    const angle = 0.25 * Math.PI;
    label(
      pen,
      touching ? 'contact' : 'stator',
      x + gap * place.scale * Math.cos(angle),
      y - gap * place.scale * Math.sin(angle),
      'center',
      'middle',
      touching ? colours.touch : colours.stator,
      colours,
      size,
    );
  }
}

/// Returns the number of revolutions to draw: a period of a periodic motion, at most MAX_REVOLUTIONS of other motions.
function revolutionsShown(period: number, available: number): number {
  return Math.min(available, period > 0 ? period : MAX_REVOLUTIONS);
}

function drawOrbit(pen: Pen, place: Place, subject: Subject, colours: Theme): void {
  const motion = subject.motion!;
  const { x, y } = motion.waveform(subject.station);
  const per = motion.samplesPerRevolution;
  const available = Math.floor(x.length / per);
  const revolutions = motion.orbit?.rests ? Math.min(1, available) : revolutionsShown(motion.period, available);
  if (revolutions === 0) return;
  // Draw an autonomous orbit slightly more than once around.
  const first = Math.max(1, x.length - Math.ceil(revolutions * per));
  // Leave a gap before the mark, which shows the direction.
  const blank = revolutions <= 8 ? Math.max(1, Math.round(per / 28)) : 0;
  const accent = subject.accent(colours);
  pen.strokeStyle = accent;
  if (motion.orbit && !motion.orbit.stable) pen.setLineDash([7, 4]);
  pen.lineWidth = revolutions > 8 ? 0.9 : 1.6;
  pen.lineJoin = 'round';
  pen.beginPath();
  // Begin with the sample before the first one, which is at the mark.
  let down = false;
  for (let i = Math.max(0, first - 1); i < x.length; i++) {
    const toMark = (x.length - 1 - i) % per;
    const dark = blank > 0 && toMark > 0 && toMark <= blank;
    if (dark) down = false;
    else {
      (down ? pen.lineTo : pen.moveTo).call(pen, place.x(x[i]!), place.y(y[i]!));
      down = true;
    }
  }
  pen.stroke();
  pen.setLineDash([]);
  drawHeads(pen, place, x, y, first, per, revolutions, accent);
  for (let mark = x.length - 1; mark >= first; mark -= per)
    dot(pen, place.x(x[mark]!), place.y(y[mark]!), revolutions > 8 ? 2.4 : 4.2, colours.keyphasor, colours.paper);
}

function dot(pen: Pen, x: number, y: number, radius: number, ink: string, rim: string): void {
  circle(pen, x, y, radius);
  pen.fillStyle = ink;
  pen.fill();
  pen.strokeStyle = rim;
  pen.lineWidth = 1;
  pen.stroke();
}

/// Draws arrow heads along the first drawn revolution.
function drawHeads(
  pen: Pen,
  place: Place,
  x: Float64Array,
  y: Float64Array,
  first: number,
  per: number,
  revolutions: number,
  ink: string,
): void {
  if (revolutions > 8) return;
  pen.fillStyle = ink;
  for (const part of [0.3, 0.7]) {
    const i = first + Math.round(part * per);
    const [x0, y0, x1, y1] = [place.x(x[i - 1] ?? NaN), place.y(y[i - 1] ?? NaN), place.x(x[i]!), place.y(y[i]!)];
    if (Math.hypot(x1 - x0, y1 - y0) > 0.02) head(pen, x1, y1, Math.atan2(y1 - y0, x1 - x0), 6);
  }
}

function head(pen: Pen, x: number, y: number, angle: number, size: number): void {
  const corner = (turn: number, far: number) =>
    [x + far * Math.cos(angle + turn), y + far * Math.sin(angle + turn)] as const;
  pen.beginPath();
  pen.moveTo(...corner(0, size));
  pen.lineTo(...corner(2.5, size));
  pen.lineTo(...corner(-2.5, size));
  pen.closePath();
  pen.fill();
}

function drawTrail(
  pen: Pen,
  place: Place,
  trail: Trail,
  ink: string,
  colours: Theme,
  [width]: readonly [number, number],
  size: number,
): void {
  const count = trail.x.length;
  pen.lineJoin = 'round';
  pen.strokeStyle = ink;
  const pieces = 8; // fades towards the past
  for (let piece = 0; piece < pieces; piece++) {
    const [from, to] = [Math.floor((count * piece) / pieces), Math.floor((count * (piece + 1)) / pieces)];
    pen.globalAlpha = 0.15 + (0.85 * (piece + 1)) / pieces;
    pen.lineWidth = 1.6;
    pen.beginPath();
    for (let i = Math.max(0, from - 1); i < to; i++)
      (i === Math.max(0, from - 1) ? pen.moveTo : pen.lineTo).call(pen, place.x(trail.x[i]!), place.y(trail.y[i]!));
    pen.stroke();
  }
  pen.globalAlpha = 1;
  for (const mark of trail.marks)
    dot(pen, place.x(trail.x[mark]!), place.y(trail.y[mark]!), 3, colours.keyphasor, colours.paper);
  if (count > 0)
    dot(
      pen,
      place.x(trail.x[count - 1]!),
      place.y(trail.y[count - 1]!),
      6,
      trail.touching ? colours.touch : ink,
      colours.paper,
    );
  label(pen, trail.text, width / 2, 0.4 * size, 'center', 'top', colours.ink, colours, size);
}

/// Draws the directions of rotation and whirl, and the probes.
function drawDirections(
  pen: Pen,
  subject: Subject,
  watching: boolean,
  [width, height]: readonly [number, number],
  colours: Theme,
  size: number,
): void {
  const radius = 1.1 * size;
  const [x, y] = [0.5 * size + radius, 0.5 * size + radius];
  pen.strokeStyle = colours.ink;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.moveTo(x + radius * Math.cos(0.5), y + radius * Math.sin(0.5));
  pen.arc(x, y, radius, 0.5, -Math.PI * 1.0, true);
  pen.stroke();
  pen.fillStyle = colours.ink;
  head(pen, x - radius, y, Math.PI / 2, 4.5);
  label(pen, 'rotation', x + radius + 0.5 * size, y, 'left', 'middle', colours.ink, colours, size);
  const forward = watching ? undefined : subject.motion?.forwardWhirl(subject.station);
  if (forward !== undefined && !subject.motion!.diverged)
    label(
      pen,
      forward ? 'whirl: forward' : 'whirl: backward',
      0.4 * size,
      height - 0.4 * size,
      'left',
      'bottom',
      forward ? colours.ink : colours.backward,
      colours,
      size,
    );
  drawProbe(pen, width - 2, height / 2, Math.PI, 'X', colours, size);
  if (!watching) drawProbe(pen, width / 2, 2, Math.PI / 2, 'Y', colours, size);
}

/// Draws a probe at the edge, pointing inwards.
function drawProbe(pen: Pen, x: number, y: number, angle: number, name: string, colours: Theme, size: number): void {
  pen.fillStyle = colours.muted;
  head(pen, x + 5 * Math.cos(angle), y + 5 * Math.sin(angle), angle, 7);
  pen.font = font(size, 600);
  pen.textAlign = angle === Math.PI ? 'right' : 'left';
  pen.textBaseline = angle === Math.PI ? 'bottom' : 'top';
  pen.fillText(name, x + (angle === Math.PI ? -2 : 9), y + (angle === Math.PI ? -7 : 2));
}
