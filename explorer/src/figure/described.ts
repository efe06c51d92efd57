// Draws figures that the library describes (docs/figures.md) as SVG, by panels, axes and series.
import { escaped, FONT } from './pen';
import type { Picture } from './figure';

type Numbers = readonly (number | null)[];

interface DescribedSeries {
  readonly shape: 'dots' | 'line' | 'area' | 'bars' | 'boxes' | 'texts';
  readonly name: string;
  readonly colour: string;
  readonly opacity: number;
  /// pt: the diameter of marks, the width of lines.
  readonly size: number;
  readonly mark?: string;
  readonly dashed?: boolean;
  readonly side?: string;
  readonly x?: Numbers;
  readonly y?: Numbers;
  readonly x_to?: Numbers;
  readonly y_to?: Numbers;
  readonly values?: Numbers;
  readonly texts?: readonly string[];
}

interface DescribedAxis {
  readonly label: string;
  readonly low: number;
  readonly high: number;
  readonly log: boolean;
  readonly shown: boolean;
  readonly ticks?: readonly number[];
  readonly tick_texts?: readonly string[];
}

/// A part of a panel that shows a station.
interface DescribedSpot {
  readonly station: string;
  /// Left, right, bottom and top in units of the axes.
  readonly box: readonly [number, number, number, number];
}

interface DescribedPanel {
  readonly name: string;
  readonly title: string;
  readonly letter: string;
  readonly box: readonly [number, number, number, number];
  readonly legend_inside: boolean;
  readonly x: DescribedAxis;
  readonly y: DescribedAxis;
  readonly series: readonly DescribedSeries[];
  readonly spots?: readonly DescribedSpot[];
}

interface DescribedScale {
  readonly label: string;
  readonly low: number;
  readonly high: number;
  readonly log: boolean;
  readonly colours: readonly string[];
  readonly ticks?: readonly number[];
  readonly tick_texts?: readonly string[];
}

export interface Described {
  readonly name: string;
  readonly title: string;
  readonly caption: string;
  readonly width_cm: number;
  readonly height_cm: number;
  readonly font_pt: number;
  readonly panels: readonly DescribedPanel[];
  readonly scale?: DescribedScale;
}

/// Pixels of a centimetre and of a point, 1.6 times as large as on paper, as screens are farther away.
const CM = (1.6 * 96) / 2.54;
const PT = (1.6 * 96) / 72;

const short = (value: number) => String(Math.round(value * 100) / 100);

/// Returns the position of a value on an axis, 0 to 1; NaN if the axis cannot show it.
function shareOf({ low, high, log }: DescribedAxis | DescribedScale, value: number | null | undefined): number {
  if (value === null || value === undefined) return NaN;
  if (log) return value > 0 ? Math.log(value / low) / Math.log(high / low) : NaN;
  return (value - low) / (high - low);
}

/// Returns a label as SVG text: symbols between dollars in italics with subscripts, lines one below the other.
function markedUp(label: string, size: number, x: number): string {
  const line = (text: string) =>
    text
      .split('$')
      .map((part, i) => {
        if (i % 2 === 0) return escaped(part);
        const [, letter = part, below = ''] = /^(.*?)_\{(.*)\}$/.exec(part) ?? [];
        const drop = short(0.25 * size);
        const index = below
          ? `<tspan font-size="${short(0.72 * size)}" dy="${drop}">${escaped(below)}</tspan>` +
            `<tspan dy="-${drop}">\u200b</tspan>`
          : '';
        return `<tspan font-style="italic">${escaped(letter)}</tspan>${index}`;
      })
      .join('');
  const lines = label.split('\n');
  return lines.length === 1
    ? line(label)
    : lines
        .map((text, i) => `<tspan x="${short(x)}" dy="${i ? short(1.15 * size) : 0}">${line(text)}</tspan>`)
        .join('');
}

function textAt(x: number, y: number, label: string, size: number, attributes: string): string {
  const words = markedUp(label, size, x);
  return `<text x="${short(x)}" y="${short(y)}" font-size="${short(size)}" ${attributes}>${words}</text>`;
}

