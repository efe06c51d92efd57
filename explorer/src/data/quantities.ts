// Quantities that a diagram can show over the parameter.
import type { StationInfo } from '../engine/protocol';
import { fieldMeasure, lengthMeasure, type Units } from '../model/units';
import type { Column, Diagram, FieldInfo } from './diagram';
import { FIELD } from './fields';

export interface Quantity {
  /// Name in the address of the page.
  readonly id: string;
  readonly text: string;
  /// True for a quantity of one station, false for one of the whole machine.
  readonly perStation: boolean;
  /// The field that the quantity shows under a better name.
  readonly field?: string;
  /// True if the quantity needs spectra; diagrams are computed without spectra unless it is shown.
  readonly spectra?: boolean;
}

export const QUANTITIES: readonly Quantity[] = [
  { id: 'x', text: 'x once per revolution', perStation: true },
  { id: 'y', text: 'y once per revolution', perStation: true },
  { id: 'radius', text: 'Largest radius', perStation: true, field: FIELD.ORBIT_MAX_RADIUS },
  { id: 'eccentricity', text: 'Eccentricity ratio', perStation: true, field: FIELD.ORBIT_ECCENTRICITY },
  { id: 'contact', text: 'Contact share', perStation: false, field: FIELD.RUB_SHARE },
  { id: 'exponent', text: 'Largest exponent', perStation: false },
  { id: 'backward', text: 'Backward whirl share', perStation: true, field: FIELD.ORBIT_BACKWARD },
  { id: '1x', text: '1X amplitude of x', perStation: true, spectra: true },
  { id: '1y', text: '1X amplitude of y', perStation: true, spectra: true },
  { id: '1xlag', text: '1X phase lag of x', perStation: true, spectra: true },
  { id: '1ylag', text: '1X phase lag of y', perStation: true, spectra: true },
];

/// Pattern of the name of a quantity that is a column of a field not in the list: "orbit/min_radius", "orbit/mean:1".
export const OF_A_FIELD = /^[a-z_]{1,40}\/[a-z_0-9]{1,40}(:\d)?$/;

