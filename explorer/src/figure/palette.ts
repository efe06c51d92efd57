// Colours of numbers, for all kinds of colour vision: viridis for rising numbers, blue to vermilion around zero.
// Reports have the colours of the light theme.
import type { Theme } from './theme';

const RISING = ['#440154', '#46327e', '#365c8d', '#277f8e', '#1fa187', '#4ac16d', '#a0da39', '#fde725'];
const AROUND_LIGHT = ['#0072b2', '#f1f1f1', '#d55e00'];
const AROUND_DARK = ['#3da2e8', '#2b333c', '#ff7a2f'];

export type Palette = 'rising' | 'around';

function partsOf(colour: string): readonly number[] {
  const number = Number.parseInt(colour.slice(1), 16);
  return [number >> 16, (number >> 8) & 0xff, number & 0xff];
}

/// Returns "#rrggbb" at a share, 0 to 1, between two colours.
export function mixed(one: string, other: string, part: number): string {
  const [a, b] = [partsOf(one), partsOf(other)];
  const sum = a.reduce((all, value, i) => all * 256 + Math.round(value + (b[i]! - value) * part), 0);
  return `#${sum.toString(16).padStart(6, '0')}`;
}

/// Returns the colour at a share of a palette, 0 to 1; outside, the colour of the end.
export function colourAt(palette: Palette, part: number, theme: Theme): string {
  const stops = palette === 'rising' ? RISING : theme.dark ? AROUND_DARK : AROUND_LIGHT;
  const at = Math.min(1, Math.max(0, part)) * (stops.length - 1);
  const from = Math.min(stops.length - 2, Math.floor(at));
  return mixed(stops[from]!, stops[from + 1]!, at - from);
}

/// The colours of Okabe and Ito, in an order in which neighbours also differ in lightness; whirl's reports have the
/// same.
const OF_ATTRACTORS = ['#0072b2', '#e69f00', '#56b4e9', '#009e73', '#cc79a7', '#d55e00', '#f0e442'];

/// Returns the colour of an attractor by its number, from 1; for 0 (unknown) a muted colour.
export function attractorColour(number: number, theme: Theme): string {
  if (number === 0) return mixed(theme.paper, theme.muted, 0.35);
  return [...OF_ATTRACTORS, theme.ink][(number - 1) % (OF_ATTRACTORS.length + 1)]!;
}
