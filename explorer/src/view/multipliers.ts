// The Floquet multipliers of an orbit with the unit circle; for an equilibrium its eigenvalues with the imaginary axis.
import { el } from '../dom';
import type { Multiplier, OrbitOfBranch } from '../data/orbit';
import { textSize } from '../figure/figure';
import { drawLabels, type Marked } from '../figure/labels';
import { drawMark } from '../figure/marks';
import type { Pen } from '../figure/pen';
import { drawPlane, extent, type Extent, type Plane } from '../figure/plane';
import { Round } from '../figure/round';
import type { Theme } from '../figure/theme';
import { shown } from '../model/units';
import { numbersTable } from './numbers';
import { Panel, type Table } from './panel';

/// Modulus beyond which multipliers are drawn at the rim, so that the unit circle stays large.
const RIM = 2;
/// Largest number of rows of the table on the page; saved data have all rows.
const MAX_ROWS = 8;

function modulus({ real, imaginary }: Multiplier): number {
  return Math.hypot(real, imaginary);
}

/// Returns the angle in degrees.
function angle({ real, imaginary }: Multiplier): number {
  return (Math.atan2(imaginary, real) * 180) / Math.PI;
}

/// Returns "\u22120.46 \u00b1 0.12i".
function textOf({ real, imaginary }: Multiplier): string {
  return imaginary === 0 ? shown(real, 4) : `${shown(real, 4)} \u00b1 ${shown(Math.abs(imaginary), 4)}i`;
}

export class MultipliersPanel extends Panel {
  readonly figure = new Round('Multipliers', (pen, width, height, colours) => this.draw(pen, width, height, colours));
  private readonly rows = el('div', { class: 'numbers', role: 'region', tabindex: 0 });

  constructor() {
    super('multipliers', 'Multipliers');
    this.rows.setAttribute('aria-label', 'Multipliers in numbers');
    this.assemble();
    this.root.append(this.rows);
  }

  private get orbit(): OrbitOfBranch | undefined {
    return this.subject?.motion?.orbit;
  }

  protected refresh(): void {
    const { orbit } = this;
    if (!orbit) return;
    const all = orbit.multipliers;
    const left = all.length - MAX_ROWS;
    this.note.textContent = orbit.rests
      ? 'eigenvalues per radian: unstable to the right of the axis'
      : `Floquet multipliers: unstable outside the circle${left > 0 ? `; ${left} smaller ones are in the data` : ''}`;
    this.figure.description = `${this.note.textContent}; ${orbit.label}`;
    // Show only the first multiplier of a complex pair.
    const rows = all.slice(0, MAX_ROWS).filter(({ imaginary }) => !(imaginary < 0));
    this.rows.replaceChildren(
      numbersTable(
        'Multipliers in numbers',
        orbit.rests ? ['eigenvalue per rad'] : ['multiplier', 'modulus', 'angle (\u00b0)'],
        rows.map((each) => [
          textOf(each) + (each.own ? ' (its own)' : ''),
          ...(orbit.rests ? [] : [shown(modulus(each), 4), shown(angle(each), 4)]),
        ]),
      ),
    );
    this.figure.redraw();
  }

  protected table(): Table {
    const { orbit } = this;
    return {
      heading: ['', 'real', 'imaginary', ...(orbit?.rests ? [] : ['modulus', 'angle (deg)'])],
      rows: (orbit?.multipliers ?? []).map((each, i) => [
        each.own ? 'its own' : String(i + 1),
        each.real,
        each.imaginary,
        ...(orbit!.rests ? [] : [modulus(each), angle(each)]),
      ]),
    };
  }

  private draw(pen: Pen, width: number, height: number, colours: Theme): void {
    const { orbit } = this;
    if (!orbit) return;
    const all = orbit.multipliers;
    const circle = orbit.rests ? 0 : 1;
    const reach = Math.min(RIM, Math.max(circle, ...all.map(modulus)));
    const around: Extent = orbit.rests
      ? extent(
          all.flatMap(({ real, imaginary }) => [real, imaginary, 0]),
          1e-9,
        )
      : { centre: 0, half: 1.15 * reach };
    const plane = drawPlane(pen, [width, height], [around, around], true, ['real', 'imaginary'], colours);
    this.drawBound(pen, plane, circle, colours);
    this.drawPoints(pen, plane, orbit, this.subject!.accent(colours), colours);
  }

  /// Draws the unit circle, or the imaginary axis.
  private drawBound(pen: Pen, { x, y, area }: Plane, radius: number, colours: Theme): void {
    pen.strokeStyle = colours.ink;
    pen.lineWidth = 1.4;
    pen.beginPath();
    if (radius > 0) {
      pen.moveTo(x(radius), y(0));
      pen.arc(x(0), y(0), x(radius) - x(0), 0, 2 * Math.PI);
    } else {
      pen.moveTo(x(0), area.top);
      pen.lineTo(x(0), area.top + area.height);
    }
    pen.stroke();
  }

  /// Draws the multipliers; multipliers that make the orbit unstable have their own form, colour and label.
  private drawPoints(pen: Pen, { x, y, area }: Plane, orbit: OrbitOfBranch, accent: string, colours: Theme): void {
    const labels: Marked[] = [];
    for (const each of orbit.multipliers) {
      const size = modulus(each);
      const outside = !each.own && (orbit.rests ? each.real > 0 : size > 1 + 1e-6);
      const shrink = !orbit.rests && size > RIM ? RIM / size : 1;
      const [px, py] = [x(each.real * shrink), y(each.imaginary * shrink)];
      pen.fillStyle = pen.strokeStyle = outside ? colours.touch : accent;
      pen.lineWidth = 1.5;
      drawMark(pen, shrink < 1 ? 'up' : outside ? 'square' : each.own ? 'ring' : 'dot', px, py, outside ? 5 : 3.6);
      if (outside) labels.push({ x: px, y: py, text: shown(orbit.rests ? each.real : size, 3) });
    }
    drawLabels(pen, labels, area, textSize(), colours);
  }
}
