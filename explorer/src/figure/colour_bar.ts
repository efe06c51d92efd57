// A bar of colours with their numbers.
import { partOf, type MapNumbers } from '../data/map_quantities';
import { el } from '../dom';
import { textSize, theme, watchSize } from './figure';
import { colourAt } from './palette';
import { font, textWidth, type Pen } from './pen';
import type { Theme } from './theme';
import { linearTicks, niceStep, tickText } from './ticks';

const PARTS = 96;

function ticksOf({ low, high, logarithmic }: MapNumbers, wanted: number): { at: number[]; text: string[] } {
  if (logarithmic) {
    const at: number[] = [];
    for (let value = low; value <= high * (1 + 1e-9); value *= 2) at.push(value);
    const every = Math.ceil(at.length / Math.max(2, wanted));
    const some = at.filter((_, i) => i % every === 0);
    return { at: some, text: some.map(String) };
  }
  const step = niceStep(high - low, wanted);
  const at = linearTicks(low, high, wanted);
  return { at, text: at.map((value) => tickText(value, step)) };
}

export class ColourBar {
  readonly root = el('div', { class: 'figure colour-bar', 'aria-hidden': 'true' });
  private readonly canvas = el('canvas');
  private scale: MapNumbers | undefined;

  constructor() {
    this.root.append(this.canvas);
    watchSize(this.root, () => this.redraw(), 16);
  }

  show(scale: MapNumbers | undefined): void {
    this.scale = scale;
    this.root.hidden = scale === undefined;
    this.redraw();
  }

  redraw(): void {
    const box = this.root.getBoundingClientRect();
    const [width, height] = [Math.floor(box.width), Math.floor(box.height)];
    const pen = this.canvas.getContext('2d');
    if (!pen || !this.scale || width < 40) return;
    const ratio = window.devicePixelRatio || 1;
    [this.canvas.width, this.canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    [this.canvas.style.width, this.canvas.style.height] = [`${width}px`, `${height}px`];
    pen.scale(ratio, ratio);
    this.sketch(pen, 0, width, theme());
  }

  /// Height of the bar in CSS pixels.
  static get height(): number {
    return Math.ceil(textSize() * 4);
  }

  /// Draws the bar with a pen in CSS pixels.
  sketch(pen: Pen, top: number, width: number, colours: Theme): void {
    const { scale } = this;
    if (!scale) return;
    const size = textSize();
    const [left, long, thick] = [4.6 * size, Math.max(20, width - 6.2 * size), 0.9 * size];
    for (let i = 0; i < PARTS; i++) {
      pen.fillStyle = colourAt(scale.palette, (i + 0.5) / PARTS, colours);
      pen.beginPath();
      pen.rect(left + (long * i) / PARTS, top + 1, long / PARTS + (i + 1 < PARTS ? 0.6 : 0), thick);
      pen.fill();
    }
    pen.font = font(size);
    pen.textBaseline = 'top';
    pen.textAlign = 'center';
    pen.fillStyle = colours.muted;
    const { at, text } = ticksOf(scale, long / (size * 5));
    at.forEach((value, i) => {
      const half = textWidth(text[i]!, pen.font) / 2;
      pen.fillText(
        text[i]!,
        Math.min(width - half - 1, Math.max(half + 1, left + long * partOf(scale, value))),
        top + thick + 0.3 * size,
      );
    });
    pen.fillStyle = colours.ink;
    pen.fillText(scale.label, left + long / 2, top + thick + 1.6 * size);
  }
}
