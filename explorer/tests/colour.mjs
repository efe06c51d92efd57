// Simulates how readers with other colour vision see colours, and computes the distance of two colours.
//
// Dichromats: G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, A Physiologically-based Model for Simulation of Color
// Vision Deficiency, IEEE Trans. Vis. Comput. Graph. 15 (2009) 1291, matrices of severity 1.0 for linear RGB. Distance:
// CIEDE2000 with all weights 1, D65.
export const VISIONS = {
  ordinary: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritanopia: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

// IEC 61966-2-1: linear sRGB to XYZ, and the white of D65.
const XYZ = [
  [0.4124564, 0.3575761, 0.1804375],
  [0.2126729, 0.7151522, 0.072175],
  [0.0193339, 0.119192, 0.9503041],
];
const WHITE = [0.95047, 1, 1.08883];

const times = (matrix, vector) => matrix.map((row) => row.reduce((sum, weight, i) => sum + weight * vector[i], 0));
const radians = (degrees) => (degrees * Math.PI) / 180;

/// Converts "#rrggbb" to linear RGB, 0 to 1.
export function linearOf(colour) {
  return [1, 3, 5].map((at) => {
    const value = Number.parseInt(colour.slice(at, at + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
}

/// Returns L*, a*, b* of "#rrggbb" as seen with a kind of colour vision (VISIONS).
export function labOf(colour, vision = 'ordinary') {
  const seen = times(VISIONS[vision], linearOf(colour)).map((value) => Math.min(1, Math.max(0, value)));
  const [x, y, z] = times(XYZ, seen).map((value, i) => {
    const t = value / WHITE[i];
    return t > 216 / 24389 ? Math.cbrt(t) : ((24389 / 27) * t + 16) / 116;
  });
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/// Returns the CIEDE2000 distance of two colours in L*a*b*.
export function distance([L1, a1, b1], [L2, a2, b2]) {
  const high = (chroma) => Math.sqrt(chroma ** 7 / (chroma ** 7 + 25 ** 7));
  const stretch = 1 + 0.5 * (1 - high((Math.hypot(a1, b1) + Math.hypot(a2, b2)) / 2));
  const polar = (a, b) => [Math.hypot(stretch * a, b), ((Math.atan2(b, stretch * a) * 180) / Math.PI + 360) % 360];
  const [C1, h1] = polar(a1, b1);
  const [C2, h2] = polar(a2, b2);
  const grey = C1 * C2 === 0;
  const turn = grey ? 0 : ((h2 - h1 + 540) % 360) - 180;
  const hue = grey ? h1 + h2 : (h1 + turn / 2 + 360) % 360;
  const [dL, dC, dH] = [L2 - L1, C2 - C1, 2 * Math.sqrt(C1 * C2) * Math.sin(radians(turn / 2))];
  const [L, C] = [(L1 + L2) / 2, (C1 + C2) / 2];
  const cos = (factor, shift) => Math.cos(radians(factor * hue + shift));
  const T = 1 - 0.17 * cos(1, -30) + 0.24 * cos(2, 0) + 0.32 * cos(3, 6) - 0.2 * cos(4, -63);
  const SL = 1 + (0.015 * (L - 50) ** 2) / Math.sqrt(20 + (L - 50) ** 2);
  const [SC, SH] = [1 + 0.045 * C, 1 + 0.015 * C * T];
  const RT = -2 * high(C) * Math.sin(radians(60 * Math.exp(-(((hue - 275) / 25) ** 2))));
  return Math.sqrt((dL / SL) ** 2 + (dC / SC) ** 2 + (dH / SH) ** 2 + RT * (dC / SC) * (dH / SH));
}

/// Returns the contrast of two colours after WCAG 2, 1 to 21.
export function contrast(one, other) {
  const [low, high] = [one, other].map((colour) => times(XYZ, linearOf(colour))[1]).sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
}
