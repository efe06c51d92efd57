// A row or column of a map as a diagram: the other parameter is assigned.
import type { Diagram } from '../data/diagram';
import { nearestOn, type ParameterMap } from '../data/parameter_map';

export interface Cut {
  /// Another one for every other cut.
  readonly key: string;
  diagram(): Diagram;
  /// "rho = 0.08": where the map is cut, for the reader.
  readonly of: string;
  /// That its points are computed with.
  readonly assignments: readonly string[];
}

/// What is the same number, but for the last digits of a text.
const SAME = 1e-9;

/// "0.08", "650 rad/s", as assignments take it, with all digits.
export function plainText(value: number, unit: string): string {
  return unit === '1' || unit === 'SI' ? String(value) : `${value} ${unit}`;
}

/// The value of a text that `plainText` may have written; undefined where it has another unit.
export function plainValue(text: string, unit: string): number | undefined {
  const [, number = '', of = ''] = /^\s*([-+.\deE]+)\s*(.*?)\s*$/.exec(text) ?? [];
  const plain = unit === '1' || unit === 'SI' ? '' : unit;
  return number !== '' && of === plain && Number.isFinite(Number(number)) ? Number(number) : undefined;
}

/// The cut along a parameter nearest to where the other one has a value, which `text` assigns; without one the case
/// does.
export function cutOf(map: ParameterMap, along: string, value: number, text: string | undefined, unit: string): Cut {
  const { parameter, values } = map.across(along);
  const index = nearestOn(map.across(along), value);
  const there = values[index]!;
  const of = `${parameter} = ${plainText(Number(there.toPrecision(6)), unit)}`;
  const meets = Math.abs(value - there) <= SAME * Math.abs(there);
  const assignments = !meets
    ? [`${parameter}=${plainText(there, unit)}`]
    : text === undefined
      ? []
      : [`${parameter}=${text}`];
  return { key: `${along} ${index} ${assignments.join()}`, diagram: () => map.cut(along, index), of, assignments };
}
