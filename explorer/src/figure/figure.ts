// Interface of all figures of the page, and their theme.
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

/// Returns the size of small text in CSS pixels, which grows with the text of the page.
export function textSize(): number {
  return 0.74 * Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
}

/// Calls `changed` with the size of an element (borders included), at first and after every change, unless it is
/// smaller than `least` pixels.
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
