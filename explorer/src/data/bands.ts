// Bands of tolerances: quantiles of a number over all samples, along a parameter (src/report/explorer_bands.c).
import type { Quantity } from './quantities';
import { OF_A_FIELD } from './quantities';
import { FIELD } from './fields';

/// Value of the parameter, and the quantiles of 5, 25, 50, 75 and 95 % there; all in SI, null where it is not known.
export type BandPlace = readonly [
  value: number | null,
  low: number | null,
  quarter: number | null,
  median: number | null,
  threeQuarters: number | null,
  high: number | null,
];

export interface StoredBand {
  readonly parameter: string;
  readonly field: string;
  /// Index of the station or contact.
  readonly which: number;
  readonly column: number;
  readonly samples: number;
  readonly places: readonly BandPlace[];
}

const COLUMNS: Readonly<Record<string, readonly [string, number]>> = {
  radius: [FIELD.ORBIT_MAX_RADIUS, 0],
  eccentricity: [FIELD.ORBIT_ECCENTRICITY, 0],
  contact: [FIELD.RUB_SHARE, 0],
  backward: [FIELD.ORBIT_BACKWARD, 0],
  '1x': [FIELD.SPECTRUM_SYNCHRONOUS, 0],
  '1y': [FIELD.SPECTRUM_SYNCHRONOUS, 1],
};

/// Returns the band of a number over a parameter; undefined without one.
export function bandAt(
  bands: readonly StoredBand[] | undefined,
  parameter: string,
  field: string,
  which: number,
  column: number,
): StoredBand | undefined {
  return bands?.find(
    (band) => band.parameter === parameter && band.field === field && band.which === which && band.column === column,
  );
}

/// Returns the band of a quantity of a diagram.
export function bandOfQuantity(
  bands: readonly StoredBand[] | undefined,
  parameter: string,
  id: Quantity['id'],
  station: number,
): StoredBand | undefined {
  const [name = '', number = '0'] = OF_A_FIELD.test(id) ? id.split(':') : [];
  const [field, column] = COLUMNS[id] ?? [name, Number(number)];
  return field ? bandAt(bands, parameter, field, station, column) : undefined;
}
