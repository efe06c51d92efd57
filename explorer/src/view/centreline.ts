// The shaft centreline: mean position of a station in its clearance circle, and its path along the sweep.
import type { Diagram } from '../data/diagram';
import { font, type Pen } from '../figure/pen';
import { textSize } from '../figure/figure';
import { Round } from '../figure/round';
import type { Theme } from '../figure/theme';
import { lengthMeasure, shown } from '../model/units';
import { Panel, type Subject, type Table } from './panel';
import { FIELD } from '../data/fields';

/// Returns the angle of the line of centres from the load (downwards), in the sense of rotation, degrees from -180 to
/// 180.
export function attitude(x: number, y: number, clockwise: boolean): number {
  return (Math.atan2(clockwise ? -x : x, -y) * 180) / Math.PI;
}

/// Returns the clearance of a point's machine in its length scales; NaN without a bearing.
function clearanceOf(diagram: Diagram, point: number, station: number): number {
  return (
    diagram.number(point, FIELD.ORBIT_MAX_RADIUS, station) / diagram.number(point, FIELD.ORBIT_ECCENTRICITY, station)
  );
}

export class CentrelinePanel extends Panel {
  readonly figure = new Round('Shaft centreline', (pen, width, height, colours) =>
    this.draw(pen, width, height, colours),
  );

  constructor() {
    super('centreline', 'Shaft centreline');
    this.assemble();
  }

  protected refresh(): void {
    this.note.textContent = this.sentence();
    this.figure.description = this.note.textContent;
    this.figure.redraw();
  }

  protected table(): Table {
    const { station, units, scales, diagram, info } = this.subject!;
    const { unit } = lengthMeasure(units, scales);
    const [x, y] = [diagram?.column(FIELD.ORBIT_MEAN, station, 0), diagram?.column(FIELD.ORBIT_MEAN, station, 1)];
    return {
      heading: [
        diagram?.parameter || 'point',
        `mean x [${unit}]`,
        `mean y [${unit}]`,
        'eccentricity ratio',
        'attitude angle [deg]',
      ],
      rows: Array.from(diagram?.values ?? [], (value, i) => {
        const [mx, my] = [x?.data[i] ?? NaN, y?.data[i] ?? NaN];
        // Use the length scale of the machine of each point.
        const { factor } = lengthMeasure(units, { ...scales, length: diagram!.lengthScales[i]! });
        return [
          value,
          mx * factor,
          my * factor,
          Math.hypot(mx, my) / clearanceOf(diagram!, i, station),
          attitude(mx, my, info.clockwise),
        ];
      }),
    };
  }

  private mean(): readonly [number, number] {
    const { motion, station } = this.subject!;
    return motion
      ? [motion.number(FIELD.ORBIT_MEAN, station, 0), motion.number(FIELD.ORBIT_MEAN, station, 1)]
      : [NaN, NaN];
  }

  private sentence(): string {
    const { info, units, scales } = this.subject!;
    const [x, y] = this.mean();
    if (!Number.isFinite(x)) return '';
    const { factor, unit } = lengthMeasure(units, scales);
    const ratio = info.clearance > 0 ? `eccentricity ratio ${shown(Math.hypot(x, y) / info.clearance, 3)}, ` : '';
    return (
      `${ratio}attitude ${shown(attitude(x, y, info.clockwise), 3)}\u00b0, mean (${shown(x * factor, 3)}, ` +
      `${shown(y * factor, 3)}) ${unit}`
    );
  }

  private draw(pen: Pen, width: number, height: number, colours: Theme): void {
    const subject = this.subject;
    if (!subject) return;
    const wall = subject.info.clearance || subject.info.gap || 1;
    const size = textSize();
    const scale = (Math.min(width, height) - 2.2 * size) / (2 * wall);
    const place = (x: number, y: number) => [width / 2 + x * scale, height / 2 - y * scale] as const;
    drawPolar(pen, [width / 2, height / 2], wall * scale, subject, colours, size);
    this.drawPath(pen, subject, place, colours);
    const [x, y] = this.mean();
    if (!Number.isFinite(x)) return;
    const [px, py] = place(x, y);
    pen.strokeStyle = subject.accent(colours);
    pen.lineWidth = 1.4;
    pen.beginPath();
    pen.moveTo(width / 2, height / 2);
    pen.lineTo(px, py);
    pen.stroke();
    pen.fillStyle = subject.accent(colours);
    pen.beginPath();
    pen.moveTo(px + 5, py);
    pen.arc(px, py, 5, 0, 2 * Math.PI);
    pen.fill();
  }

  private drawPath(
    pen: Pen,
    { diagram, station, units, scales }: Subject,
    place: (x: number, y: number) => readonly [number, number],
    colours: Theme,
  ): void {
    const [x, y] = [diagram?.column(FIELD.ORBIT_MEAN, station, 0), diagram?.column(FIELD.ORBIT_MEAN, station, 1)];
    if (!diagram || !x || !y) return;
    diagram.values.forEach((_, point) => {
      const [mx, my] = [x.data[point]!, y.data[point]!];
      if (!diagram.done[point] || !Number.isFinite(mx)) return;
      // Axes in units of length show the displacement. Axes in length scales show it over the length scale of the
      // point's machine.
      const size = units.length === 'scale' ? 1 : diagram.lengthScales[point]! / scales.length;
      const [px, py] = place(mx * size, my * size);
      pen.fillStyle = colours.classes[diagram.classes[point]!]!;
      pen.beginPath();
      pen.rect(px - 1.2, py - 1.2, 2.4, 2.4);
      pen.fill();
    });
  }
}

function drawPolar(
  pen: Pen,
  [x, y]: readonly [number, number],
  radius: number,
  subject: Subject,
  colours: Theme,
  size: number,
): void {
  pen.lineWidth = 1;
  for (const part of [0.25, 0.5, 0.75, 1]) {
    pen.strokeStyle = part === 1 ? colours.clearance : colours.grid;
    pen.lineWidth = part === 1 ? 1.6 : 1;
    pen.beginPath();
    pen.moveTo(x + radius * part, y);
    pen.arc(x, y, radius * part, 0, 2 * Math.PI);
    pen.stroke();
  }
  pen.strokeStyle = colours.grid;
  pen.lineWidth = 1;
  pen.beginPath();
  pen.moveTo(x - radius, y);
  pen.lineTo(x + radius, y);
  pen.moveTo(x, y - radius);
  pen.lineTo(x, y + radius);
  pen.stroke();
  const wall =
    subject.info.clearance > 0 ? 'bearing clearance' : subject.info.gap > 0 ? 'stator gap' : 'one length scale';
  const length = lengthMeasure(subject.units, subject.scales);
  const reach = (subject.info.clearance || subject.info.gap || 1) * length.factor;
  pen.fillStyle = colours.muted;
  pen.font = font(size);
  pen.textAlign = 'left';
  pen.textBaseline = 'top';
  pen.fillText(`${wall} ${shown(reach, 3)} ${length.unit}`, 2, 1);
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  for (const part of [0.5, 1])
    pen.fillText(
      String(part),
      x + radius * part * Math.SQRT1_2 - 0.7 * size,
      y - radius * part * Math.SQRT1_2 + 0.8 * size,
    );
}