/// A panel's box on the page, and positions in it.
class Place {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;

  constructor(
    figure: Described,
    private readonly panel: DescribedPanel,
  ) {
    const [left, right, bottom, top] = panel.box;
    this.left = left * figure.width_cm * CM;
    this.width = (right - left) * figure.width_cm * CM;
    this.top = (1 - top) * figure.height_cm * CM;
    this.height = (top - bottom) * figure.height_cm * CM;
  }

  x(value: number | null | undefined): number {
    return this.left + shareOf(this.panel.x, value) * this.width;
  }

  /// Returns true if a position is within the box, to rounding.
  holds(x: number, y: number): boolean {
    const [right, bottom] = [this.left + this.width, this.top + this.height];
    return x >= this.left - 0.01 && x <= right + 0.01 && y >= this.top - 0.01 && y <= bottom + 0.01;
  }

  y(value: number | null | undefined): number {
    return this.top + (1 - shareOf(this.panel.y, value)) * this.height;
  }
}

/// Returns the colour of a number, interpolated between colours of the scale.
function colourOf(scale: DescribedScale, value: number | null | undefined): string | undefined {
  const share = shareOf(scale, value);
  if (Number.isNaN(share)) return undefined;
  const at = Math.min(Math.max(share, 0), 1) * (scale.colours.length - 1);
  const [from, to] = [scale.colours[Math.floor(at)]!, scale.colours[Math.ceil(at)]!];
  const part = (k: number) => {
    const [a, b] = [from, to].map((colour) => parseInt(colour.slice(1 + 2 * k, 3 + 2 * k), 16));
    return Math.round(a! + (b! - a!) * (at - Math.floor(at)));
  };
  return `rgb(${part(0)},${part(1)},${part(2)})`;
}

function markAt(x: number, y: number, series: DescribedSeries, least = 0): string {
  const { mark, size, colour } = series;
  const r = (Math.max(size, least) * PT) / 2;
  const open = mark === 'ring' || mark === 'frame';
  const look = open ? `fill="none" stroke="${colour}" stroke-width="${short(0.6 * PT)}"` : filled(series);
  const path = (points: readonly (readonly [number, number])[], end = 'Z') =>
    `<path d="M${points.map(([dx, dy]) => `${short(x + dx * r)},${short(y + dy * r)}`).join('L')}${end}" ${look}/>`;
  if (mark === 'square' || mark === 'frame') return path([[-1, -1], [1, -1], [1, 1], [-1, 1]]); // prettier-ignore
  if (mark === 'up') return path([[0, -1], [1, 0.8], [-1, 0.8]]); // prettier-ignore
  if (mark === 'down') return path([[0, 1], [1, -0.8], [-1, -0.8]]); // prettier-ignore
  if (mark === 'diamond') return path([[0, -1], [1, 0], [0, 1], [-1, 0]]); // prettier-ignore
  if (mark === 'cross')
    return (
      `<path d="M${short(x - r)},${short(y - r)}L${short(x + r)},${short(y + r)}M${short(x - r)},${short(y + r)}` +
      `L${short(x + r)},${short(y - r)}" fill="none" stroke="${colour}" stroke-width="${short(0.6 * PT)}"/>`
    );
  return `<circle cx="${short(x)}" cy="${short(y)}" r="${short(r)}" ${look}/>`;
}

/// Returns a path through points, broken at missing points.
function lineThrough(points: readonly (readonly [number, number])[]): string {
  let path = '';
  let open = false;
  for (const [x, y] of points) {
    const there = Number.isFinite(x) && Number.isFinite(y);
    if (there) path += `${open ? 'L' : 'M'}${short(x)},${short(y)}`;
    open = there;
  }
  return path;
}

function rectangle(x: number, y: number, width: number, height: number, look: string): string {
  const [left, top, right, up] = [x, y, width, height].map(short);
  return `<rect x="${left}" y="${top}" width="${right}" height="${up}" ${look}/>`;
}

