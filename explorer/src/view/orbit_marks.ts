// Selection of branch orbits on the diagram by the pointer, and rings at the selected ones.
import type { Branches } from '../data/branches';
import { el } from '../dom';
import { heightsOf, type BranchLines } from '../figure/branches';
import type { Chart } from '../figure/chart';
import type { Spot } from './stack';

/// Distance in CSS pixels within which the pointer selects a line.
const NEAR = 7;

/// Returns the squared distance of a spot from the segment between two positions, and the position along it, 0 to 1.
function distance({ left, top }: Spot, a: Spot, b: Spot): readonly [number, number] {
  const [dx, dy] = [b.left - a.left, b.top - a.top];
  const along = ((left - a.left) * dx + (top - a.top) * dy) / (dx * dx + dy * dy || 1);
  const part = Math.min(1, Math.max(0, along));
  return [(left - a.left - part * dx) ** 2 + (top - a.top - part * dy) ** 2, part];
}

export class OrbitMarks {
  /// Element over the plotting area of the chart.
  readonly root = el('div', { class: 'orbit-marks', 'aria-hidden': 'true' });
  private readonly hint = el('div', { class: 'orbit-hint', hidden: true });
  private readonly rings = el('div');
  private lines: BranchLines | undefined;
  private chosen: readonly (number | undefined)[] = [];
  private hovered = -1;
  private placed = '';
  private free = true;

  constructor(private readonly chart: Chart) {
    this.root.append(this.rings, this.hint);
    chart.overlay.append(this.root);
    new ResizeObserver(() => this.place()).observe(chart.overlay);
  }

  /// Sets the lines of branches; undefined: none are drawn.
  show(lines: BranchLines | undefined): void {
    if (lines?.branches !== this.lines?.branches) this.hover(undefined);
    this.lines = lines;
    this.place();
  }

  /// Sets the points of settings A and B, and whether the user may choose other points.
  choose(chosen: readonly (number | undefined)[], free: boolean): void {
    this.chosen = chosen;
    this.free = free;
    this.place();
  }

  /// Branches whose orbits can be chosen.
  get branches(): Branches | undefined {
    return this.free ? this.lines?.branches : undefined;
  }

  /// Returns the point that a spot selects, which is the nearer end of the nearest segment; -1 without one.
  at(spot: Spot): number {
    const { lines } = this;
    if (!lines || !this.free) return -1;
    let [best, found] = [NEAR * NEAR, -1];
    const width = this.chart.area.width;
    for (const { points } of lines.branches.pieces) {
      let before = this.spotsOf(points[0]!);
      for (let i = 1; i < points.length; i++) {
        const now = this.spotsOf(points[i]!);
        for (let line = 0; line < Math.min(before.length, now.length); line++) {
          const [away, part] = distance(spot, before[line]!, now[line]!);
          if (!(away < best)) continue;
          const near = lines.branches.nearestStored(points[part < 0.5 ? i - 1 : i]!);
          const left = near < 0 ? NaN : (this.spotsOf(near)[0]?.left ?? NaN);
          if (left > -1 && left < width + 1) [best, found] = [away, near];
        }
        before = now;
      }
    }
    return found;
  }

  /// Shows the orbit that a click would select.
  hover(spot: Spot | undefined): void {
    this.hovered = spot ? this.at(spot) : -1;
    const orbit = this.lines?.branches.orbit(this.hovered);
    this.hint.hidden = !orbit;
    if (orbit && spot) {
      this.hint.textContent = orbit.label;
      const room = this.chart.area.width - this.hint.offsetWidth;
      this.hint.style.left = `${Math.max(0, Math.min(spot.left + 14, room))}px`;
      this.hint.style.top = `${spot.top > 40 ? spot.top - 38 : spot.top + 18}px`;
    }
    this.place();
  }

  /// Returns the positions of a point on its lines.
  private spotsOf(point: number): Spot[] {
    const { lines, chart } = this;
    if (!lines) return [];
    const left = chart.placeOf(lines.branches.diagram.values[point]! * lines.valueFactor);
    return heightsOf(lines, point).map((height) => ({ left, top: chart.heightOf(height) }));
  }

  private place(): void {
    const marks = [
      ...this.chosen.map((point, side) => [point, `orbit-mark side-${side === 0 ? 'a' : 'b'}`] as const),
      [this.hovered < 0 ? undefined : this.hovered, 'orbit-mark hovered'] as const,
    ];
    const { width } = this.chart.area;
    const places = marks.flatMap(([point, kind]) =>
      (point === undefined ? [] : this.spotsOf(point))
        .filter(({ left }) => left > -1 && left < width + 1)
        .map(({ left, top }) => ({ kind, transform: `translate(${left}px, ${top}px)` })),
    );
    // Rebuild only after a change: diagrams grow many times a second.
    const text = JSON.stringify(places);
    if (text === this.placed) return;
    this.placed = text;
    this.rings.replaceChildren(
      ...places.map(({ kind, transform }) => {
        const ring = el('div', { class: kind });
        ring.style.transform = transform;
        return ring;
      }),
    );
  }
}
