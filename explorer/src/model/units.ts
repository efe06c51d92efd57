// Units of displayed numbers. The engine uses length scales, orders and SI; the user chooses the units.

/// `own`: the unit that the report chose, if it is none of the page's own units.
export type LengthUnit = 'um' | 'mil' | 'scale' | 'own';
export type SpeedUnit = 'rpm' | 'rad/s';
export type FrequencyUnit = 'order' | 'Hz' | 'own';
/// Amplitudes: zero to peak, peak to peak, root mean square (of a sinusoidal component).
export type AmplitudeUnit = '0-p' | 'p-p' | 'rms';

export interface Units {
  length: LengthUnit;
  speed: SpeedUnit;
  frequency: FrequencyUnit;
  amplitude: AmplitudeUnit;
  /// Units that the report chose.
  shown?: ShownUnits;
}

/// A unit of the library: a number in SI over `size` is shown.
export interface Unit {
  readonly unit: string;
  readonly size: number;
}

/// Units that a report or its case chose (`write_units` of src/report/explorer.c); the page chooses the units that are
/// absent.
export interface ShownUnits {
  readonly amplitude: AmplitudeUnit;
  readonly length?: Unit;
  /// True if lengths are multiples of the length scale.
  readonly scale: boolean;
  /// Unit of positions along a shaft.
  readonly position?: Unit;
  readonly speed?: Unit;
  /// Its size is in Hz.
  readonly frequency?: Unit;
  /// Units of parameters by their SI units.
  readonly parameters: Readonly<Record<string, Unit>>;
}

export const RPM = 60 / (2 * Math.PI);

/// Scales of lengths and speeds.
export interface Scales {
  /// m per length scale.
  readonly length: number;
  /// rad/s
  readonly speed: number;
  /// Symbol of the length scale: "c" for a bearing's clearance, "gap" for a stator's gap, else "L".
  readonly symbol: string;
}

/// Returns units that suit a machine's length scale [m]; micrometres would be meaningless for a dimensionless case,
/// whose scale is 1 m.
export function unitsFor(
  length: number,
  others: Pick<Units, 'frequency' | 'amplitude'> = { frequency: 'order', amplitude: '0-p' },
): Units {
  const { frequency, amplitude } = others;
  return length >= 0.1
    ? { length: 'scale', speed: 'rad/s', frequency, amplitude }
    : { length: 'um', speed: 'rpm', frequency, amplitude };
}

/// Returns the units that a report chose, as units of the page.
export function unitsOfReport(shown: ShownUnits | undefined): Partial<Units> {
  if (!shown) return {};
  const { length, speed, frequency, amplitude } = shown;
  const lengths: Readonly<Record<string, LengthUnit>> = { '\u00b5m': 'um', mil: 'mil' };
  return {
    shown,
    amplitude,
    ...(shown.scale && { length: 'scale' }),
    ...(length && { length: lengths[length.unit] ?? 'own' }),
    ...(speed && { speed: speed.unit as SpeedUnit }),
    ...(frequency && { frequency: frequency.unit === 'Hz' ? 'Hz' : 'own' }),
  };
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
      if (units.length === 'own' && units.shown?.length)
        return { factor: scales.length / units.shown.length.size, unit: units.shown.length.unit };
      return { factor: 1, unit: scales.symbol };
  }
}

/// Returns the measure of amplitudes, which are given zero to peak, from the measure of displacements.
export function amplitudeOf({ factor, unit }: Measure, { amplitude }: Units): Measure {
  return { factor: factor * { '0-p': 1, 'p-p': 2, rms: Math.SQRT1_2 }[amplitude], unit: `${unit} ${amplitude}` };
}

/// Returns the measure of the amplitude of a component, which is given zero to peak.
export function amplitudeMeasure(units: Units, scales: Scales): Measure {
  return amplitudeOf(lengthMeasure(units, scales), units);
}

/// Returns the measures of displacements and of amplitudes that are given in m, as measured numbers are.
export function metreMeasures(units: Units, scales: Scales): { readonly length: Measure; readonly amplitude: Measure } {
  const { factor, unit } = lengthMeasure(units, scales);
  const length = { factor: factor / scales.length, unit };
  return { length, amplitude: amplitudeOf(length, units) };
}

/// Returns the measure of a field's lengths. In its meaning "0-p amplitude" marks sinusoids; "0-p" marks distances from
/// the centre, which do not depend on the chosen amplitude unit.
export function fieldMeasure(meaning: string, units: Units, scales: Scales): Measure {
  if (meaning.includes('0-p amplitude')) return amplitudeMeasure(units, scales);
  const { factor, unit } = lengthMeasure(units, scales);
  return { factor, unit: meaning.includes('0-p') ? `${unit} 0-p` : unit };
}

/// Returns Hz or the unit that the report chose for frequencies; undefined for orders.
function hertz(units: Units): Unit | undefined {
  if (units.frequency === 'order') return undefined;
  return (units.frequency === 'own' && units.shown?.frequency) || { unit: 'Hz', size: 1 };
}

export function frequencyMeasure(units: Units, scales: Scales): Measure {
  const own = hertz(units);
  return own ? { factor: scales.speed / (2 * Math.PI * own.size), unit: own.unit } : { factor: 1, unit: 'orders' };
}

/// Returns the measure of a frequency in rad/s of a machine at rest: Hz, or the unit of the speed.
export function naturalMeasure(units: Units): Measure {
  const own = hertz(units);
  return own ? { factor: 1 / (2 * Math.PI * own.size), unit: own.unit } : parameterMeasure('rad/s', units);
}

/// Returns the measure of a parameter's value in SI.
export function parameterMeasure(unit: string, units: Units): Measure {
  if (unit === 'rad/s' || unit === 'rad s-1' || unit === 'rad.s-1')
    return units.speed === 'rpm' ? { factor: RPM, unit: 'rpm' } : { factor: 1, unit: 'rad/s' };
  const chosen = chosenUnit(unit, units);
  return chosen
    ? { factor: 1 / chosen.size, unit: chosen.unit }
    : { factor: 1, unit: unit === '1' || unit === 'SI' ? '' : unit };
}

/// Returns the measure of positions along a shaft.
export function positionMeasure({ shown }: Units): Measure {
  const { unit, size } = shown?.position ?? { unit: 'mm', size: 1e-3 };
  return { factor: 1 / size, unit };
}

/// Returns the unit that the report chose for parameters with an SI unit.
export function chosenUnit(unit: string, { shown }: Units): Unit | undefined {
  return shown && Object.hasOwn(shown.parameters, unit) ? shown.parameters[unit] : undefined;
}

/// Returns a number with at most `digits` significant digits, without trailing zeros; with a power of ten if that is
/// shorter.
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

/// Returns a number as `shown` does, but with all digits before the point, for speeds.
export function shownWhole(value: number, digits = 4): string {
  return shown(value, Math.max(digits, Math.min(9, Math.ceil(Math.log10(Math.abs(value) || 1)))));
}

/// Converts a sentence of the core (ASCII for terminals) for the page.
export function readable(sentence: string): string {
  return sentence.replaceAll('+-', '\u00b1');
}

/// Returns a number as a text that programs can read, with an ASCII minus.
export function written(value: number, digits = 9): string {
  return String(Number(value.toPrecision(digits)));
}

/// Returns "name (unit)", or only the name for a plain number.
export function labelled(name: string, unit: string): string {
  return unit ? `${name} (${unit})` : name;
}