/// Returns the attributes of a line, with a least width in points.
function drawnAs({ colour, opacity, size, dashed }: DescribedSeries, least = 0): string {
  const dashes = dashed ? ` stroke-dasharray="${short(4 * PT)} ${short(2.5 * PT)}"` : '';
  const width = short(Math.max(least, size) * PT);
  return `fill="none" stroke="${colour}" stroke-opacity="${opacity}" stroke-width="${width}"${dashes}`;
}

function filled({ colour, opacity }: DescribedSeries): string {
  return `fill="${colour}" fill-opacity="${opacity}"`;
}

/// Divides points into runs without missing points.
function runs<T extends readonly number[]>(points: readonly T[]): T[][] {
  const found: T[][] = [[]];
  for (const point of points)
    if (point.every(Number.isFinite)) found.at(-1)!.push(point);
    else if (found.at(-1)!.length > 0) found.push([]);
  return found.filter((run) => run.length > 0);
}

const SIDES: Readonly<Record<string, readonly [number, number, string]>> = {
  above: [0, -2, 'middle'],
  below: [0, 8, 'middle'],
  left: [-3, -2, 'end'],
  right: [3, 8, 'start'],
  slanted: [1, -2, 'start'],
  beside: [3, 3, 'start'],
};

function drawSeries(place: Place, series: DescribedSeries, scale: DescribedScale | undefined, font: number): string {
  const { colour, opacity, shape } = series;
  const count = series.x?.length ?? 0;
  const at = Array.from({ length: count }, (_, i) => [place.x(series.x![i]), place.y(series.y![i])] as const);
  const stroke = drawnAs(series);
  const to = (i: number) => place.y(series.y_to?.[i]);
  const there = at.map((point, i) => [...point, i] as const).filter((point) => point.every(Number.isFinite));
  if (shape === 'dots')
    return there
      .filter(([x, y]) => place.holds(x, y))
      .map(([x, y]) => markAt(x, y, series))
      .join('');
  if (shape === 'line') return `<path d="${lineThrough(at)}" ${stroke}/>`;
  if (shape === 'bars')
    return `<path d="${there.map(([x, y, i]) => `M${short(x)},${short(y)}V${short(to(i))}`).join('')}" ${stroke}/>`;
  if (shape === 'area')
    return runs(at.map(([x, y], i) => [x, y, to(i)] as const))
      .map((run) => {
        const back = [...run].reverse().map(([x, , up]) => [x, up] as const);
        const path = lineThrough([...run.map(([x, y]) => [x, y] as const), ...back]);
        return `<path d="${path}Z" ${filled(series)}/>`;
      })
      .join('');
  if (shape === 'boxes')
    return there
      .map(([x, y, i]) => {
        const own = series.values && scale ? colourOf(scale, series.values[i]) : colour;
        if (!own) return '';
        const [right, top] = [place.x(series.x_to?.[i]), to(i)];
        const [width, height] = [Math.abs(right - x), Math.abs(top - y)];
        const look = `fill="${own}" fill-opacity="${opacity}"`;
        return rectangle(Math.min(x, right), Math.min(y, top), width, height, look);
      })
      .join('');
  const [dx, dy, anchor] = SIDES[series.side ?? 'above'] ?? SIDES['above']!;
  return there
    .map(([x, y, i]) => {
      const turn = series.side === 'slanted' ? ` transform="rotate(-60 ${short(x)} ${short(y)})"` : '';
      return textAt(
        x + dx * PT,
        y + dy * PT,
        series.texts?.[i] ?? '',
        font,
        `text-anchor="${anchor}" fill="${colour}"${turn}`,
      );
    })
    .join('');
}

