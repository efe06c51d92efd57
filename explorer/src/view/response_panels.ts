// Pictures of the response of one station to unbalance: polar diagram, orbit at the cursor, and rest positions.
import { largestOf, senseOf, swayAt, whirlOf, WHIRL_TEXT, reachOf, seenBy } from '../data/rest';
import { drawMark } from '../figure/marks';
import { drawDots, radiusOf } from '../figure/measured';
import type { Pen } from '../figure/pen';
import { drawPlane, extent, type Plane } from '../figure/plane';
import { Round } from '../figure/round';
import type { Theme } from '../figure/theme';
import { amplitudeMeasure, labelled, lengthMeasure, parameterMeasure, shown, written } from '../model/units';
import type { SwaySubject } from './along_shaft';
import { measuredOf, responseOf } from './bode';
import { Panel, type Table } from './panel';
import { probeOf, whirlColour, type RestSubject } from './rest_subject';
import { key } from './waveform';

const RADIAN = Math.PI / 180;

type Path = readonly (readonly [number, number])[];

function clipped(pen: Pen, { area }: Plane, draw: () => void): void {
  pen.save();
  pen.beginPath();
  pen.rect(area.left, area.top, area.width, area.height);
  pen.clip();
  draw();
  pen.restore();
}

function stroke(pen: Pen, { x, y }: Plane, path: Path, colour: string, dash: readonly number[] = []): void {
  pen.strokeStyle = colour;
  pen.lineWidth = 1.5;
  pen.setLineDash([...dash]);
  pen.beginPath();
  path.forEach(([a, b], i) => (i > 0 ? pen.lineTo : pen.moveTo).call(pen, x(a), y(b)));
  pen.stroke();
  pen.setLineDash([]);
}

/// Polar diagram: amplitude and lag as a vector. Lag is counted against the rotation, clockwise; the first probe's axis
/// points to the right.
export class PolarPanel extends Panel<SwaySubject> {
  readonly figure = new Round('Polar diagram', (pen, width, height, colours) => this.draw(pen, width, height, colours));

  constructor() {
    super('polar', 'Polar diagram');
    this.assemble();
  }

  protected refresh(): void {
    const probe = probeOf(this.subject!);
    this.note.replaceChildren(
      key(`probe at ${written(probe, 4)}\u00b0`, 'key-x'),
      key(`at ${written(probe + 90, 4)}\u00b0`, 'key-y'),
      document.createTextNode('the lag grows against the rotation'),
    );
    this.figure.description = this.note.textContent ?? '';
    this.figure.redraw();
  }

  protected table(): Table {
    const { parameter, unit, units, scales } = this.subject!;
    const { values, amplitudes, lags } = responseOf(this.subject!);
    const amplitude = amplitudeMeasure(units, scales).unit;
    const heading = ['first', 'second'].flatMap((which) => [`${which} probe (${amplitude})`, 'its lag (deg)']);
    return {
      heading: [labelled(parameter, parameterMeasure(unit, units).unit), ...heading],
      rows: values.map((value, i) => [value, ...[0, 1].flatMap((which) => [amplitudes[which]![i]!, lags[which]![i]!])]),
    };
  }

