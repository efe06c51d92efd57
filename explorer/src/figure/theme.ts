// Colours of figures; the style sheet has the same for other elements, and takes the colours of regimes from here. Any
// two regimes differ by at least 16 (CIEDE2000) for every kind of colour vision, by lightness if not by hue. Reports
// have the colours of the light theme (tests/colours.test.mjs).

export interface Theme {
  readonly dark: boolean;
  readonly paper: string;
  readonly ink: string;
  readonly muted: string;
  readonly grid: string;
  readonly frame: string;
  /// Colours of two coordinates, and of the two compared settings.
  readonly x: string;
  readonly y: string;
  readonly a: string;
  readonly b: string;
  readonly forward: string;
  readonly backward: string;
  readonly stator: string;
  readonly clearance: string;
  readonly touch: string;
  readonly keyphasor: string;
  readonly measured: string;
  /// Bands of tolerances.
  readonly band: string;
  readonly contactShade: string;
  /// Colours by regime class.
  readonly classes: readonly string[];
}

export const LIGHT: Theme = {
  dark: false,
  paper: '#ffffff',
  ink: '#1b2430',
  muted: '#5c6773',
  grid: '#e4e8ec',
  frame: '#aab4be',
  x: '#0072b2',
  y: '#c35400',
  a: '#0072b2',
  b: '#b0479a',
  forward: '#0072b2',
  backward: '#c35400',
  stator: '#8a5a00',
  clearance: '#5c6773',
  touch: '#d55e00',
  keyphasor: '#d55e00',
  measured: '#14803c',
  band: '#5c6773',
  contactShade: 'rgba(230,159,0,0.16)',
  classes: ['#366efb', '#1fbadd', '#1d7257', '#664406', '#cc0892', '#000000', '#9a9f95', '#fb8d41'],
};

export const DARK: Theme = {
  dark: true,
  paper: '#14191f',
  ink: '#e6ebf0',
  muted: '#9aa7b4',
  grid: '#27303a',
  frame: '#4b5866',
  x: '#5db4f0',
  y: '#f0913e',
  a: '#5db4f0',
  b: '#e58ad0',
  forward: '#5db4f0',
  backward: '#f0913e',
  stator: '#d9a441',
  clearance: '#9aa7b4',
  touch: '#ff7a2f',
  keyphasor: '#ff9a5a',
  measured: '#58d68d',
  band: '#9aa7b4',
  contactShade: 'rgba(230,159,0,0.13)',
  classes: ['#106af4', '#44aff2', '#137524', '#fdbc0b', '#be018c', '#ffffff', '#99929b', '#f66f6d'],
};

export const CONFIDENCE_NAMES = ['low', 'fair', 'high'] as const;

/// Converts "#rrggbb" to an opaque pixel of an ImageData on a little-endian machine.
export function pixelOf(colour: string): number {
  const number = Number.parseInt(colour.slice(1), 16);
  return (0xff000000 | ((number & 0xff) << 16) | (number & 0xff00) | (number >> 16)) >>> 0;
}
