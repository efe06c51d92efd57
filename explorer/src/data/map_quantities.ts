// Quantities of a map's cells: regime, period, and every quantity of diagrams that has one number for each point.
import type { StationInfo } from '../engine/protocol';
import type { Units } from '../model/units';
import type { Diagram } from './diagram';
import type { ParameterMap } from './parameter_map';
import { quantitiesOf, quantityOf, type Quantity } from './quantities';
import { FIELD } from './fields';

/// Limit of the colour scale of exponents: stronger growth and decay have the colours of its ends.
const MAX_EXPONENT = 0.5;
const PERIODIC = 1;

/// Numbers of the points, with their colour scale.
export interface MapNumbers {
  readonly label: string;
  /// [points], NaN for points without a number.
  readonly numbers: Float64Array;
  /// 'rising' for numbers from low to high, 'around' for numbers around zero.
  readonly palette: 'rising' | 'around';
  /// The numbers at the lower and the upper end of the palette.
  readonly low: number;
  readonly high: number;
  /// True if colours change with the logarithm of the number.
  readonly logarithmic: boolean;
}

export const REGIME: Quantity = { id: 'regime', text: 'Regime', perStation: false };
export const ATTRACTOR: Quantity = { id: 'attractor', text: 'Attractor', perStation: false };
const PERIOD: Quantity = { id: 'period', text: 'Period', perStation: false };

/// Ids, in addresses, of the quantities that only maps have. All other quantities are those of diagrams
/// (quantities.ts).
export const MAP_QUANTITIES: readonly string[] = [ATTRACTOR.id, REGIME.id, PERIOD.id];

/// Returns the quantity that a map shows by default.
export function firstQuantityOf(map: ParameterMap): string {
  return map.attractors.length > 0 ? ATTRACTOR.id : REGIME.id;
}

/// Returns the quantities for which the points have numbers.
export function mapQuantitiesOf(map: ParameterMap): readonly Quantity[] {
  const { diagram } = map;
  const units: Units = { length: 'scale', speed: 'rad/s', frequency: 'order', amplitude: '0-p' };
  const there = quantitiesOf(diagram).filter(({ id }) => {
    const column = quantityOf(diagram, id, 0, [], units, '')?.column;
    return column?.rows === 1 && column.data.some(Number.isFinite);
  });
  const judged = diagram.column(FIELD.REGIME_CODE) !== undefined;
  const attractors = map.attractors.length > 0 ? [ATTRACTOR] : [];
  return [...attractors, ...(judged ? [REGIME, PERIOD] : []), ...there];
}

/// Returns the period of a periodic motion in revolutions.
function periodOf(diagram: Diagram, point: number): number {
  return diagram.number(point, FIELD.REGIME_CODE) === PERIODIC ? diagram.number(point, FIELD.REGIME_PERIOD) : NaN;
}

function rangeOf(numbers: Float64Array): readonly [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const number of numbers) {
    if (Number.isNaN(number)) continue;
    low = Math.min(low, number);
    high = Math.max(high, number);
  }
  return low <= high ? [low, high] : [0, 1];
}

function periods(diagram: Diagram): MapNumbers {
  const numbers = Float64Array.from({ length: diagram.count }, (_, point) => periodOf(diagram, point));
  const high = Math.max(2, rangeOf(numbers)[1]);
  return {
    label: 'k of P-k (others blank)',
    numbers,
    palette: 'rising',
    low: 1,
    high,
    logarithmic: true,
  };
}

/// Returns the numbers of a quantity; undefined for regimes, and for quantities that the points lack.
export function mapNumbersOf(
  diagram: Diagram,
  id: string,
  station: number,
  stations: readonly StationInfo[],
  units: Units,
  symbol: string,
): MapNumbers | undefined {
  if (id === PERIOD.id) return periods(diagram);
  const found = quantityOf(diagram, id, station, stations, units, symbol);
  if (!found || found.column.rows !== 1) return undefined;
  const numbers = Float64Array.from(found.column.data, (value, point) =>
    diagram.done[point] ? value * found.factor : NaN,
  );
  const [low, high] = rangeOf(numbers);
  const { label } = found;
  if (id === 'exponent') {
    const most = Math.min(MAX_EXPONENT, Math.max(-low, high) || MAX_EXPONENT);
    const clipped = low < -most || high > most ? `${label}, colours end at \u00b1${most}` : label;
    return { label: clipped, numbers, palette: 'around', low: -most, high: most, logarithmic: false };
  }
  const from = id === 'contact' ? 0 : low;
  return { label, numbers, palette: 'rising', low: from, high, logarithmic: false };
}

/// Returns the position of a number between the ends of its palette, 0 to 1.
export function partOf({ low, high, logarithmic }: MapNumbers, number: number): number {
  if (!(high > low)) return 0.5;
  return logarithmic ? Math.log(number / low) / Math.log(high / low) : (number - low) / (high - low);
}
