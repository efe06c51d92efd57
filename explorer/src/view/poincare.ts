// The Poincare map: the state once per revolution, at the mark.
import { select } from '../dom';
import type { Pen } from '../figure/pen';
import { drawPlane, extent } from '../figure/plane';
import { Round } from '../figure/round';
import type { Theme } from '../figure/theme';
import { lengthMeasure } from '../model/units';
import { Panel, type Table } from './panel';
import { FIELD } from '../data/fields';

type Coordinate = 'x' | 'y' | 'vx' | 'vy';

const PLANES = [
  { value: 'x y', text: 'x, y' },
  { value: 'x vx', text: 'x, x\u2032' },
  { value: 'y vy', text: 'y, y\u2032' },
] as const;

export class PoincarePanel extends Panel {
  readonly figure = new Round('Poincar\u00e9 map', (pen, width, height, colours) =>
    this.draw(pen, width, height, colours),
  );
  private plane: readonly [Coordinate, Coordinate] = ['x', 'y'];

  constructor() {
    super('poincare', 'Poincar\u00e9 map');
    this.assemble(
      select('Plane of the map', PLANES, 'x y', (value) => {
        this.plane = value.split(' ') as [Coordinate, Coordinate];
        this.figure.redraw();
      }),
    );
  }

  protected refresh(): void {
    const { motion, station } = this.subject!;
    const count = motion?.section(station).x.length ?? 0;
    const round = motion?.orbit?.revolutions ?? 0;
    this.note.textContent = motion?.orbit?.rests
      ? 'at rest'
      : round > 0
        ? `${round} dot${round > 1 ? 's' : ''}, where the orbit is at the mark`
        : count
          ? `${count} revolutions, one dot each, at the mark`
          : '';
    this.figure.description = this.note.textContent;
    this.figure.redraw();
  }

  protected table(): Table {
    const { motion, station, units, scales } = this.subject!;
    const { factor, unit } = lengthMeasure(units, scales);
    const section = motion?.section(station);
    return {
      heading: [`x [${unit}]`, `y [${unit}]`, `vx [${unit}/rad]`, `vy [${unit}/rad]`],
      rows: Array.from(section?.x ?? [], (x, i) => [
        x * factor,
        section!.y[i]! * factor,
        section!.vx[i]! * factor,
        section!.vy[i]! * factor,
      ]),
    };
  }

  private draw(pen: Pen, width: number, height: number, colours: Theme): void {
    const subject = this.subject;
    if (!subject?.motion) return;
    const { factor, unit } = lengthMeasure(subject.units, subject.scales);
    const section = subject.motion.section(subject.station);
    const [across, up] = [section[this.plane[0]], section[this.plane[1]]];
    if (!across.length) return;
    const least = 0.04 * Math.max(subject.motion.number(FIELD.ORBIT_MAX_RADIUS, subject.station), 1e-12) * factor;
    const name = (coordinate: Coordinate) =>
      coordinate.startsWith('v') ? `${coordinate[1]}\u2032 (${unit}/rad)` : `${coordinate} (${unit})`;
    const { area, x, y } = drawPlane(
      pen,
      [width, height],
      [extent(scaled(across, factor), least), extent(scaled(up, factor), least)],
      this.plane[1] === 'y',
      [name(this.plane[0]), name(this.plane[1])],
      colours,
    );
    pen.save();
    pen.beginPath();
    pen.rect(area.left, area.top, area.width, area.height);
    pen.clip();
    pen.fillStyle = subject.accent(colours);
    const radius = across.length > 600 ? 1.1 : across.length > 150 ? 1.6 : 2.4;
    pen.beginPath();
    for (let i = 0; i < across.length; i++) {
      const [px, py] = [x(across[i]! * factor), y(up[i]! * factor)];
      pen.moveTo(px + radius, py);
      pen.arc(px, py, radius, 0, 2 * Math.PI);
    }
    pen.fill();
    pen.restore();
  }
}

function scaled(values: Float64Array, factor: number): Float64Array {
  return values.map((value) => value * factor);
}
