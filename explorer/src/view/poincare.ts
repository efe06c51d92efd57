// The Poincare map: the state once per revolution, at the mark.
import { select } from '../dom';
import { textSize } from '../figure/figure';
import { font, type Pen } from '../figure/pen';
import { Round } from '../figure/round';
import type { Theme } from '../figure/theme';
import { linearTicks, niceStep, tickText } from '../figure/ticks';
import { lengthMeasure } from '../model/units';
import { Panel, type Table } from './panel';

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
    this.note.textContent = count ? `${count} revolutions, one dot each, at the mark` : '';
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
    const size = textSize();
    const area = { left: 5.2 * size, top: 0.8 * size, width: width - 6.2 * size, height: height - 4 * size };
    const least = 0.04 * Math.max(subject.motion.number('orbit/max_radius', subject.station), 1e-12) * factor;
    const equal = this.plane[1] === 'y';
    const h = extent(across, factor, least);
    const v = extent(up, factor, least);
    if (equal) {
      const perPixel = Math.max(h.half / area.width, v.half / area.height);
      h.half = perPixel * area.width;
      v.half = perPixel * area.height;
    }
    const x = (value: number) => area.left + (area.width * (value - h.centre + h.half)) / (2 * h.half);
    const y = (value: number) => area.top + (area.height * (v.centre + v.half - value)) / (2 * v.half);
    const name = (coordinate: Coordinate) =>
      coordinate.startsWith('v') ? `${coordinate[1]}\u2032 (${unit}/rad)` : `${coordinate} (${unit})`;
    drawAxes(pen, area, [h, v], [x, y], [name(this.plane[0]), name(this.plane[1])], height, colours, size);
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

interface Extent {
  centre: number;
  half: number;
}

function extent(values: Float64Array, factor: number, least: number): Extent {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    low = Math.min(low, value * factor);
    high = Math.max(high, value * factor);
  }
  return { centre: (low + high) / 2, half: Math.max(0.58 * (high - low), least) };
}

function drawAxes(
  pen: Pen,
  area: { left: number; top: number; width: number; height: number },
  [h, v]: readonly [Extent, Extent],
  [x, y]: readonly [(value: number) => number, (value: number) => number],
  [xName, yName]: readonly [string, string],
  height: number,
  colours: Theme,
  size: number,
): void {
  const [right, bottom] = [area.left + area.width, area.top + area.height];
  const wanted = [area.width / (6 * size), area.height / (3.5 * size)] as const;
  const ticks = [
    linearTicks(h.centre - h.half, h.centre + h.half, wanted[0]),
    linearTicks(v.centre - v.half, v.centre + v.half, wanted[1]),
  ] as const;
  pen.lineWidth = 1;
  pen.strokeStyle = colours.grid;
  pen.beginPath();
  for (const tick of ticks[0]) {
    pen.moveTo(x(tick), area.top);
    pen.lineTo(x(tick), bottom);
  }
  for (const tick of ticks[1]) {
    pen.moveTo(area.left, y(tick));
    pen.lineTo(right, y(tick));
  }
  pen.stroke();
  pen.strokeStyle = colours.frame;
  pen.beginPath();
  pen.moveTo(area.left, area.top);
  pen.lineTo(area.left, bottom);
  pen.lineTo(right, bottom);
  pen.stroke();
  pen.fillStyle = colours.muted;
  pen.font = font(size);
  pen.textAlign = 'center';
  pen.textBaseline = 'top';
  for (const tick of ticks[0]) pen.fillText(tickText(tick, niceStep(2 * h.half, wanted[0])), x(tick), bottom + 5);
  pen.textAlign = 'right';
  pen.textBaseline = 'middle';
  for (const tick of ticks[1]) pen.fillText(tickText(tick, niceStep(2 * v.half, wanted[1])), area.left - 6, y(tick));
  pen.textAlign = 'center';
  pen.fillText(xName, area.left + area.width / 2, height - 0.8 * size);
  pen.save();
  pen.translate(0.8 * size, area.top + area.height / 2);
  pen.rotate(-Math.PI / 2);
  pen.fillText(yName, 0, 0);
  pen.restore();
}