  private draw(pen: Pen, width: number, height: number, colours: Theme): void {
    const subject = this.subject;
    if (!subject) return;
    const { points, amplitudes, lags } = responseOf(subject);
    const vector = (which: number, i: number) => {
      const [size, lag] = [amplitudes[which]![i]!, (lags[which]![i]! || 0) * RADIAN];
      return [size * Math.cos(lag), -size * Math.sin(lag)] as const;
    };
    const paths = [0, 1].map((which) => points.map((_, i) => vector(which, i)));
    const measured = measuredOf(subject).map(({ which, amplitudes, lags: late }) => ({
      which,
      path: late.map(({ y: lag }, i) => {
        const size = amplitudes[i]!.y;
        return [size * Math.cos(lag * RADIAN), -size * Math.sin(lag * RADIAN)] as const;
      }),
    }));
    const all = [...paths.flat(), ...measured.flatMap(({ path }) => path), [0, 0] as const];
    const least = largestOf(amplitudes[2]!, 1e-300) / 10;
    const { unit } = amplitudeMeasure(subject.units, subject.scales);
    const plane = drawPlane(
      pen,
      [width, height],
      [
        extent(
          all.map(([x]) => x),
          least,
        ),
        extent(
          all.map(([, y]) => y),
          least,
        ),
      ],
      true,
      [`lag 0\u00b0 (${unit})`, `lag 270\u00b0 (${unit})`],
      colours,
    );
    clipped(pen, plane, () => {
      stroke(pen, plane, paths[1]!, colours.y, [7, 4]);
      stroke(pen, plane, paths[0]!, colours.x);
      for (const { which, path } of measured)
        drawDots(
          pen,
          path.map(([x, y]) => [plane.x(x), plane.y(y)] as const),
          radiusOf(path.length, 200),
          which === 0 ? colours.x : colours.y,
          colours.paper,
        );
      const at = points.indexOf(subject.point);
      if (at < 0) return;
      for (const which of [1, 0]) {
        const colour = which === 0 ? colours.x : colours.y;
        stroke(pen, plane, [[0, 0], paths[which]![at]!], colour);
        pen.fillStyle = colour;
        drawMark(
          pen,
          which === 0 ? 'dot' : 'square',
          plane.x(paths[which]![at]![0]),
          plane.y(paths[which]![at]![1]),
          4.5,
        );
      }
    });
  }
}

/// The synchronous orbit of one station at the cursor.
export class SynchronousOrbitPanel extends Panel<SwaySubject> {
  readonly figure = new Round('1X orbit', (pen, width, height, colours) => this.draw(pen, width, height, colours));

  constructor() {
    super('synchronous', '1X orbit');
    this.assemble();
  }

  protected refresh(): void {
    const { rest, point, station, units, scales } = this.subject!;
    const sway = rest.response(point, station);
    const { factor, unit } = amplitudeMeasure(units, scales);
    const [major, minor] = [reachOf(sway), Math.hypot(sway.xc + sway.ys, sway.yc - sway.xs) - reachOf(sway)];
    this.note.textContent = Number.isFinite(major)
      ? `${WHIRL_TEXT[whirlOf(senseOf(sway))]}, axes ${shown(major * factor, 4)} and ` +
        `${shown(Math.abs(minor) * factor, 4)} ${unit}`
      : '';
    this.figure.description = this.note.textContent;
    this.figure.redraw();
  }

  protected table(): Table {
    const { units, scales } = this.subject!;
    const { unit } = lengthMeasure(units, scales);
    return { heading: ['turn', `x (${unit})`, `y (${unit})`], rows: this.path().map(([x, y], i) => [i / 72, x, y]) };
  }

  private path(): Path {
    const { rest, point, station, units, scales } = this.subject!;
    const sway = rest.response(point, station);
    const { factor } = lengthMeasure(units, scales);
    return Array.from({ length: 73 }, (_, i) => {
      const [x, y] = swayAt(sway, (2 * Math.PI * i) / 72);
      return [x * factor, y * factor] as const;
    });
  }

  private draw(pen: Pen, width: number, height: number, colours: Theme): void {
    const subject = this.subject;
    if (!subject) return;
    const path = this.path();
    const { unit } = lengthMeasure(subject.units, subject.scales);
    const least =
      largestOf(
        path.map(([x, y]) => Math.hypot(x, y)),
        1e-300,
      ) / 2;
    const plane = drawPlane(
      pen,
      [width, height],
      [
        extent(
          path.map(([x]) => x),
          least,
        ),
        extent(
          path.map(([, y]) => y),
          least,
        ),
      ],
      true,
      [`x (${unit})`, `y (${unit})`],
      colours,
    );
    clipped(pen, plane, () => {
      const sway = subject.rest.response(subject.point, subject.station);
      // Draw a gap and a bright end, which show the direction of whirl.
      stroke(pen, plane, path.slice(0, -6), whirlColour(whirlOf(senseOf(sway)), colours));
      pen.fillStyle = colours.keyphasor;
      drawMark(pen, 'dot', plane.x(path[0]![0]), plane.y(path[0]![1]), 4.5);
      const probe = probeOf(subject) * RADIAN;
      const reach = largestOf(path.map(([x, y]) => Math.hypot(x, y)));
      for (const [which, angle] of [probe, probe + Math.PI / 2].entries())
        stroke(
          pen,
          plane,
          [
            [0, 0],
            [reach * Math.cos(angle), reach * Math.sin(angle)],
          ],
          which === 0 ? colours.x : colours.y,
          [2, 3],
        );
    });
  }
}

