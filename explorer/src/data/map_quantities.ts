// What a map can show of its cells: the regime, the period, and every quantity of diagrams that is one number a point.
import type { StationInfo } from '../engine/protocol';
import type { Units } from '../model/units';
import type { Diagram } from './diagram';
import type { ParameterMap } from './parameter_map';
import { quantitiesOf, quantityOf, type Quantity } from './quantities';
import { FIELD } from './fields';

/// Stronger growth and decay are all shown alike.
const MAX_EXPONENT = 0.5;
const PERIODIC = 1;

/// Numbers of the points as colours show them.
export interface MapNumbers {
  readonly label: string;
  /// [points], NaN where there is none.
  readonly numbers: Float64Array;
  /// What rises, or lies around zero.
  readonly palette: 'rising' | 'around';
  /// What the ends of the palette stand for.
  readonly low: number;
  readonly high: number;
  /// Equal ratios are equally far apart.
  readonly logarithmic: boolean;
}

export const REGIME: Quantity = { id: 'regime', text: 'Regime', perStation: false };
export const ATTRACTOR: Quantity = { id: 'attractor', text: 'Attractor', perStation: false };
const PERIOD: Quantity = { id: 'period', text: 'Period', perStation: false };

/// As they stand in an address; fields are known by their names.
export const MAP_QUANTITIES: readonly string[] = [ATTRACTOR.id, REGIME.id, PERIOD.id];

/// What a map shows where nothing else is asked for.
export function firstQuantityOf(map: ParameterMap): string {
  return map.attractors.length > 0 ? ATTRACTOR.id : REGIME.id;
}

/// Those of which the points have a number.
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

/// Revolutions of periodic motions.
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

/// undefined of regimes, and of what the points do not have.
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
    const clipped = low < -most || high > most ? `${label}, stronger ones alike` : label;
    return { label: clipped, numbers, palette: 'around', low: -most, high: most, logarithmic: false };
  }
  const from = id === 'contact' ? 0 : low;
  return { label, numbers, palette: 'rising', low: from, high, logarithmic: false };
}

/// Where a number lies between the ends of its palette, 0 to 1.
export function partOf({ low, high, logarithmic }: MapNumbers, number: number): number {
  if (!(high > low)) return 0.5;
  return logarithmic ? Math.log(number / low) / Math.log(high / low) : (number - low) / (high - low);
}
