// A figure drawn on a canvas without uPlot: orbits, maps and circles, with one scale on both axes.
import { el } from '../dom';
import { theme, watchSize, type Figure, type Picture } from './figure';
import { SvgPen, type Pen } from './pen';
import type { Theme } from './theme';

export type Draw = (pen: Pen, width: number, height: number, colours: Theme) => void;

export class Round implements Figure {
  readonly root: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  private width = 0;
  private height = 0;

  constructor(
    private readonly title: string,
    private readonly draw: Draw,
  ) {
    this.canvas = el('canvas', { role: 'img', 'aria-label': title });
    this.root = el('div', { class: 'figure round' }, this.canvas);
    watchSize(this.root, (width, height) => {
      [this.width, this.height] = [width, height];
      this.redraw();
    });
  }

  /// Text of the picture for screen readers.
  set description(text: string) {
    this.canvas.setAttribute('aria-label', `${this.title}: ${text}`);
  }

  redraw(): void {
    if (!this.width) return;
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [Math.round(this.width * ratio), Math.round(this.height * ratio)];
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
      this.canvas.style.width = `${this.width}px`;
      this.canvas.style.height = `${this.height}px`;
    }
    const pen = this.canvas.getContext('2d')!;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, this.width, this.height);
    pen.save();
    this.draw(pen, this.width, this.height, theme());
    pen.restore();
  }

  picture(): Picture {
    const [width, height] = [this.width || 480, this.height || 480];
    const pen = new SvgPen(width, height, this.title);
    const colours = theme();
    pen.fillStyle = colours.paper;
    pen.beginPath();
    pen.rect(0, 0, width, height);
    pen.fill();
    this.draw(pen, width, height, colours);
    return { svg: pen.text(), width, height };
  }
}