/// Rest positions of the station over the parameter.
export class RestPanel extends Panel<SwaySubject> {
  readonly figure = new Round('Shaft centreline', (pen, width, height, colours) =>
    this.draw(pen, width, height, colours),
  );

  constructor() {
    super('rest', 'Shaft centreline');
    this.assemble();
  }

  protected refresh(): void {
    const { rest, point, info, units, scales, station } = this.subject!;
    const [x, y] = rest.rest(point, station);
    const { factor, unit } = lengthMeasure(units, scales);
    // Show rounding errors as 0.
    const part = (value: number) => shown(Math.abs(value) > 1e-12 * Math.hypot(x, y) ? value * factor : 0, 4);
    const ratio = info.clearance > 0 ? `eccentricity ratio ${shown(Math.hypot(x, y) / info.clearance, 3)}, ` : '';
    this.note.textContent = Number.isFinite(x) ? `${ratio}at rest (${part(x)}, ${part(y)}) ${unit}` : '';
    this.figure.description = this.note.textContent;
    this.figure.redraw();
  }

  protected table(): Table {
    const { rest, parameter, unit, units, scales } = this.subject!;
    const length = lengthMeasure(units, scales).unit;
    const value = parameterMeasure(unit, units);
    const path = this.path();
    return {
      heading: [labelled(parameter, value.unit), `x (${length})`, `y (${length})`],
      rows: rest.order.map((point, i) => [rest.diagram.values[point]! * value.factor, ...path[i]!]),
    };
  }

  private path(): Path {
    const { rest, station, units, scales } = this.subject!;
    return rest.order.map((point) => {
      const { factor } = lengthMeasure(units, { ...scales, length: rest.diagram.lengthScales[point]! });
      const [x, y] = rest.rest(point, station);
      return [x * factor, y * factor] as const;
    });
  }

  private draw(pen: Pen, width: number, height: number, colours: Theme): void {
    const subject = this.subject;
    if (!subject) return;
    const path = this.path();
    const length = lengthMeasure(subject.units, subject.scales);
    const wall = subject.info.clearance * length.factor;
    const around: Path =
      wall > 0
        ? [
            [-wall, -wall],
            [wall, wall],
          ]
        : path;
    // Choose extents in which a path that is much smaller than its distance from the centre is a point.
    const size = largestOf(path.map(([x, y]) => Math.hypot(x, y)));
    const least = size > 0 ? 0.02 * size : 1;
    const plane = drawPlane(
      pen,
      [width, height],
      [
        extent(
          around.map(([x]) => x),
          least,
        ),
        extent(
          around.map(([, y]) => y),
          least,
        ),
      ],
      true,
      [`x (${length.unit})`, `y (${length.unit})`],
      colours,
    );
    clipped(pen, plane, () => {
      if (wall > 0) {
        pen.strokeStyle = colours.clearance;
        pen.lineWidth = 1.6;
        pen.beginPath();
        pen.moveTo(plane.x(wall), plane.y(0));
        pen.arc(plane.x(0), plane.y(0), plane.x(wall) - plane.x(0), 0, 2 * Math.PI);
        pen.stroke();
      }
      stroke(pen, plane, path, colours.x);
      const [x, y] = path[subject.rest.order.indexOf(subject.point)] ?? [NaN, NaN];
      pen.fillStyle = colours.a;
      if (Number.isFinite(x)) drawMark(pen, 'dot', plane.x(x), plane.y(y), 4.5);
    });
  }
}

/// Returns the texts of amplitudes and lags of a station, as probes see them, for a table.
export function seenTexts(subject: RestSubject, station: number): string[] {
  const { rest, point, units, scales } = subject;
  const sway = rest.response(point, station);
  const { factor } = amplitudeMeasure(units, scales);
  const probes = [0, 90].map((more) => seenBy(sway, probeOf(subject) + more));
  return [
    ...probes.flatMap(({ amplitude, lag }) => [shown(amplitude * factor, 4), shown(lag, 4)]),
    shown(reachOf(sway) * factor, 4),
    WHIRL_TEXT[whirlOf(senseOf(sway))],
  ];
}
