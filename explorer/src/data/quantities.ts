// What a diagram can show over the parameter.
import type { StationInfo } from '../engine/protocol';
import { lengthMeasure, type Scales, type Units } from '../model/units';
import type { Column, Diagram } from './diagram';

export interface Quantity {
  /// As it stands in the address of the page.
  readonly id: string;
  readonly text: string;
  /// One of these stations; or of the whole machine.
  readonly perStation: boolean;
}

export const QUANTITIES: readonly Quantity[] = [
  { id: 'x', text: 'x once per revolution', perStation: true },
  { id: 'y', text: 'y once per revolution', perStation: true },
  { id: 'radius', text: 'Largest radius', perStation: true },
  { id: 'eccentricity', text: 'Eccentricity ratio', perStation: true },
  { id: 'contact', text: 'Contact share', perStation: false },
  { id: 'exponent', text: 'Largest exponent', perStation: false },
  { id: 'backward', text: 'Backward whirl share', perStation: true },
];

export interface ShownQuantity {
  readonly column: Column;
  readonly factor: number;
  readonly label: string;
}

/// The numbers of a quantity, how they are scaled and what stands at the axis; undefined where the diagram has none.
export function quantityOf(diagram: Diagram, id: string, station: number, stations: readonly StationInfo[], units: Units, scales: Scales): ShownQuantity | undefined {
  const length = lengthMeasure(units, scales);
  const name = stations[station]?.name ?? '';
  const made = (field: string, which: number, column: number, factor: number, label: string): ShownQuantity | undefined => {
    const found = diagram.column(field, which, column);
    return found && { column: found, factor, label };
  };
  switch (id) {
    case 'x':
    case 'y':
      return made('poincare/section', station, id === 'x' ? 0 : 1, length.factor, `${id} of ${name} (${length.unit})`);
    case 'radius':
      return made('orbit/max_radius', station, 0, length.factor, `largest radius of ${name} (${length.unit} 0-p)`);
    case 'eccentricity':
      return made('orbit/eccentricity', station, 0, 1, `eccentricity ratio of ${name}`);
    case 'contact':
      return diagram.column('rub/share') && { column: { rows: 1, data: Float32Array.from(diagram.values, (_, point) => (diagram.done[point] ? diagram.contact(point) : NaN)) }, factor: 1, label: 'share of the time in contact' };
    case 'exponent':
      return made('lyapunov/largest', 0, 0, 1, 'exponent per revolution') ?? made('regime/exponent', 0, 0, 1, 'exponent per revolution');
    case 'backward':
      return made('orbit/backward', station, 0, 1, `backward whirl of ${name}, share of the time`);
    default:
      return undefined;
  }
}