function drawAxes(place: Place, { x, y, title, letter }: DescribedPanel, font: number): string {
  const { left, top, width, height } = place;
  const near = 0.9 * font;
  const tick = 2.5 * PT;
  const thin = `stroke="#000" stroke-width="${short(0.5 * PT)}"`;
  let out = rectangle(left, top, width, height, `fill="none" ${thin}`);
  (x.ticks ?? []).forEach((value, i) => {
    const at = place.x(value);
    out += `<path d="M${short(at)},${short(top + height)}v${short(tick)}" ${thin}/>`;
    if (x.shown) out += textAt(at, top + height + tick + near, x.tick_texts?.[i] ?? '', near, 'text-anchor="middle"');
  });
  let widest = 0;
  (y.ticks ?? []).forEach((value, i) => {
    const at = place.y(value);
    const text = y.tick_texts?.[i] ?? '';
    widest = Math.max(widest, text.length);
    out += `<path d="M${short(left)},${short(at)}h${short(-tick)}" ${thin}/>`;
    if (y.shown) out += textAt(left - 1.5 * tick, at + 0.35 * near, text, near, 'text-anchor="end"');
  });
  if (x.shown && x.label)
    out += textAt(left + width / 2, top + height + tick + near + 1.35 * font, x.label, font, 'text-anchor="middle"');
  if (y.shown && y.label) {
    const [at, middle] = [left - 2.5 * tick - 0.64 * near * widest, top + height / 2];
    const low = height < 0.7 * CM;
    const lines = y.label.split('\n').length - 1;
    out += low
      ? textAt(left - 1.5 * tick, middle + 0.35 * font, y.label, font, 'text-anchor="end"')
      : textAt(
          at - lines * 1.15 * font,
          middle,
          y.label,
          font,
          `text-anchor="middle" transform="rotate(-90 ${short(at)} ${short(middle)})"`,
        );
  }
  const heading = [letter && `(${letter})`, title].filter(Boolean).join('  ');
  if (heading) out += textAt(left, top - 0.35 * font, heading, near, 'text-anchor="start"');
  return out;
}

/// Returns the named series, each name once.
function named(panels: readonly DescribedPanel[]): DescribedSeries[] {
  const found = new Map<string, DescribedSeries>();
  for (const panel of panels)
    for (const series of panel.series) if (series.name && !found.has(series.name)) found.set(series.name, series);
  return [...found.values()];
}

function drawLegend(list: readonly DescribedSeries[], right: number, top: number, font: number): string {
  const width = (series: DescribedSeries) => 2.2 * font + 0.58 * font * series.name.length + 0.8 * font;
  let [x, y, out] = [0, top, ''];
  for (const series of list) {
    if (x > 0 && x + width(series) > right) [x, y] = [0, y + 1.4 * font];
    const [left, middle] = [x + 0.4 * font, y + 0.7 * font];
    if (series.shape === 'dots') out += markAt(left + 0.8 * font, middle, series, 3);
    else if (series.shape === 'boxes' || series.shape === 'area')
      out += rectangle(left, middle - 0.35 * font, 1.4 * font, 0.7 * font, filled(series));
    else out += `<path d="M${short(left)},${short(middle)}h${short(1.6 * font)}" ${drawnAs(series, 0.8)}/>`;
    out += textAt(left + 2 * font, middle + 0.35 * font, series.name, 0.9 * font, 'text-anchor="start"');
    x += width(series);
  }
  return out;
}

function drawScale(figure: Described, scale: DescribedScale, font: number): string {
  const low = Math.min(...figure.panels.map(({ box }) => box[2]));
  const high = Math.max(...figure.panels.map(({ box }) => box[3]));
  const [left, width] = [(figure.width_cm - 1.85) * CM, 0.35 * CM];
  const [top, height] = [(1 - high) * figure.height_cm * CM, (high - low) * figure.height_cm * CM];
  const STEPS = 128;
  let out = '';
  for (let i = 0; i < STEPS; i++) {
    const share = (i + 0.5) / STEPS;
    const value = scale.log
      ? scale.low * (scale.high / scale.low) ** share
      : scale.low + share * (scale.high - scale.low);
    const at = top + height * (1 - (i + 1) / STEPS);
    out += rectangle(left, at, width, height / STEPS + 0.5, `fill="${colourOf(scale, value)}"`);
  }
  (scale.ticks ?? []).forEach((value, i) => {
    const at = top + (1 - shareOf(scale, value)) * height;
    out += textAt(
      left + width + 3 * PT,
      at + 0.32 * font,
      scale.tick_texts?.[i] ?? '',
      0.9 * font,
      'text-anchor="start"',
    );
  });
  const [x, y] = [left + width + 1.25 * CM, top + height / 2];
  return out + textAt(x, y, scale.label, font, `text-anchor="middle" transform="rotate(-90 ${short(x)} ${short(y)})"`);
}

