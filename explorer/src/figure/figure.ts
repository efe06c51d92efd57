// What every figure of the page can do, and the theme that all of them are drawn in.
import { DARK, LIGHT, type Theme } from './theme';

export interface Picture {
  readonly svg: string;
  readonly width: number;
  readonly height: number;
}

export interface Figure {
  readonly root: HTMLElement;
  redraw(): void;
  picture(): Picture;
}

let current: Theme = LIGHT;

export function theme(): Theme {
  return current;
}

export function setDark(dark: boolean): void {
  current = dark ? DARK : LIGHT;
}

/// Size of small text in CSS pixels; it grows with the page's.
export function textSize(): number {
  return 0.74 * Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
}

/// Calls `changed` with the inner size of the element, at once and whenever it changes; not while it is smaller than
/// `least` pixels.
export function watchSize(host: HTMLElement, changed: (width: number, height: number) => void, least = 40): void {
  let width = 0;
  let height = 0;
  const look = () => {
    const box = host.getBoundingClientRect();
    const [newWidth, newHeight] = [Math.floor(box.width), Math.floor(box.height)];
    if (newWidth < least || newHeight < least || (newWidth === width && newHeight === height)) return;
    [width, height] = [newWidth, newHeight];
    changed(width, height);
  };
  new ResizeObserver(() => requestAnimationFrame(look)).observe(host);
}