/// "mean x", "min radius".
function wordsOf({ name, meaning, columns }: FieldInfo, column: number): string {
  const words = name.replace(/.*\//, '').replaceAll('_', ' ');
  return columns > 1 ? `${words} ${meaning.replace(/ \(.*/, '').split(', ')[column] ?? column}` : words;
}

function quantitiesOfField(field: FieldInfo): Quantity[] {
  return Array.from({ length: field.columns }, (_, column) => {
    const words = wordsOf(field, column);
    return {
      id: field.columns > 1 ? `${field.name}:${column}` : field.name,
      text: `${words.charAt(0).toUpperCase()}${words.slice(1)} (${field.name.replace(/\/.*/, '')})`,
      perStation: field.extent === 'station',
    };
  });
}

/// Returns the quantities of the list, and all other single numbers of stations and contacts in a diagram.
export function quantitiesOf(diagram: Diagram | undefined): readonly Quantity[] {
  const listed = new Set(QUANTITIES.map(({ field }) => field));
  const others = Array.from(diagram?.fields.values() ?? []).filter(
    ({ name, extent, rows }) =>
      rows === 1 && extent !== 'point' && !name.startsWith('spectrum/') && !listed.has(name) && OF_A_FIELD.test(name),
  );
  return [...QUANTITIES, ...others.flatMap(quantitiesOfField)];
}

export function needsSpectra(id: string): boolean {
  return QUANTITIES.find((quantity) => quantity.id === id)?.spectra ?? false;
}

export interface ShownQuantity {
  readonly column: Column;
  readonly factor: number;
  readonly label: string;
  /// True for lengths.
  readonly length?: boolean;
}

/// Converts lengths of a diagram to the shown unit, each from the length scale of the point's machine.
function shownLengths(
  diagram: Diagram,
  column: Column,
  units: Units,
): { readonly column: Column; readonly factor: number } {
  const { factor } = lengthMeasure(units, { length: 1, speed: 1, symbol: '' });
  if (units.length === 'scale') return { column, factor };
  const common = diagram.lengthScale;
  if (Number.isFinite(common)) return { column, factor: factor * common };
  const data = column.data.map((value, i) => value * diagram.lengthScales[Math.floor(i / column.rows)]!);
  return { column: { rows: column.rows, data }, factor };
}

/// Returns a column of a field of lengths of a station, with all rows, in the shown unit.
export function lengthsOf(diagram: Diagram, field: string, station: number, column: number, units: Units) {
  const found = diagram.column(field, station, column);
  return found && shownLengths(diagram, found, units);
}

function largestOfContacts(diagram: Diagram, field: string, column: number, label: string): ShownQuantity | undefined {
  if (!diagram.column(field, 0, column)) return undefined;
  const data = Float32Array.from(diagram.values, (_, point) =>
    diagram.done[point] ? diagram.largest(point, field, column) : NaN,
  );
  return { column: { rows: 1, data }, factor: 1, label };
}

/// Returns the numbers of a quantity with their scale and axis label; undefined if the diagram has none. `symbol`: the
/// length scale.
export function quantityOf(
  diagram: Diagram,
  id: string,
  station: number,
  stations: readonly StationInfo[],
  units: Units,
  symbol: string,
): ShownQuantity | undefined {
  const name = stations[station]?.name ?? '';
  const made = (
    field: string,
    which: number,
    column: number,
    factor: number,
    label: string,
  ): ShownQuantity | undefined => {
    const found = diagram.column(field, which, column);
    return found && { column: found, factor, label };
  };
  const length = (field: string, column: number, what: string): ShownQuantity | undefined => {
    const found = diagram.column(field, station, column);
    if (!found) return undefined;
    const meaning = diagram.fields.get(field)?.meaning ?? '';
    const counted = fieldMeasure(meaning, { ...units, length: 'scale' }, { length: 1, speed: 1, symbol }).factor;
    const { unit } = fieldMeasure(meaning, units, { length: 1, speed: 1, symbol });
    const { column: shownColumn, factor } = shownLengths(diagram, found, units);
    return { column: shownColumn, factor: factor * counted, label: `${what} of ${name} (${unit})`, length: true };
  };
  const quantityOfField = (): ShownQuantity | undefined => {
    const [field = '', number = '0'] = id.split(':');
    const info = diagram.fields.get(field);
    const column = Number(number);
    if (!info || info.rows !== 1 || column >= info.columns) return undefined;
    const text = info.columns > 1 ? wordsOf(info, column) : info.meaning.replace(/ \(.*/, '');
    const label = info.unit === 'force' ? `${text} (N)` : text;
    if (info.extent === 'contact') return largestOfContacts(diagram, field, column, label);
    if (info.unit === 'length') return length(field, column, text);
    return made(field, station, column, 1, `${label} of ${name}`);
  };
  switch (id) {
    case 'x':
    case 'y':
      return length(FIELD.POINCARE_SECTION, id === 'x' ? 0 : 1, id);
    case 'radius':
      return length(FIELD.ORBIT_MAX_RADIUS, 0, 'largest radius');
    case 'eccentricity':
      return made(FIELD.ORBIT_ECCENTRICITY, station, 0, 1, `eccentricity ratio of ${name}`);
    case 'contact':
      return largestOfContacts(diagram, FIELD.RUB_SHARE, 0, 'share of the time in contact');
    case 'exponent':
      return (
        made(FIELD.LYAPUNOV_LARGEST, 0, 0, 1, 'exponent per revolution') ??
        made(FIELD.REGIME_EXPONENT, 0, 0, 1, 'exponent per revolution')
      );
    case 'backward':
      return made(FIELD.ORBIT_BACKWARD, station, 0, 1, `backward whirl of ${name}, share of the time`);
    case '1x':
    case '1y':
      return length(FIELD.SPECTRUM_SYNCHRONOUS, id === '1x' ? 0 : 1, `1X amplitude of ${id.slice(1)}`);
    case '1xlag':
    case '1ylag':
      return made(
        FIELD.SPECTRUM_SYNCHRONOUS_LAG,
        station,
        id === '1xlag' ? 0 : 1,
        1,
        `1X phase lag of ${id.charAt(1)} of ${name} (degrees)`,
      );
    default:
      return quantityOfField();
  }
}
