// How numbers are shown. The engine speaks in length scales, orders and SI; the reader chooses.

export type LengthUnit = 'um' | 'mil' | 'scale';
export type SpeedUnit = 'rpm' | 'rad/s';
export type FrequencyUnit = 'order' | 'Hz';
/// Amplitudes: zero to peak, peak to peak, root mean square (of a sinusoidal component).
export type AmplitudeUnit = '0-p' | 'p-p' | 'rms';

export interface Units {
  length: LengthUnit;
  speed: SpeedUnit;
  frequency: FrequencyUnit;
  amplitude: AmplitudeUnit;
}

export const RPM = 60 / (2 * Math.PI);

/// What lengths and speeds are measured against.
export interface Scales {
  /// m per length scale.
  readonly length: number;
  /// rad/s
  readonly speed: number;
  /// What the length scale is: "c" where a bearing's clearance, "gap" where a stator's, else "L".
  readonly symbol: string;
}

/// Units that suit a machine's length scale [m]: micrometres say nothing of a dimensionless case, whose scale is 1 m.
export function unitsFor(
  length: number,
  others: Pick<Units, 'frequency' | 'amplitude'> = { frequency: 'order', amplitude: '0-p' },
): Units {
  const { frequency, amplitude } = others;
  return length >= 0.1
    ? { length: 'scale', speed: 'rad/s', frequency, amplitude }
    : { length: 'um', speed: 'rpm', frequency, amplitude };
}

/// What the words of a case or a report choose ("um, rpm, Hz, p-p"); of units that the page does not have the nearest.
const WORDS: Readonly<Record<string, Partial<Units>>> = {
  scale: { length: 'scale' },
  ...Object.fromEntries(['m', 'mm', 'um'].map((word) => [word, { length: 'um' }])),
  ...Object.fromEntries(['in', 'mil'].map((word) => [word, { length: 'mil' }])),
  rpm: { speed: 'rpm' },
  'rad/s': { speed: 'rad/s' },
  order: { frequency: 'order' },
  ...Object.fromEntries(['Hz', 'cpm'].map((word) => [word, { frequency: 'Hz' }])),
  ...Object.fromEntries(['0-p', 'p-p', 'rms'].map((word) => [word, { amplitude: word }])),
};

/// Later words go before earlier ones.
export function unitsOfWords(words: string): Partial<Units> {
  return Object.assign({}, ...words.split(',').map((word) => WORDS[word.trim()])) as Partial<Units>;
}

export interface Measure {
  readonly factor: number;
  readonly unit: string;
}

export function lengthMeasure(units: Units, scales: Scales): Measure {
  switch (units.length) {
    case 'um':
      return { factor: scales.length * 1e6, unit: '\u00b5m' };
    case 'mil':
      return { factor: scales.length / 25.4e-6, unit: 'mil' };
    default:
      return { factor: 1, unit: scales.symbol };
  }
}

/// Of a component's amplitude that is given zero to peak.
export function amplitudeMeasure(units: Units, scales: Scales): Measure {
  const length = lengthMeasure(units, scales);
  const factor = { '0-p': 1, 'p-p': 2, rms: Math.SQRT1_2 }[units.amplitude];
  return { factor: length.factor * factor, unit: `${length.unit} ${units.amplitude}` };
}

/// Of the lengths of a field: its meaning says "0-p amplitude" of sinusoids, "0-p" of other distances from the centre,
/// which are so whatever the reader chooses.
export function fieldMeasure(meaning: string, units: Units, scales: Scales): Measure {
  if (meaning.includes('0-p amplitude')) return amplitudeMeasure(units, scales);
  const { factor, unit } = lengthMeasure(units, scales);
  return { factor, unit: meaning.includes('0-p') ? `${unit} 0-p` : unit };
}

export function frequencyMeasure(units: Units, scales: Scales): Measure {
  return units.frequency === 'Hz'
    ? { factor: scales.speed / (2 * Math.PI), unit: 'Hz' }
    : { factor: 1, unit: 'orders' };
}

/// A frequency in rad/s of a machine at rest: in Hz, or in the unit of the speed beside which it stands.
export function naturalMeasure(units: Units): Measure {
  return units.frequency === 'Hz' ? { factor: 1 / (2 * Math.PI), unit: 'Hz' } : parameterMeasure('rad/s', units);
}

/// A parameter's value in SI, as it is shown.
export function parameterMeasure(unit: string, units: Units): Measure {
  if (unit === 'rad/s' || unit === 'rad s-1' || unit === 'rad.s-1')
    return units.speed === 'rpm' ? { factor: RPM, unit: 'rpm' } : { factor: 1, unit: 'rad/s' };
  return { factor: 1, unit: unit === '1' || unit === 'SI' ? '' : unit };
}

/// At most `digits` significant digits, without trailing zeros; powers of ten where they are shorter.
export function shown(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return '\u2013';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(digits - 1) : value.toPrecision(digits);
  const plain = text.includes('e')
    ? text.replace(/\.?0+e/, 'e').replace('e+', 'e')
    : text.includes('.')
      ? text.replace(/\.?0+$/, '')
      : text;
  return plain.replace('-', '\u2212');
}

/// The same, but with all digits before the point: speeds are read so.
export function shownWhole(value: number, digits = 4): string {
  return shown(value, Math.max(digits, Math.min(9, Math.ceil(Math.log10(Math.abs(value) || 1)))));
}

/// A sentence of the core, which writes plain ASCII for terminals, as it is read on a page.
export function readable(sentence: string): string {
  return sentence.replaceAll('+-', '\u00b1');
}

/// The same for a text that a program reads: a plain minus.
export function written(value: number, digits = 9): string {
  return String(Number(value.toPrecision(digits)));
}

/// "name (unit)", or the name alone for a plain number.
export function labelled(name: string, unit: string): string {
  return unit ? `${name} (${unit})` : name;
}