/// Draws the hot spots of a panel: one button for each station, for pointer and keyboard.
function drawSpots(place: Place, { spots = [] }: DescribedPanel): string {
  return spots
    .map(({ station, box: [left, right, bottom, top] }) => {
      const [x, y] = [place.x(left), place.y(top)];
      const name = escaped(station);
      const look = `class="spot" role="button" tabindex="0" aria-pressed="false" data-station="${name}"`;
      const [width, height] = [place.x(right) - x, place.y(bottom) - y].map(short);
      return (
        `<rect x="${short(x)}" y="${short(y)}" width="${width}" height="${height}" rx="3" ${look} ` +
        `aria-label="Select station ${name}"><title>${name}</title></rect>`
      );
    })
    .join('');
}

export const hasSpots = ({ panels }: Described) => panels.some(({ spots }) => spots && spots.length > 0);

/// Returns the picture of a figure on white; `touched`: with its hot spots.
export function pictureOfDescribed(figure: Described, touched = false): Picture {
  const [width, height, font] = [figure.width_cm * CM, figure.height_cm * CM, figure.font_pt * PT];
  const clips = figure.panels.map((panel, i) => {
    const { left, top, width, height } = new Place(figure, panel);
    const clip = rectangle(left, top, width, height, '');
    return `<clipPath id="${escaped(figure.name)}-${i}">${clip}</clipPath>`;
  });
  const panels = figure.panels.map((panel, i) => {
    const place = new Place(figure, panel);
    const texts = panel.series.filter(({ shape }) => shape === 'texts');
    const rest = panel.series.filter(({ shape }) => shape !== 'texts');
    const clip = `clip-path="url(#${escaped(figure.name)}-${i})"`;
    // Clip all series at the frame, except marks and texts.
    const drawn = (list: readonly DescribedSeries[]) =>
      list
        .map((series) => {
          const svg = drawSeries(place, series, figure.scale, 0.9 * font);
          return series.shape === 'dots' || series.shape === 'texts' ? svg : `<g ${clip}>${svg}</g>`;
        })
        .join('');
    const inside = panel.legend_inside ? named([panel]) : [];
    const legend = inside.length
      ? `<g transform="translate(${short(place.left + 0.3 * font)} 0)">` +
        `${drawLegend(inside, place.width, place.top + 2, 0.9 * font)}</g>`
      : '';
    return (
      drawn(rest) + drawn(texts) + drawAxes(place, panel, font) + legend + (touched ? drawSpots(place, panel) : '')
    );
  });
  const outside = named(figure.panels.filter((panel) => !panel.legend_inside));
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" width="${short(width)}" height="${short(height)}" ` +
    `viewBox="0 0 ${short(width)} ${short(height)}" role="${touched ? 'group' : 'img'}" ` +
    `font-family="${escaped(FONT)}">` +
    `<title>${escaped(figure.title)}</title>${rectangle(0, 0, width, height, 'fill="#fff"')}` +
    `<defs>${clips.join('')}</defs>` +
    panels.join('\n') +
    drawLegend(outside, width - 2, 3, font) +
    (figure.scale ? drawScale(figure, figure.scale, font) : '') +
    '</svg>\n';
  return { svg, width, height };
}

/// Returns all numbers of the figure as a table.
export function tableOfDescribed({ panels }: Described): {
  readonly heading: readonly string[];
  readonly rows: readonly (readonly (number | string)[])[];
} {
  const rows = panels.flatMap(({ name, series }) =>
    series.flatMap((one) =>
      (one.x ?? []).map((x, i) => [
        name,
        one.name,
        x ?? '',
        one.x_to?.[i] ?? '',
        one.y?.[i] ?? '',
        one.y_to?.[i] ?? '',
        one.values?.[i] ?? one.texts?.[i] ?? '',
      ]),
    ),
  );
  return { heading: ['panel', 'series', 'x', 'x to', 'y', 'y to', 'value'], rows };
}
